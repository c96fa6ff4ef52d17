# doubt.py - pixels of a scene that no picture can be held to, and pixels beyond a grid
# SPDX-License-Identifier: Apache-2.0
"""A pixel whose colour changes when the eye moves by 10^-9 looks at the very border of two texels,
or of two objects: which of them it shows, the last bit of a double decides."""
import math
import re
from pathlib import Path

from ..runner import text_of

NUDGE = 1e-9  # of the distance from the eye to what it looks at, along each axis


def camera(text):
    """{"from", "at", "up": vectors, "angle": degrees} of an NFF scene."""
    found = {}
    for name, said in re.findall(r"(?m)^(from|at|up|angle)\s+(.*)$", text):
        found.setdefault(name, [float(word) for word in said.split("#")[0].split()[:3]])
    found["angle"] = found["angle"][0]
    return found


def nudged(scene, to, sign):
    """Writes the scene with its eye moved."""
    text = text_of(scene)
    view = camera(text)
    by = sign * NUDGE * math.dist(view["from"], view["at"])

    def moved(line):
        return f"{line[1]} " + " ".join(repr(n + by) for n in view[line[1]])
    Path(to).write_text(re.sub(r"(?m)^(from|at)\s.*$", moved, text), encoding="utf-8")


def unit(v):
    length = math.hypot(*v)
    return [n / length for n in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def beyond(scene, size, nearest):
    """For each pixel whether the ray of the eye meets a plane of the scene at `nearest` or farther
    away; nearest None: nowhere."""
    text = text_of(scene)
    planes = [[float(word) for word in said.split()[:6]]
              for said in re.findall(r"(?m)^plane\s+(.*)$", text)]
    width, height = size
    if nearest is None or not planes:
        return [False] * (width * height)
    view = camera(text)
    ahead = unit([a - b for a, b in zip(view["at"], view["from"])])
    right = unit(cross(ahead, view["up"]))
    up, half = cross(right, ahead), math.tan(math.radians(view["angle"] / 2))
    found = []
    for i in range(width * height):
        x = half * (2 * (i % width) + 1 - width) / height
        y = half * (height - 1 - 2 * (i // width)) / height
        ray = unit([a + x * r + y * u for a, r, u in zip(ahead, right, up)])
        away = [dot([p - e for p, e in zip(plane, view["from"])], plane[3:]) /
                (dot(ray, plane[3:]) or math.inf) for plane in planes]
        found.append(any(t >= nearest for t in away))
    return found
