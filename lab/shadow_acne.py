# shadow_acne.py - falsely dark pixels of triangles, for docs/design/primitives.md
# SPDX-License-Identifier: Apache-2.0
"""TOOL makes scenes, COUNTER (tests/shadow_acne/main.c) counts, FOLDER keeps the scenes."""
import math
import subprocess
import sys
from pathlib import Path

from .pages.place import place
from .synth.report import table

GENERATED = {"mountain": "mount:4", "ball": "icosphere:4", "cornell": "cornell"}
RULES = ["nearest", "outwards", "guarded"]
HEAD = """v
from {0} {1} {2}
at {3} {4} {5}
up 0 1 0
angle {6}
hither 0.01
resolution 320 180
b 0.1 0.1 0.2
l {7} {8} {9}
f 0.8 0.7 0.6 1 0 0 0 1
"""


def head(*numbers):
    return HEAD.format(*numbers)


def polygon(points):
    return f"p {len(points)}  " + "  ".join("%.9g %.9g %.9g" % p for p in points) + "\n"


def mesh(across, down, point, closed):
    """Triangles between points (i, j), i < across cyclic, j < down; cyclic too if it is closed."""
    text = ""
    for i in range(across):
        for j in range(down if closed else down - 1):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            text += polygon((a, b, c)) if b != a else ""
            text += polygon((a, c, d)) if c != d else ""
    return text


def torus(centre, large, small, across, down, tilt):
    def point(i, j):
        u, v = 2 * math.pi * (i % across) / across, 2 * math.pi * (j % down) / down
        out = large + small * math.cos(v)
        x, y, z = out * math.cos(u), small * math.sin(v), out * math.sin(u)
        a, b = tilt
        y, z = y * math.cos(a) - z * math.sin(a), y * math.sin(a) + z * math.cos(a)
        x, y = x * math.cos(b) - y * math.sin(b), x * math.sin(b) + y * math.cos(b)
        return centre[0] + x, centre[1] + y, centre[2] + z
    return mesh(across, down, point, True)


def box(low, high, turn=0.0):
    mid = [(a + b) / 2 for a, b in zip(low, high)]

    def corner(i, j, k):
        x, y, z = (high if i else low)[0], (high if j else low)[1], (high if k else low)[2]
        x, z = x - mid[0], z - mid[2]
        return (mid[0] + x * math.cos(turn) - z * math.sin(turn), y,
                mid[2] + x * math.sin(turn) + z * math.cos(turn))
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    return "".join(polygon([corner(*(s, *r)) for r in ring]) +
                   polygon([corner(r[0], s, r[1]) for r in ring]) +
                   polygon([corner(*r, s) for r in ring]) for s in (0, 1))


def star(across, down):
    def point(i, j):
        u, v = 2 * math.pi * (i % across) / across, math.pi * j / down
        r = 1.1 if (i % across + j) % 2 and 0 < j < down else 0.6
        if j in (0, down):
            return 0.0, r * (1.0 if j == 0 else -1.0), 0.0
        return (r * math.sin(v) * math.cos(u), r * math.cos(v), r * math.sin(v) * math.sin(u))
    return mesh(across, down + 1, point, False)


def comb(folds, parts):
    """Narrow valleys, a quarter deep."""
    text = ""
    for i in range(folds):
        x = [-1 + (2 * i + k) / folds for k in range(3)]
        for z in range(parts):
            low, high = -1 + 2 * z / parts, -1 + 2 * (z + 1) / parts
            for (a, up), (b, down) in (((x[0], 0), (x[1], .25)), ((x[1], .25), (x[2], 0))):
                text += polygon(((a, up, low), (b, down, low), (b, down, high)))
                text += polygon(((a, up, low), (b, down, high), (a, up, high)))
    return text


def scenes(tool, folder):
    """{name: path}."""
    outside = (2.4, 1.7, 2.1, 0, 0, 0, 40, 3, 5, 2)
    texts = {
        "torus": head(*outside) + torus((0, 0, 0), 1, .4, 48, 24, (.3, .2)),
        "star": head(*outside) + star(24, 13),
        "comb": head(1.2, 2.4, 1.7, 0, 0, 0, 40, 1, 5, 2) + comb(24, 8),
        "room": head(1.6, 1.4, 2.2, -.3, .6, -.8, 70, .4, 2.2, .5) +
        box((-2, 0, -3), (2, 2.5, 3)) + box((-1.3, 0, -1.6), (-.4, .9, -.7), .4) +
        torus((.6, .35, -.6), .5, .2, 32, 16, (.2, .1)),
    }
    found = {"kitchen": Path("scenes/facets/room.nff")}
    for name, text in texts.items():
        found[name] = folder / f"{name}.nff"
        found[name].write_text("# SPDX-License-Identifier: Apache-2.0\n" + text, encoding="utf-8")
    for name, kind in GENERATED.items():
        found[name] = folder / f"{name}.nff"
        subprocess.run([tool, "gen", kind, "-o", found[name]], check=True,
                       stderr=subprocess.DEVNULL)
    return found


def main(tool, shadow_acne, folder, page):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, path in scenes(tool, folder).items():
        for profile in ("draft", "standard"):
            said = subprocess.run([shadow_acne, path, profile], check=True, stdout=subprocess.PIPE,
                                  text=True).stdout
            words = [line.split() for line in said.splitlines()]
            if [w[0] for w in words] != RULES:
                sys.exit(f"shadow_acne: {path}: {said}")
            rows.append([name, profile] + [w[2] for w in words] + [w[4] for w in words])
            print(" ".join(rows[-1]), flush=True)
    names = [f"{what}, {rule}" for what in ("dark", "lit") for rule in RULES]
    place(page, "make shadow-acne", {"shadow_acne": table(["scene", "profile"] + names, rows)})
