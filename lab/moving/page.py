# page.py - puts the table of docs/results/moving.md in its place
# SPDX-License-Identifier: Apache-2.0
"""FOLDER is what measure.py left. Clocks are the model's: the slower of visits, a clock each, and
exact tests, a clock for a sphere and ten for the plane; 8 bytes of an upload are a clock too.
Frames a second follow in the page (lab/pages/rates.py)."""
import json
import os
import sys

from . import measure
from ..pages.place import place
from ..synth import report

FACET_CLOCKS, BEAT = 10, 8


class Sequence:
    """Seconds of build and clocks of a mean frame behind the first, and what its pictures are."""
    def __init__(self, folder, *key):
        with open(os.path.join(folder, measure.name(*key)), encoding="utf-8") as file:
            frames = json.load(file)["frames"]
        self.pictures = [f["frame"]["picture_hash"] for f in frames]
        later = frames[1:]

        def mean(values):
            return sum(values) / len(later)
        self.build = mean(f["cpu_seconds"] for f in later)
        self.upload = mean(f["memory_bytes"] for f in later) / BEAT
        pixels = measure.SIZE[0] * measure.SIZE[1]
        self.visits = mean(f["counters"]["node_visits"] for f in later) / pixels
        self.draw = measure.SMALLER ** 2 * mean(
            max(f["counters"]["node_visits"],
                f["counters"]["leaf_tests"] + FACET_CLOCKS * f["counters"]["facet_tests"])
            for f in later)
        self.cost = later[-1]["tree_cost"]
        self.refitted = sum(f["refitted"] for f in later)


def row(folder, number, n, tree):
    built, fitted, ruled = (Sequence(folder, number, n, tree, refit) for refit in measure.REFITS)
    if not built.pictures == fitted.pictures == ruled.pictures:
        sys.exit(f"page: S{number}, {n} spheres, {tree}: refitted trees draw other pictures")
    return [f"S{number}, {n}", tree,
            *(f"{1e3 * x:.1f}" for x in (built.build, fitted.build, ruled.build)),
            *(f"{x / 1e6:.2f}" for x in (built.upload, built.draw)),
            f"{built.visits:.2f}", f"{100 * (fitted.visits / built.visits - 1):.1f}",
            f"{100 * (fitted.cost - 1):.1f}", f"{ruled.refitted} of {measure.FRAMES - 1}"]


def main(page, folder):
    def rows():
        return [row(folder, number, n, tree) for number in measure.SCENARIOS
                for n in measure.SPHERES for tree in measure.TREES]
    head = ["scenario, spheres", "tree", "build, ms", "refit, ms", "build by the rule, ms",
            "upload, million clocks", "draw, million clocks", "visits a pixel", "more refitted, %",
            "cost, %", "auto refits"]
    place(page, "make moving", {"rates": lambda: report.table(head, rows(), 2)})
