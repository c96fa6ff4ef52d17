# moving.py - the thesis's scenarios with all spheres moving: build, upload and draw, frame by frame
# SPDX-License-Identifier: Apache-2.0
"""measure() leaves NAME.json in a folder for each sequence: what `sphaera render --frames` reports.
A result younger than the tool is kept. Building has one thread: its processor time is its time.
page() puts the table of docs/results/trees.md in its place. Clocks are the model's: the slower of
visits, a clock each, and exact tests, a clock for a sphere and ten for the plane; 8 bytes of an
upload are a clock too. Frames a second follow in the page (lab/pages/rates.py)."""
import json
import os
import subprocess
import sys

from .pages.place import place
from .runner import Runner
from .synth import report
from .tree_options import options

SCENARIOS = [1, 2, 3]
SPHERES = [100, 1000, 10000, 100000]
TREES = {"reinserted": "reinserted", "balanced": "balanced", "BIH": "bih"}  # title: tree
REFITS = ["off", "on", "auto"]
PROFILES = {100000: "fine"}  # the grid of standard, of all others, merges some of so many
FRAMES = 6
SMALLER = 4  # each side of the thesis's 640 x 1088: a pixel stands for 16
SIZE = (160, 272)
FACET_CLOCKS, BEAT = 10, 8


def scene(runner, number, n):
    """The spheres fill as much of the cube whatever their number, and go a tenth of their radius
    in a frame, each its own way."""
    made, radius = f"scenario{number}-{n}.nff", 8 / n ** (1 / 3)
    if not runner.fresh(made):
        runner.run("gen", f"scenario{number}", "-n", n, "--radius", f"{radius:.4f}", "--plain",
                   "--drift", f"{radius / 10:.5f}", "-o", runner.path(made))
    return runner.path(made)


def name(number, n, tree, refit):
    return f"{number}-{n}-{tree}-{refit}.json"


def run(runner, number, n, tree, refit):
    target = runner.path(name(number, n, tree, refit))
    if runner.fresh(name(number, n, tree, refit)):
        return
    print("  RUN ", os.path.basename(target), flush=True)
    done = subprocess.run(
        [runner.tool, "render", scene(runner, number, n), "--profile",
         PROFILES.get(n, "standard"), *options(TREES[tree]),
         "--refit", refit, "--depth", "0", "--shadow", "off", "--size", f"{SIZE[0]}x{SIZE[1]}",
         "--frames", f"0..{FRAMES - 1}", "-t", "1", "--json", target],
        preexec_fn=lambda: os.sched_setaffinity(0, [min(os.sched_getaffinity(0))]),
        check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(f"moving: {target}: {done.stderr}")


def measure(tool, folder):
    runner = Runner(tool, folder)
    for number in SCENARIOS:
        for n in SPHERES:
            for tree in TREES:
                for refit in REFITS:
                    run(runner, number, n, tree, refit)


class Sequence:
    """Seconds of build and clocks of a mean frame behind the first, and what its pictures are."""
    def __init__(self, folder, *key):
        with open(os.path.join(folder, name(*key)), encoding="utf-8") as file:
            frames = json.load(file)["frames"]
        self.pictures = [f["frame"]["picture_hash"] for f in frames]
        later = frames[1:]

        def mean(values):
            return sum(values) / len(later)
        self.build = mean(f["cpu_seconds"] for f in later)
        self.upload = mean(f["memory_bytes"] for f in later) / BEAT
        pixels = SIZE[0] * SIZE[1]
        self.visits = mean(f["counters"]["node_visits"] for f in later) / pixels
        self.draw = SMALLER ** 2 * mean(
            max(f["counters"]["node_visits"],
                f["counters"]["leaf_tests"] + FACET_CLOCKS * f["counters"]["facet_tests"])
            for f in later)
        self.cost = later[-1]["tree_cost"]
        self.refitted = sum(f["refitted"] for f in later)


def row(folder, number, n, tree):
    built, fitted, ruled = (Sequence(folder, number, n, tree, refit) for refit in REFITS)
    if not built.pictures == fitted.pictures == ruled.pictures:
        sys.exit(f"moving: S{number}, {n} spheres, {tree}: refitted trees draw other pictures")
    return [f"S{number}, {n}", tree,
            *(f"{1e3 * x:.1f}" for x in (built.build, fitted.build, ruled.build)),
            *(f"{x / 1e6:.2f}" for x in (built.upload, built.draw)),
            f"{built.visits:.2f}", f"{100 * (fitted.visits / built.visits - 1):.1f}",
            f"{100 * (fitted.cost - 1):.1f}", f"{ruled.refitted} of {FRAMES - 1}"]


def page(name_of, folder):
    def rows():
        return [row(folder, number, n, tree) for number in SCENARIOS
                for n in SPHERES for tree in TREES]
    head = ["scenario, spheres", "tree", "build, ms", "refit, ms", "build by the rule, ms",
            "upload, million clocks", "draw, million clocks", "visits a pixel", "more refitted, %",
            "cost, %", "auto refits"]
    place(name_of, "make moving", {"moving": lambda: report.table(head, rows(), 2)})
