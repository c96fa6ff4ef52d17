# bench.py - times ways of the golden model against each other, in one run: `make bench`
# SPDX-License-Identifier: Apache-2.0
"""A tree is the default one unless it is named. Each row sets one way against another on the same
scene: how many times longer the other takes, and how many times more node visits and leaf tests it
makes. Best of ROUNDS, the two in turn, one thread unless the row is about threads. Nothing is
asserted: numbers depend on the machine that runs this."""
import json
import os
import subprocess

ROUNDS = 3
SIZE, SMALL = "320x180", "96x54"


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


def render(tool, scene, options):
    size = SMALL if "4096" in scene else SIZE
    words = ["--profile", "standard", "--size", size, "--threads", "1"] + options.split()
    return json.loads(run(tool, "render", scene, *words, "--json", "-"))


def compare(tool, scene, ours, other):
    """Best seconds and counters of both, rendered in turn."""
    best = [None, None]
    for _ in range(ROUNDS):
        for i, options in enumerate((ours, other)):
            report = render(tool, scene, options)
            if best[i] is None or report["seconds"] < best[i]["seconds"]:
                best[i] = report
    return best


def times(a, b):
    return f"{b / a:.2f}" if a and b else "-"


def main(tool, folder):
    os.makedirs(folder, exist_ok=True)
    for n in (256, 4096):
        run(tool, "gen", "random", "--spheres", str(n), "--resolution", SIZE,
            "-o", f"{folder}/random{n}.nff")
    small, large = f"{folder}/random256.nff", f"{folder}/random4096.nff"
    flake, one = "scenes/sphereflake2.nff", "scenes/one_sphere.nff"
    paper = "--tree paper"
    first = paper + " --traverse first"
    rows = [
        ("tree", "every sphere (paper: 7 to 15)", small, "", "--brute"),
        ("tree", "every sphere", large, "", "--brute"),
        ("tree", "paper's tree", small, "", paper),
        ("tree", "paper's tree", large, "", paper),
        ("tree", "balanced tree", small, "", "--tree balanced"),
        ("tree", "balanced tree", large, "", "--tree balanced"),
        ("nearest leaf", "first leaf, paper's tree", small, paper, first),
        ("nearest leaf", "first leaf, paper's tree", large, paper, first),
        ("depth 0", "depth 1", flake, "--depth 0", "--depth 1"),
        ("depth 0", "depth 2", flake, "--depth 0", "--depth 2"),
        ("background rect", "none", one, "--background rect", ""),
        ("two threads", "one", small, "--threads 2", ""),
        ("profile draft", "standard", flake, "--profile draft", ""),
        ("profile draft", "fine", flake, "--profile draft", "--profile fine"),
        ("profile draft", "reference", flake, "--profile draft", "--profile reference"),
    ]
    print(f"{'this':16} {'against':30} {'scene':13} {'ms':>8} {'ms':>8} {'time':>7} {'visits':>7} "
          f"{'leaves':>7}")
    for this, against, scene, ours, other in rows:
        a, b = compare(tool, scene, ours, other)
        x, y = a["counters"], b["counters"]
        print(f"{this:16} {against:30} {os.path.basename(scene)[:-4]:13} {a['seconds'] * 1e3:8.1f} "
              f"{b['seconds'] * 1e3:8.1f} {times(a['seconds'], b['seconds']):>7} "
              f"{times(x['node_visits'], y['node_visits']):>7} "
              f"{times(x['leaf_tests'], y['leaf_tests']):>7}", flush=True)
