# plan.py - lists of jobs: what an engine gets
# SPDX-License-Identifier: Apache-2.0
"""A list is a JSON file: `what` they are, `results`, the folder of store.py, and `jobs`, the most
important first, of

  key       as store.py has it
  command   words; run in the root of the tree it keeps the result, or does nothing if it counts
  cost      seconds of one processor, an estimate
  said      what is shown of it: the key, or what tells it apart

Jobs do not depend on each other."""
import json
import os
import sys

from .. import intact
from . import store


def missing(results, jobs, digests=None):
    """Jobs whose result does not count, and why, job by job."""
    digests = {} if digests is None else digests
    why = [(job, store.look(results, job["key"], digests)[1]) for job in jobs]
    return [(job, reason) for job, reason in why if reason]


def job(results, key, command, guess, said=None):
    """A job that costs what it cost before, else the guess."""
    return {"key": key, "command": list(command), "cost": store.seconds(results, key, guess),
            "said": said or key}


def write(name, results, jobs, what):
    """Writes the list of those that have to be run, and says how many."""
    todo = missing(results, jobs)
    for _, reason in todo:
        if "damaged" in reason:
            print(f"{what}: {reason}, made anew", file=sys.stderr)
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    intact.write(name, json.dumps({"what": what, "results": results, "jobs": [j for j, _ in todo]},
                                  indent=1))
    print(f"{what}: {len(jobs)} jobs, {len(todo)} to run")


def read(name):
    with open(name, encoding="utf-8") as f:
        return json.load(f)
