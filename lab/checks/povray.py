# povray.py - the double reference at pixels that POV-Ray drew
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab povray TOOL FOLDER TABLE
Draws each scene of TABLE (lab/truth/points.py) with `TOOL reference --unlimited`, and exits with 1
if an object is another one or a colour is off by more than MOST of 255."""
import os
import subprocess
from itertools import groupby

from ..truth import pictures, scenes

MOST = 2  # a linear 8-bit colour of each, rounded


def draw(tool, folder, scene, depth):
    """The frame of a scene file or of a kind of `gen`."""
    path, to = scene, os.path.join(folder, "points.frame")
    if not os.path.exists(scene.rpartition(":")[0] or scene):
        path = os.path.join(folder, "points.nff")
        subprocess.run([tool, "gen", scene, "-o", path], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([tool, "reference", path, "--unlimited", "--depth", depth, *scenes.FILTER,
                    "--size", "%dx%d" % scenes.SIZE, "--frame", to], check=True,
                   stdout=subprocess.DEVNULL)
    return pictures.frame(to)


def main(tool, folder, table):
    with open(table, encoding="utf-8") as f:
        rows = [line.split() for line in f if not line.startswith("#")]
    wrong = 0
    for (scene, depth), points in groupby(rows, key=lambda row: row[:2]):
        width, _, colours, ids = draw(tool, folder, scene, depth)
        for x, y, number, *rgb in ([int(word) for word in row[2:]] for row in points):
            i = y * width + x
            mine = list(colours[3 * i:3 * i + 3])
            if ids[i] != number or max(abs(a - b) for a, b in zip(mine, rgb)) > MOST:
                print(f"{scene} depth {depth}, x {x} y {y}: primitive {ids[i]}, colour {mine}; "
                      f"POV-Ray has {number}, {rgb}")
                wrong += 1
    print(f"{len(rows)} pixels, {wrong} wrong")
    return 1 if wrong or not rows else 0
