# slurm_study.py - a small study for a real Slurm, and its results against those of another engine
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.slurm_study plan TOOL BUILD RESULTS LIST
       python3 -m lab.checks.slurm_study same RESULTS OTHERS"""
import os
import sys

from ..jobs import store
from ..study import points

points.SCENES = ["paper100", "interpenetrating", "huge_tiny"]  # before gather sees them
points.PICTURE = "32x18"

from ..study import gather, tables
from ..sweep import axes, run

TIMES = ("cpu_seconds", "reference_cpu_seconds", "build_seconds")
OF_TIMES = "model"  # the table of the page that has them


def wanted():
    """Jobs of pictures alone, all small."""
    found = [axes.job("accuracy", profile=p, scene=s, size=points.PICTURE)
             for s in points.SCENES for p in points.widths()]
    return found[:len(points.widths()) + 12]


def write(tool, build, results, name):
    run.write(name, tool, build, results, wanted(), "study")


def measured(folder, key):
    """A result without what a clock says."""
    result, why = store.look(folder, key)
    if why:
        sys.exit(f"{folder}: {key}: {why}")
    return {k: v for k, v in result.items() if k not in TIMES}


def same(results, others):
    """Every result is there and the same in both; so are all tables of the page but of times."""
    for key in wanted():
        if measured(results, key) != measured(others, key):
            sys.exit(f"{key}: {measured(results, key)}\nand {measured(others, key)}")
    names = sorted(os.path.basename(store.path("", k)) for k in wanted())
    for folder in results, others:
        if sorted(os.listdir(folder)) != names:
            sys.exit(f"{folder} has {len(os.listdir(folder))} files, not {len(names)}")
    page, other, empty = (tables.everything(gather.Study(folder))
                          for folder in (results, others, "/nowhere"))
    filled = [name for name in page if name != OF_TIMES and page[name] != empty[name]]
    if not filled or any(page[name] != other[name] for name in page if name != OF_TIMES):
        sys.exit(f"tables of the page differ, or are empty: {filled} are filled")
    print(f"{len(names)} results, {len(filled)} tables of the page are the same")


if __name__ == "__main__":
    {"plan": write, "same": same}[sys.argv[1]](*sys.argv[2:])
