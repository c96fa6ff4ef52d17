#!/usr/bin/env python3
# pictures.py - what a "triple dot product" of normal and light may mean, drawn
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.papers.pictures FILE.ppm
Three spheres, lit from the upper left and before the screen: by n.l, as it is built; by the scalar
triple product of n, l and the direction to the eye, its magnitude, since half of it is negative;
by n.l multiplied three times."""
import math
import sys

SIDE, MARGIN = 120, 8
LIGHT = tuple(c / math.sqrt(3) for c in (-1, 1, 1))
BACK, COLOUR = (60, 72, 86), (0.95, 0.52, 0.15)


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


def main(path):
    body = bytes(c for y in range(SIDE) for meaning in MEANINGS for x in range(SIDE)
                 for c in pixel(meaning, x, y))
    with open(path, "wb") as f:
        f.write(f"P6\n{3 * SIDE} {SIDE}\n255\n".encode() + body)


if __name__ == "__main__":
    main(*sys.argv[1:])
