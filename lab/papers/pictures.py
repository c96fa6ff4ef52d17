# pictures.py - what a "triple dot product" of normal and light may mean, drawn
# SPDX-License-Identifier: Apache-2.0
"""Three spheres, lit from the upper left and before the screen: by n.l, as it is built; by the
scalar triple product of n, l and the direction to the eye, its magnitude, since half of it is
negative; by n.l multiplied three times."""
import math
import os
import subprocess
from functools import partial
from pathlib import Path

SIDE, MARGIN = 120, 8
LIGHT = tuple(c / math.sqrt(3) for c in (-1, 1, 1))
BACK, COLOUR = (60, 72, 86), (0.95, 0.52, 0.15)
LEVELS = "mended", "rays", "samples"


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def triple(n, light):
    """n . (l x v), where v is (0, 0, 1)."""
    return n[0] * light[1] - n[1] * light[0]


MEANINGS = [lambda n: max(0, dot(n, LIGHT)), lambda n: abs(triple(n, LIGHT)),
            lambda n: max(0, dot(n, LIGHT)) ** 3]


def pixel(meaning, x, y):
    """As bytes of sRGB, by its power of 2.2."""
    rad = SIDE / 2 - MARGIN
    u, v = (x + 0.5 - SIDE / 2) / rad, (SIDE / 2 - y - 0.5) / rad
    if u * u + v * v > 1:
        return BACK
    light = meaning((u, v, math.sqrt(1 - u * u - v * v)))
    return tuple(round(255 * (c * (0.04 + 0.96 * light)) ** (1 / 2.2)) for c in COLOUR)


def mosaic(name, across, *sources, pad=0, then=()):
    """Pictures beside each other; words of oiiotool may stand behind them."""
    subprocess.run(["oiiotool", *sources, f"--mosaic:pad={pad}", across, *then, "-o", name],
                   check=True)


def main(folder, shown):
    """The three meanings, and what measure.py left, as docs/results/papers.md shows them."""
    body = bytes(c for y in range(SIDE) for meaning in MEANINGS for x in range(SIDE)
                 for c in pixel(meaning, x, y))
    with open(f"{folder}/triple.ppm", "wb") as f:
        f.write(f"P6\n{3 * SIDE} {SIDE}\n255\n".encode() + body)
    Path(shown).mkdir(parents=True, exist_ok=True)
    at = partial(os.path.join, folder)
    subprocess.run(["oiiotool", at("triple.ppm"), "-o", f"{shown}/triple.png"], check=True)
    mosaic(f"{shown}/hidden.png", "2x1", at("hidden-first.png"), at("hidden-mended.png"))
    mosaic(f"{shown}/scenes.png", "2x1", at("paper5.png"), at("paper100-mended.png"))
    mosaic(f"{shown}/scenarios.png", "3x1", *(at(f"scenario{n}.png") for n in (1, 2, 3)), pad=4)
    mosaic(f"{shown}/levels.png", "3x1", *(at(f"levels-{way}.exr") for way in LEVELS),
           "--resize:filter=box", "240x135", pad=4,
           then=["--ch", "R,G,B", "--colorconvert", "linear", "sRGB", "-d", "uint8"])
