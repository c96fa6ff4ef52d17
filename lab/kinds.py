# kinds.py - kinds of trees beside each other: `make kinds`
# SPDX-License-Identifier: Apache-2.0
"""Runs `sphaera trees` and puts its figures into the table `kinds` of PAGE. A scene behind the word
gen is made for it."""
import json
import os
import subprocess
import sys
import tempfile

from .pages.place import place
from .synth import report

SIZE = "320x180"
BESIDE = {"boxes": "boxes", "kd": "boxes"}  # whose times are told as those of another tree
SCENES = [("`paper100`", "scenes/paper100.nff"), ("random:4096", "gen random:4096"),
          ("sphereflake:3", "gen sphereflake:3"), ("`facets/room`", "scenes/facets/room.nff"),
          ("`texture/kitchen`", "scenes/texture/kitchen.nff")]


def run(tool, *words):
    done = subprocess.run([tool, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False)
    if done.returncode:
        sys.exit(f"kinds: {' '.join(words)}: {done.stderr}")
    return done.stdout


def measured(tool, folder, name, source):
    """The rows of a scene, a tree each."""
    scene = source
    if source.startswith("gen "):
        scene = os.path.join(folder, "scene.nff")
        run(tool, *source.split(), "-o", scene)
    found = json.loads(run(tool, "trees", scene, "--profile", "standard", "--size", SIZE,
                           "--json", "-"))
    trees = {tree["tree"]: tree for tree in found["trees"]}
    for tree in trees.values():
        rays, one = tree["rays"], trees[BESIDE.get(tree["tree"], "bih")]
        build, draw = (report.times(tree[what] / one[what]) for what in ("build_seconds",
                                                                         "draw_seconds"))
        yield [name, tree["tree"], tree["nodes"], tree["node_bytes"], tree["bytes"],
               f"{tree['steps'] / rays:.2f}", f"{tree['tests'] / rays:.2f}", build, draw]


def main(tool, page):
    with tempfile.TemporaryDirectory() as folder:
        rows = [row for scene in SCENES for row in measured(tool, folder, *scene)]
    place(page, "make kinds", {"kinds": report.table(
        ["scene", "tree", "nodes", "bytes a node", "bytes", "steps", "tests", "build", "draw"],
        rows, 2)})
