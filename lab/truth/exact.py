# exact.py - what the eye sees in a scene, in decimal numbers of 60 digits
# SPDX-License-Identifier: Apache-2.0
"""POV-Ray lets its roundings choose among surfaces in one place, and so which side of an edge a ray
passes. Here the numbers of a scene file are taken as they are written, by another rule than that of
the double reference: all edges and hits of a pixel are found first, then compared. Knows `s`, `p`
of convex polygons, `plane`, and nothing of what is seen in mirrors."""
import math
from decimal import Decimal, getcontext
from pathlib import Path

getcontext().prec = 60
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")
SAME = Decimal("1e-40")  # of t, or of an edge's volume: surfaces in one place, a ray in an edge
NEAR = Decimal("1e-12")  # so near to that, that doubles may see it otherwise
NUMBERS = {"from": 3, "at": 3, "up": 3, "angle": 1, "shift": 2, "s": 4, "plane": 6}
ID_NONE = 0xffffff


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def less(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def unit(v):
    length = dot(v, v).sqrt()
    return tuple(c / length for c in v)


def tangent(angle):
    """Of an angle in degrees."""
    x, sine, cosine, term = angle * PI / 180, Decimal(0), Decimal(0), Decimal(1)
    for n in range(1, 80):
        if n % 2:
            cosine += term
        else:
            sine += term
        term *= (x if n % 2 else -x) / n
    return sine / cosine


def read(path):
    """(camera, spheres, facets): {word: numbers}, [numbers], [("triangle", corners) or ("plane",
    numbers)]."""
    text = Path(path).read_text(encoding="utf-8").splitlines()
    words = iter([word for line in text for word in line.split("#")[0].split()])

    def numbers(n):
        return tuple(Decimal(next(words)) for _ in range(n))
    camera, spheres, facets = {}, [], []
    for word in words:
        if word in NUMBERS:
            said = numbers(NUMBERS[word])
            if word == "s":
                spheres.append(said)
            elif word == "plane":
                facets.append((word, said))
            else:
                camera[word] = said
        elif word == "p":
            at = [numbers(3) for _ in range(int(next(words)))]
            facets += [("triangle", (at[0], b, c)) for b, c in zip(at[1:], at[2:])]
    return camera, spheres, facets


def triangle(eye, corners):
    """A test of a direction: (t, how near it is to an edge), None: it misses."""
    seen = [less(v, eye) for v in corners]
    edges = [cross(seen[(k + 1) % 3], seen[(k + 2) % 3]) for k in range(3)]
    sizes = [dot(e, e).sqrt() for e in edges]
    normal = cross(less(corners[1], corners[0]), less(corners[2], corners[0]))
    above = dot(normal, seen[0])

    def test(ray, length):
        sides = [dot(edge, ray) / (size * length) for edge, size in zip(edges, sizes)]
        if min(sides) < -NEAR and max(sides) > NEAR:
            return None
        steep = dot(normal, ray)
        met = min(sides) >= -SAME or max(sides) <= SAME
        return steep and above / steep, met, min(map(abs, sides))
    return test


def plane(eye, said):
    above = dot(said[3:], less(said[:3], eye))

    def test(ray, length):
        steep = dot(said[3:], ray)
        return (above / steep, True, abs(steep) / length) if steep else None
    return test


def sphere(eye, said):
    to, square = less(said[:3], eye), said[3] * said[3]

    def test(ray, length):
        middle = dot(to, ray) / (length * length)
        off = less(to, tuple(middle * c for c in ray))
        half = square - dot(off, off)
        if half < -NEAR * square:
            return None
        depth = max(half, Decimal(0)).sqrt() / length
        first = middle - depth
        return (first if first > 0 else middle + depth), half > 0, abs(half) / square
    return test


def covered(view, size, corners):
    """The pixels that a triangle may cover: ranges of columns and rows."""
    eye, axes, screen, (left, top) = view
    width, height = size
    columns, rows = [], []
    for corner in corners:
        x, y, z = (float(dot(less(corner, eye), axis)) for axis in axes)
        if z > -1e-3 * math.hypot(x, y):
            return range(width), range(height)
        columns.append(-x / z * screen - left)
        rows.append(y / z * screen + top)

    def around(found, most):
        return range(max(0, math.floor(min(found)) - 1), min(most, math.ceil(max(found)) + 2))
    return around(columns, width), around(rows, height)


def see(path, size):
    """(ids, near) of each pixel: what is seen; whether doubles may see it otherwise."""
    camera, spheres, facets = read(path)
    width, height = size
    eye, back = camera["from"], unit(less(camera["from"], camera["at"]))
    right = unit(cross(camera["up"], back))
    axes, screen = (right, cross(back, right), back), height / (2 * tangent(camera["angle"][0] / 2))
    aside, above = camera.get("shift", (0, 0))
    left = (1 - width) / Decimal(2) + aside * height
    top = (height - 1) / Decimal(2) + above * height
    flat = eye, axes, float(screen), (float(left), float(top))
    every = range(width), range(height)
    tests = [(sphere(eye, said), every) for said in spheres]
    for kind, said in facets:
        if kind == "plane":
            tests.append((plane(eye, said), every))
        else:
            tests.append((triangle(eye, said), covered(flat, size, said)))

    def ray(x, y):
        right, up = left + x, top - y
        way = tuple(right * a + up * b - screen * c for a, b, c in zip(*axes))
        return way, dot(way, way).sqrt()
    rays = [ray(x, y) for y in range(height) for x in range(width)]
    hits = [[] for _ in rays]
    for number, (test, (columns, rows)) in enumerate(tests):
        for y in rows:
            for x in columns:
                found = test(*rays[y * width + x])
                if found and found[0] > 0:
                    hits[y * width + x].append((number, *found))
    return zip(*map(first, hits))


def first(hits):
    """The number of what is seen, and whether that is sure to a part in 10^12."""
    nearest = min((t for _, t, met, _ in hits if met), default=Decimal("inf"))
    if nearest.is_infinite():
        return ID_NONE, any(edge < NEAR for _, _, _, edge in hits)
    tied = [hit for hit in hits if hit[1] < nearest * (1 + NEAR)]
    seen = [hit for hit in tied if hit[2] and hit[1] <= nearest * (1 + SAME)]
    return min(seen)[0], len([h for h in tied if h[2]]) > len(seen) or any(
        edge < NEAR for _, _, _, edge in tied)
