#!/usr/bin/env python3
# points.py - a few pixels of POV-Ray's, for machines that have none
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab truth-points FOLDER NAME... >tests/reference/povray.txt
Of each scene that measure.py has drawn in FOLDER: every 40th pixel across and 20th down that is
inner, that is, those around it show POV-Ray the same primitive."""
import os

from . import pictures, scenes

ACROSS, DOWN = 40, 20


def main(folder, *names):
    print("# povray.txt - pixels that POV-Ray 3.7 drew, made by lab/truth/points.py\n"
          "# SPDX-License-Identifier: Apache-2.0\n"
          "# scene depth x y id red green blue")
    paths = dict(scenes.named())
    kinds = {kind.replace(":", ""): kind for kind in scenes.GENERATED}
    for name in names:
        width, height, colours = pictures.ppm(os.path.join(folder, name + ".ppm"))
        flat = pictures.ppm(os.path.join(folder, name + ".ids.png.ppm"))[2]
        ids = [int.from_bytes(flat[i:i + 3], "little") for i in range(0, len(flat), 3)]
        inner = pictures.inner((width, height, colours, ids))
        for y in range(DOWN // 2, height, DOWN):
            for x in range(ACROSS // 2, width, ACROSS):
                i = y * width + x
                if inner[i]:
                    print(paths.get(name, kinds.get(name)), scenes.depth(paths.get(name, "")), x, y,
                          ids[i], *colours[3 * i:3 * i + 3])
