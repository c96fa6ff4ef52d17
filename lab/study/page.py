#!/usr/bin/env python3
# page.py - puts tables, plots and picture strips of the study into docs/results/accuracy.md
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.study.page [--only-tables] PAGE RESULTS FOLDER [TOOL]
A table of which a result is missing, or does not count, is shown on the terminal with dashes, and
stays as it is in the page; in a plot such a result has no dot. Plots and strips go to
pictures/accuracy beside the folder of PAGE."""
import os
import subprocess
import sys
from functools import partial

from ..pages.place import place
from . import gather, plots, points, run, tables

STRIP, STRIP_SIZE = "paper100", "240x135"


def strips(tool, build, pictures):
    """reference | model | difference, one picture a profile."""
    for profile in points.PROFILES:
        out = os.path.join(pictures, f"strip_{profile}.png")
        subprocess.run([tool, "accuracy", run.scene_file(tool, build, STRIP), "--profile", profile,
                        "--size", STRIP_SIZE, "-d", out], check=True,
                       stdout=subprocess.DEVNULL)


def main(argv):
    bare = "--only-tables" in argv
    argv = [word for word in argv if word != "--only-tables"]
    if len(argv) not in (3, 4):
        sys.exit(__doc__)
    page, results, folder = argv[:3]
    study = gather.Study(results)
    run_of = study.get(gather.keys.job("cells", **gather.core_of("standard")))
    place(page, "make study", {name: partial(table, study)
                               for name, table in tables.TABLES.items()},
          run_of and run_of["yosys"])
    os.makedirs(folder, exist_ok=True)
    drawn = []
    if not bare:
        pictures = os.path.join(os.path.dirname(page), "../pictures/accuracy")
        os.makedirs(pictures, exist_ok=True)
        drawn = plots.everything(study, pictures, folder)
        if len(argv) == 4:
            strips(argv[3], os.path.dirname(folder), pictures)
    there = [k for k in points.plan() if study.get(k)]
    print(f"study: {len(there)} of {len(points.plan())} results in {page}, "
          f"{len(drawn)} plots: {' '.join(drawn) or 'none'}")


if __name__ == "__main__":
    main(sys.argv[1:])
