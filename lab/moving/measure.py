# measure.py - sequences of the thesis's scenarios with all spheres moving, each once
# SPDX-License-Identifier: Apache-2.0
"""Leaves NAME.json in FOLDER for each sequence: what `sphaera render --frames` reports. A result
younger than the tool is kept. Building has one thread: its processor time is its time."""
import os
import subprocess
import sys

from ..tree_options import options

SCENARIOS = [1, 2, 3]
SPHERES = [100, 1000, 10000, 100000]
TREES = {"reinserted": "reinserted", "balanced": "balanced", "BIH": "bih"}  # title: tree
REFITS = ["off", "on", "auto"]
PROFILES = {100000: "fine"}  # the grid of standard, of all others, merges some of so many
FRAMES = 6
SMALLER = 4  # each side of the thesis's 640 x 1088: a pixel stands for 16
SIZE = (160, 272)


def scene(tool, folder, number, n):
    """The spheres fill as much of the cube whatever their number, and go a tenth of their radius
    in a frame, each its own way."""
    path = os.path.join(folder, f"scenario{number}-{n}.nff")
    radius = 8 / n ** (1 / 3)
    if not fresh(tool, path):
        subprocess.run([tool, "gen", f"scenario{number}", "-n", str(n), "--radius", f"{radius:.4f}",
                        "--plain", "--drift", f"{radius / 10:.5f}", "-o", path], check=True,
                       stderr=subprocess.DEVNULL)
    return path


def fresh(tool, path):
    return os.path.exists(path) and os.path.getmtime(path) > os.path.getmtime(tool)


def name(number, n, tree, refit):
    return f"{number}-{n}-{tree}-{refit}.json"


def run(tool, folder, number, n, tree, refit):
    target = os.path.join(folder, name(number, n, tree, refit))
    if fresh(tool, target):
        return
    print("  RUN ", os.path.basename(target), flush=True)
    done = subprocess.run(
        [tool, "render", scene(tool, folder, number, n), "--profile",
         PROFILES.get(n, "standard"), *options(TREES[tree]),
         "--refit", refit, "--depth", "0", "--shadow", "off", "--size", f"{SIZE[0]}x{SIZE[1]}",
         "--frames", f"0..{FRAMES - 1}", "-t", "1", "--json", target],
        preexec_fn=lambda: os.sched_setaffinity(0, [min(os.sched_getaffinity(0))]),
        check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(f"measure: {target}: {done.stderr}")


def main(tool, folder):
    os.makedirs(folder, exist_ok=True)
    for number in SCENARIOS:
        for n in SPHERES:
            for tree in TREES:
                for refit in REFITS:
                    run(tool, folder, number, n, tree, refit)
