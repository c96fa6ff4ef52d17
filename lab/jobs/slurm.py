# slurm.py - jobs as Slurm job arrays: chunks out, results in, until none is missing
# SPDX-License-Identifier: Apache-2.0
"""A round submits the jobs whose result does not count, in chunks (cut()), and waits until all
results are there, or a last job, which Slurm starts when the arrays have ended however they did,
has left the file `ended`. Nobody asks Slurm what became of a job: files alone count, each looked at
with its digest. What a killed node, a full disk or a time limit took is missing, and is in the next
round; so is what was damaged. Two rounds without any new result end it.

LIST.slurm/ROUND/ has the scripts of a round and what its chunks printed. Options of Slurm are in
the environment, as sbatch reads them: SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT."""
import os
import shlex
import shutil
import subprocess
import sys
import time

from .. import tasks
from . import plan, store

LEAST, MOST = 30.0, 60.0  # seconds of a chunk
ARRAY = 1000     # chunks of an array; Slurm takes 1001 unless its MaxArraySize is another
FRUITLESS = 2    # rounds without a new result, then it ends
POLL = 2.0       # seconds between two looks at the folder


def cut(jobs, least=LEAST, most=MOST):
    """Lists of jobs, together all of them. Each costs `least` to `most`, but for one that may cost
    less, and for a job that by itself costs more. Jobs keep their order as far as that allows."""
    done, open_ones = [], []
    for job in jobs:
        cost = max(float(job["cost"]), 0)
        room = next((c for c in open_ones if c[0] + cost <= most), None)
        if room is None:
            room = [0.0, []]
            done.append(room)
            open_ones.append(room)
        room[0] += cost
        room[1].append(job)
        if room[0] >= least:
            open_ones.remove(room)
    return [c[1] for c in done]


def put(name, text):
    with open(name, "w", encoding="utf-8") as f:
        f.write(text)
    os.chmod(name, 0o755)


def submit(script, *options):
    """Number of the Slurm job; exits with sbatch's message if it takes none."""
    try:
        ran = subprocess.run(["sbatch", "--parsable", *options, script], env=tasks.clean(),
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             check=False)
    except FileNotFoundError:
        sys.exit("ENGINE=slurm: there is no sbatch here; make slurm-setup installs Slurm")
    if ran.returncode:
        sys.exit(f"ENGINE=slurm: sbatch: {ran.stderr.strip()}")
    return ran.stdout.strip().split(";")[0]


def send(folder, chunks):
    """Submits the chunks; numbers of the Slurm jobs, the last of them leaves `ended`."""
    root, numbers = os.getcwd(), []
    for first in range(0, len(chunks), ARRAY):
        part = chunks[first:first + ARRAY]
        for n, chunk in enumerate(part, first + 1):
            commands = "".join(f"{shlex.join(job['command'])} || echo {shlex.quote(job['key'])}: "
                               "failed\n" for job in chunk)
            put(f"{folder}/chunk{n}.sh", f"#!/bin/sh\ncd {shlex.quote(root)} || exit 1\n{commands}")
        start = f"{folder}/start{first}.sh"
        put(start, "#!/bin/sh\nexec sh "
                   f"{shlex.quote(folder)}/chunk$(({first} + SLURM_ARRAY_TASK_ID)).sh\n")
        numbers.append(submit(start, f"--array=1-{len(part)}", "--job-name=sphaera",
                              "--requeue", "--open-mode=append", "--ntasks=1", "--cpus-per-task=1",
                              f"--output={folder}/log-%A_%a"))
    put(f"{folder}/last.sh", f"#!/bin/sh\n: >{shlex.quote(folder)}/ended\n")
    numbers.append(submit(f"{folder}/last.sh", "--dependency=afterany:" + ":".join(numbers),
                          "--job-name=sphaera-ended", "--requeue", "--ntasks=1",
                          f"--output={folder}/log-ended"))
    return numbers


def stamp(name):
    try:
        about = os.stat(name)
        return about.st_mtime_ns, about.st_size
    except OSError:
        return None


def wait(folder, results, jobs):
    """Returns when each job's result is there, or the round has ended. A file is read again only
    when it has changed."""
    left, seen, digests = {job["key"] for job in jobs}, {}, {}
    last = False
    while left:
        last = os.path.exists(f"{folder}/ended")
        for key in sorted(left):
            now = stamp(store.path(results, key))
            if now and seen.get(key) != now:
                seen[key] = now
                if store.look(results, key, digests)[1] is None:
                    left.discard(key)
        if last or not left:
            return
        time.sleep(POLL)


def rounds(name, listed):
    """Round after round; the jobs whose result is still missing."""
    jobs, results, fruitless = listed["jobs"], listed["results"], 0
    what, number = listed["what"], 0
    todo = plan.missing(results, jobs)
    while todo and fruitless < FRUITLESS:
        number += 1
        folder = os.path.abspath(f"{name}.slurm/{number}")
        os.makedirs(folder)
        chunks = cut([job for job, _ in todo])
        print(f"{what}: round {number}: {len(todo)} jobs in {len(chunks)} chunks, {folder}",
              flush=True)
        numbers = send(folder, chunks)
        try:
            wait(folder, results, [job for job, _ in todo])
        finally:  # of what still runs, its results are there, or nobody waits any more
            subprocess.run(["scancel", "--quiet", *numbers], check=False,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        before, todo = len(todo), plan.missing(results, jobs)
        for job, reason in todo:
            print(f"{what}: {job['key']}: {reason}", flush=True)
        fruitless = fruitless + 1 if len(todo) >= before else 0
    return todo


def run(name, listed):
    """Exit code: 0, or 1 if results are missing in the end."""
    shutil.rmtree(f"{name}.slurm", ignore_errors=True)
    todo = rounds(name, listed)
    if todo:
        print(f"{listed['what']}: {len(todo)} of {len(listed['jobs'])} results are missing; what "
              f"their jobs printed: {name}.slurm/*/log-*", file=sys.stderr)
    return 1 if todo else 0
