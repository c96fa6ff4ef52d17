# run.py - jobs of sweeps: those without a result that counts are run, here or on a cluster
# SPDX-License-Identifier: Apache-2.0
"""RESULTS is the folder of results (BUILD/sweep/results): put those of several machines together.
ENGINE and JOBS of the environment say what runs them (docs/guide/simulation.md)."""
import os
import subprocess
import sys

from ..jobs import plan, store
from . import axes, measures


def folder(build):
    return os.environ.get("RESULTS") or f"{build}/sweep/results"


def guess(key):
    """Seconds of a job that was never run: of 320x180 pixels, of a core that may have to be made"""
    w = axes.words(key)
    seconds = measures.GUESS[w["measure"]]
    if w["measure"] not in ("counts", "accuracy") or not w["size"]:
        return seconds
    width, height = map(int, w["size"].split("x"))
    return seconds * width * height / (320 * 180)


def write(name, tool, build, results, keys, what):
    """The list of those jobs that have no result, for lab/jobs/run.py."""
    command = [sys.executable, "-m", "lab", "sweep-job", tool, build, results]
    plan.write(name, results,
               [plan.job(results, key, [*command, key], guess(key), axes.short(key))
                for key in keys], what)


def run(tool, build, keys, what):
    """Runs what has no result that counts; how `lab jobs` ended, 0 if all is there."""
    listed = f"{build}/sweep/{what}.jobs"
    write(listed, tool, build, folder(build), keys, what)
    environment = {k: v for k, v in os.environ.items() if k != "MFLAGS"}
    environment["MAKEFLAGS"] = f"-j{os.environ.get('JOBS') or os.cpu_count()}"
    return subprocess.run([sys.executable, "-m", "lab", "jobs", os.environ.get("ENGINE") or "make",
                           listed], check=False, env=environment).returncode


class Results:
    """Results of a folder that count, by key."""

    def __init__(self, results):
        self.folder, self.digests, self.known = results, {}, {}

    def look(self, key):
        if key not in self.known:
            self.known[key] = store.look(self.folder, key, self.digests)[0]
        return self.known[key]


def measured(build, what, measure, points):
    """Of each point, a dictionary of axes, its result, for a page: runs what has none. The end if
    one is missing."""
    keys = [axes.job(measure, **point) for point in points]
    ended = run(f"{build}/sphaera", build, list(dict.fromkeys(keys)), what)
    if ended:
        sys.exit(ended)
    results = Results(folder(build))
    return [results.look(key) for key in keys]
