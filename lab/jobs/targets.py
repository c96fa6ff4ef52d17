# targets.py - files of make, or of an experiment, as jobs: one each
# SPDX-License-Identifier: Apache-2.0
"""A job is `make TARGET`, or that file of the experiment WHAT; its result holds the digest of the
file, and counts while the files of the PATTERNs are the same. Targets of one list do not need each
other; what they need is there. What counts gets the time of now, so that it is taken to be as new
as it is."""
import os
import subprocess
import sys
import time

from .. import table, tasks
from . import plan, store

GUESS = 10  # seconds


def write(what, build, results, name, patterns, *targets):
    command = ["python3", "-m", "lab", "target-job", build, results]
    jobs = [plan.job(results, f"{what} {t}", [*command, f"{what} {t}", patterns], GUESS)
            for t in targets]
    left = {job["key"] for job, _ in plan.missing(results, jobs)}
    for target in targets:
        if f"{what} {target}" not in left:
            os.utime(target)
    plan.write(name, results, jobs, what)


def one(build, results, key, patterns):
    """A file that lies there may be half of one: it is made anew."""
    if store.look(results, key)[1] is None:
        return
    target, began = key.split(" ", 1)[1], time.monotonic()
    if os.path.exists(target):
        os.remove(target)
    what = key.split(" ", 1)[0]
    if what in (row.name for row in table.EXPERIMENTS if row.files):
        command = [sys.executable, "-m", "lab", what, "--build", build, "--file", target]
    else:
        command = ["make", "--no-print-directory", f"B={build}", "JOBS=1", target]
    ran = subprocess.run(command, env=tasks.clean() | {"JOBS": "1"}, check=False)
    if ran.returncode or not os.path.exists(target):
        sys.exit(f"{target} was not made")
    store.save(results, key, patterns.split(","), True, time.monotonic() - began, [target])
