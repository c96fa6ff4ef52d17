# page.py - puts tables, plots and picture strips of the study into docs/results/accuracy.md
# SPDX-License-Identifier: Apache-2.0
"""A table of which a result is missing, or does not count, is shown on the terminal with dashes,
and stays as it is in the page; in a plot such a result has no dot. Plots and strips go to
pictures/accuracy beside the folder of PAGE."""
import os
import subprocess
from functools import partial

from ..pages.place import place
from ..sweep import measures
from . import gather, plots, points, tables

STRIP, STRIP_SIZE = "paper100", "240x135"


def strips(tool, build, pictures):
    """reference | model | difference, one picture a profile."""
    for profile in points.PROFILES:
        out = os.path.join(pictures, f"strip_{profile}.png")
        scene = measures.scene_file(tool, build, STRIP)
        subprocess.run([tool, "accuracy", scene, "--profile", profile, "--size", STRIP_SIZE, "-d",
                        out], check=True,
                       stdout=subprocess.DEVNULL)


def main(page, results, folder, tool=None, only_tables=False):
    study = gather.Study(results)
    run_of = study.get(gather.axes.job("cells", **gather.core_of("standard")))
    place(page, "make study", {name: partial(table, study)
                               for name, table in tables.TABLES.items()},
          run_of and run_of["yosys"])
    os.makedirs(folder, exist_ok=True)
    drawn = []
    if not only_tables:
        pictures = os.path.join(os.path.dirname(page), "../pictures/accuracy")
        os.makedirs(pictures, exist_ok=True)
        drawn = plots.everything(study, pictures, folder)
        if tool:
            strips(tool, os.path.dirname(folder), pictures)
    there = [k for k in points.plan() if study.get(k)]
    print(f"study: {len(there)} of {len(points.plan())} results in {page}, "
          f"{len(drawn)} plots: {' '.join(drawn) or 'none'}")
