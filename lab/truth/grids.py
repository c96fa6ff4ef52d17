#!/usr/bin/env python3
# grids.py - what wider coordinates would bring, by scenes rounded to their grids
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab truth-grids TOOL FOLDER SCENE...
For each scene dB against the double reference: of the model in profile `reference`, and of the
double reference of the scene whose centres, radii and corners are rounded to the grid of that
profile (24 bits), and to grids of 26, 28 and 32 bits. Prints rows of a table; a line of the scene
is a primitive, or a corner of the last one, as `sphaera` writes them."""
import json
import math
import os
import re
import subprocess
from pathlib import Path

from . import doubt, pictures, scenes

WIDTHS = 24, 26, 28, 32


def rounded(scene, to, step):
    """Writes the scene with its coordinates rounded to whole steps along the camera's axes."""
    text = Path(scene).read_text(encoding="utf-8")
    view = doubt.camera(text)
    back = doubt.unit([a - b for a, b in zip(view["from"], view["at"])])
    right = doubt.unit(doubt.cross(view["up"], back))
    axes = [right, doubt.cross(back, right), back]

    def near(number):
        return step * math.floor(number / step + 0.5)

    def point(p):
        grid = [near(doubt.dot([a - e for a, e in zip(p, view["from"])], axis)) for axis in axes]
        return [e + sum(g * axis[i] for g, axis in zip(grid, axes))
                for i, e in enumerate(view["from"])]
    left, lines = 0, []  # left: numbers of corners that are still to come
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words and words[0] == "s":
            ball = [float(word) for word in words[1:5]]
            line = " ".join(map(repr, ["s", *point(ball[:3]), near(ball[3])])).replace("'", "")
        elif words and words[0] in ("p", "tt"):
            left, each = (3 * int(words[1]), 3) if words[0] == "p" else (15, 5)
        elif words and left and re.match(r"[-+.\d]", words[0]):
            found = [float(word) for word in words]
            moved = []
            for i in range(0, len(found), each):
                moved += point(found[i:i + 3]) + found[i + 3:i + each]
            line, left = " ".join(map(repr, moved)), left - len(found)
        lines.append(line)
    Path(to).write_text("\n".join(lines) + "\n", encoding="utf-8")


def main(tool, folder, *names):
    os.makedirs(folder, exist_ok=True)
    to, report = os.path.join(folder, "grids.frame"), os.path.join(folder, "grids.json")

    def drawn(*words):
        subprocess.run([tool, *words, *scenes.FILTER, "--size", "%dx%d" % scenes.SIZE, "--depth",
                        "2", "--frame", to], stdout=subprocess.DEVNULL, check=True)
        return pictures.frame(to)
    for scene in names:
        truth = drawn("reference", scene)
        model = drawn("accuracy", scene, "--profile", "reference", "--json", report)
        step = json.loads(Path(report).read_text(encoding="utf-8"))["machine"]["grid_step"]
        cells = [pictures.decibel(truth, model)]
        for width in WIDTHS:
            moved = os.path.join(os.path.dirname(scene), f".{Path(scene).stem}.rounded.nff")
            try:
                rounded(scene, moved, math.ldexp(step, 24 - width))
                cells.append(pictures.decibel(truth, drawn("reference", moved)))
            finally:
                os.remove(moved)
        said = (f"{cell:.1f}" if cell is not None else "equal" for cell in cells)
        print(f"| {Path(scene).stem} | {' | '.join(said)} |", flush=True)
