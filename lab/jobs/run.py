# run.py - runs the jobs of a list: engine make on this machine, engine slurm on a cluster
# SPDX-License-Identifier: Apache-2.0
"""LIST as plan.py writes it. Exit code 0: each result is there and counts."""
import os
import shlex
import signal
import sys

from .. import intact
from . import plan, slurm


def by_make(name, jobs):
    """A makefile with a target for each job: JOBS of them run at once. Does not return."""
    targets = [f"job{i}" for i in range(len(jobs))]
    lines = ["# written by lab/jobs/run.py: the most important job first",
             ".PHONY: all " + " ".join(targets), "all: " + " ".join(targets)]
    for target, job in zip(targets, jobs):
        command, said = (shlex.join(words).replace("$", "$$") for words in
                         (job["command"], [job["said"]]))
        lines += [f"{target}:", f"\t@printf '  %-4s %s\\n' JOB {said}", f"\t@{command}"]
    intact.write(name + ".mk", "\n".join(lines) + "\n")
    sys.stdout.flush()
    os.execvp("make", ["make", "--no-print-directory", "-k", "-f", name + ".mk"])


def main(engine, name):
    if engine not in ("make", "slurm"):
        sys.exit(f"ENGINE={engine}: there are make and slurm")
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return run(engine, name)
    except KeyboardInterrupt:
        sys.exit("broken off: the same command goes on from here")


def run(engine, name):
    listed = plan.read(name)
    if not listed["jobs"]:
        return 0
    if engine == "make":
        by_make(name, listed["jobs"])
    return slurm.run(name, listed)
