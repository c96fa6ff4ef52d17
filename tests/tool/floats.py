"""floats.py - what must hold of a report of `sphaera floats` and of its picture
SPDX-License-Identifier: Apache-2.0

usage: floats.py sums REPORT RENDER             as many tests and rays as `render` counts, and as
                                                many wrong pixels as wrong primary rays
       floats.py picture REPORT FILE.ppm        red and orange as counted, all else grey
       floats.py marks FILE.ppm SHEET.ppm       red in the same pixels as in the last field of a
                                                sheet of `make hard-pictures`
       floats.py holds REPORT EXPRESSION        of r, each kind of rays, of primary rays alone what
                                                there is, f32 and f64, and of pixels
"""
import json
import sys

RED, ORANGE, MARK = (255, 0, 0), (255, 160, 0), (255, 32, 32)
SCALE, GAP = 2, 4  # of a sheet: tests/hard/pictures/main.c


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def rows(path):
    """The pixels of a PPM, row by row."""
    with open(path, "rb") as file:
        data = file.read()
    head = data.split(maxsplit=4)
    width, height = int(head[1]), int(head[2])
    bytes_ = data[-3 * width * height:]
    return [[tuple(bytes_[3 * (y * width + x):][:3]) for x in range(width)] for y in range(height)]


def sums(report, render):
    kinds, counts = load(report)["floats"], load(render)["counters"]
    tests = sum(kind["all"]["tests"] for kind in kinds.values())
    assert tests == counts["leaf_tests"] + counts["facet_tests"], (tests, counts)
    for name, kind in kinds.items():
        every = kind["all"]
        assert every["rays"] == counts["rays_" + name], (name, every)
        assert every["rules"] + every["roots"] <= every["tests"], (name, every)
        for bits in ("float32", "float64"):
            wrong = kind[bits]
            assert wrong["pairs"] + wrong["equal"] <= every["pairs"], (name, kind)
            assert wrong["hits"] + wrong["roots"] <= every["tests"] - every["rules"], (name, kind)
            if name == "primary":
                assert load(report)["pixels"][bits] == wrong["rays"], kind


def picture(report, path):
    pixels, all_ = load(report)["pixels"], [p for row in rows(path) for p in row]
    assert all_.count(ORANGE) == pixels["float64"], pixels
    assert all_.count(RED) == pixels["float32"] - pixels["both"], pixels
    assert all(p in (RED, ORANGE) or p[0] == p[1] == p[2] for p in all_)


def marks(path, sheet):
    ours, theirs = rows(path), rows(sheet)
    at = 3 * (SCALE * len(ours[0]) + GAP)
    for y, row in enumerate(ours):
        for x, p in enumerate(row):
            assert (p == RED) == (theirs[SCALE * y][at + SCALE * x] == MARK), (x, y)


def holds(report, expression):
    r = load(report)
    first = r["floats"]["primary"]
    names = {"r": r["floats"], "pixels": r["pixels"], "there": first["all"],
             "f32": first["float32"], "f64": first["float64"]}
    assert eval(expression, names), r  # pylint: disable=eval-used


if __name__ == "__main__":
    {"sums": sums, "picture": picture, "marks": marks, "holds": holds}[sys.argv[1]](*sys.argv[2:])
