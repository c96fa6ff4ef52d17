# scenes.py - scenes that the papers' claims are tried on, made by formula
# SPDX-License-Identifier: Apache-2.0
"""Each function returns the lines of an NFF file."""
import math
import re

IMAGE = "parquet.png"       # of scenes/texture, beside the scene
HEAD = """v
from 0 0 {eye}
at 0 0 0
up 0 1 0
angle {angle}
hither 0.01
resolution 160 90
b 0.0625 0.09375 0.125
l {light} 1 1 1"""


def head(eye, angle, light):
    return HEAD.format(eye=eye, angle=angle, light=light).split("\n")


def column(n):
    """Spheres in a row that leads away from the eye, to the right and up, each touching the next:
    neighbours by z are neighbours in space. The view has those about the middle, a dozen."""
    lines = head(60, min(40, 640 / n), "-40 60 80") + ["f 0.9 0.22 0.2 1 0 1 0 1"]
    for i in range(n):
        at = (i + 0.5) / n - 0.5
        lines.append(f"s {40 * at:.9g} {20 * at:.9g} {-40 * at:.9g} {30 / n:.9g}")
    return lines


def hidden():
    """Figure 11: a small sphere whose centre is nearer to the screen than the large one's, which
    nearly swallows it. Three more are nearer still, so the large one is not in the same node."""
    return head(12, 40, "-10 14 16") + [
        "shading blend",
        "f 0.95 0.52 0.15 0.8 0.2 40 0 1", "s 0 0 -2 3", "f 0.2 0.45 0.9 0.8 0.2 40 0 1",
        "s 1.1 0.5 -0.4 1.3"] + [f"s {x} {y} 0 0.3" for x, y in ((-5, 2), (-5, -2), (5, -2))]


def field(side):
    """Hilly ground under an image, 2 * side * side triangles, each with a mapping of its own."""
    lines = head(60, 40, "-40 60 80")
    lines[1], lines[2] = "from 0 14 44", "at 0 0 0"
    lines.append("f 1 1 1 1 0 1 0 1")
    height = lambda x, y: (1.1 * math.sin(0.61 * x) * math.cos(0.43 * y)
                           + 0.3 * math.sin(1.7 * y + x))

    def corner(i, j):
        x, y = 60 * i / side - 30, 60 * j / side - 30
        return f"{x:.6g} {height(x, y):.6g} {-y:.6g} {x / 4:.6g} {y / 4:.6g}"
    at = [[corner(i, j) for i in range(side + 1)] for j in range(side + 1)]
    for j in range(side):
        for i in range(side):
            a, b, c, d = at[j][i], at[j][i + 1], at[j + 1][i + 1], at[j + 1][i]
            lines += [f"tt {IMAGE} {a} {b} {c}", f"tt {IMAGE} {a} {c} {d}"]
    return lines


def _icosphere(level):
    """(corners, faces) of an icosahedron whose faces were cut in four `level` times; corners lie on
    the unit sphere."""
    g = (1 + math.sqrt(5)) / 2
    points = [(x, y, z) for a in (-1, 1) for b in (-g, g)
              for x, y, z in ((0, a, b), (a, b, 0), (b, 0, a))]
    length = math.sqrt(1 + g * g)
    points = [tuple(c / length for c in p) for p in points]
    edge = min(math.dist(points[0], p) for p in points[1:])
    near = lambda i, j: math.dist(points[i], points[j]) < 1.01 * edge
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
             if near(i, j) and near(j, k) and near(i, k)]
    for _ in range(level):
        middle, cut = {}, []

        def half(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                m = tuple((a + b) / 2 for a, b in zip(points[i], points[j]))
                size = math.hypot(*m)
                middle[key] = len(points)
                points.append(tuple(c / size for c in m))
            return middle[key]
        for i, j, k in faces:
            a, b, c = half(i, j), half(j, k), half(k, i)
            cut += [(i, a, c), (a, j, b), (c, b, k), (a, b, c)]
        faces = cut
    return points, faces


BOX = ([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)],
       [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def replaced(path, shape):
    """The scene of a file with another shape for each sphere: `box` around it, or N, an icosphere
    cut N times, with its corners on the sphere."""
    points, faces = BOX if shape == "box" else _icosphere(int(shape))
    lines = []
    with open(path, encoding="utf-8") as f:
        for line in f.read().split("\n"):
            words = line.split()
            if not words or words[0] != "s":
                lines.append(line)
                continue
            x, y, z, rad = map(float, words[1:])
            at = [(x + rad * a, y + rad * b, z + rad * c) for a, b, c in points]
            for face in faces:
                lines.append(f"p {len(face)}")
                lines += [f"{a:.9g} {b:.9g} {c:.9g}" for a, b, c in (at[i] for i in face)]
    return lines


def wider(path, times):
    """A scene whose view meets the middle of the picture, of so many times the height."""
    with open(path, encoding="utf-8") as f:
        text = re.sub(r"(?m)^shift .*\n", "", f.read())

    def angle(said):
        half = math.atan(times * math.tan(math.radians(float(said[2]) / 2)))
        return said[1] + (repr(2 * math.degrees(half)) if times != 1 else said[2])
    return re.sub(r"(?m)^([^#\n]*\bangle )([0-9.]+)", angle, text, count=1)
