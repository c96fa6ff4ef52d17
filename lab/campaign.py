#!/usr/bin/env python3
# campaign.py - a campaign of hard cases as jobs: parts of it, and one state file of all of them
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab hard-campaign plan HARD RESULTS LIST OPTION...
       python3 -m lab hard-campaign one HARD RESULTS KEY
       python3 -m lab hard-campaign merge HARD RESULTS STATE OPTION...
HARD is the program, OPTIONs are those that say which campaign it is. The result of a job is the
state file of its part; STATE has them all, and `HARD OPTION... --state STATE` then tells the rest.
"""
import os
import subprocess
import sys
import tempfile
import time

from .jobs import plan, slurm, store
from .sweep.measures import MODEL

SOURCES = [*MODEL, "tests/hard/*.[ch]", "tool:gcc"]
RATE = 500000        # cases a second of a processor, about
EXHAUSTIVE = 84e6    # cases of all operands of three bits, about
LEAST_PARTS = 4      # as many chunks as the smallest campaign has


def keys(options):
    """A key for each part; how many there are depends on the campaign alone."""
    given = dict(zip(options[::2], options[1::2]))
    cases = 4 * float(given["--cases"]) + EXHAUSTIVE * (given.get("--exhaustive") != "0")
    parts = max(LEAST_PARTS, -int(-cases // (RATE * slurm.LEAST)))
    return [" ".join(["hard", *options, "--part", f"{p}/{parts}"]) for p in range(parts)], \
        cases / RATE / parts


def write(hard, results, name, *options):
    found, guess = keys(options)
    command = ["python3", "-m", "lab", "hard-campaign", "one", hard, results]
    plan.write(name, results, [plan.job(results, k, [*command, k], guess) for k in found], "hard")


def one(hard, results, key):
    if store.look(results, key)[1] is None:
        return
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="sphaera-hard-") as folder:
        ran = subprocess.run([hard, *key.split()[1:], "--state", f"{folder}/state"], check=False)
        if ran.returncode not in (0, 1):  # 1: ours is wrong somewhere, which the state has
            sys.exit(ran.returncode)
        with open(f"{folder}/state", encoding="utf-8") as f:
            state = f.read()
    store.save(results, key, SOURCES, {"state": state}, time.monotonic() - began)


def merge(hard, results, name, *options):
    with tempfile.TemporaryDirectory(prefix="sphaera-hard-") as folder:
        files, digests = [], {}
        for number, key in enumerate(keys(options)[0]):
            result, why = store.look(results, key, digests)
            if why:
                sys.exit(f"hard: {key}: {why}")
            files.append(os.path.join(folder, str(number)))
            with open(files[-1], "w", encoding="utf-8") as f:
                f.write(result["state"])
        sys.exit(subprocess.run([hard, *options, "--state", name, "--merge", *files],
                                check=False).returncode)


def main(command, *words):
    {"plan": write, "one": one, "merge": merge}[command](*words)
