# second_nff.py - NFF by a reader of its own, against what the tool has read
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 second_nff.py TOOL SCENE...

Reads what Eric Haines' text of NFF (SPD 3.x, "NFF.TXT") says, and nothing of the project's own: v,
b, l, f, s, c, p, pp, comments. The tool's reading is taken from its export to POV-Ray, which has
camera, lights, spheres and triangles as numbers. Words that the text does not have are passed over
with all numbers behind them; where they may add primitives, triangles are not compared. A line for
each scene: what was read; exit code 1 if anything differs."""
import json
import math
import re
import subprocess
import sys
from pathlib import Path

NEAR = 1e-9     # of the largest number of a scene: printed with 17 digits, times a power of two
SIDES = 32      # of a cone's ring, as the tool draws it if --round does not say otherwise
SURFACES = {"ambient", "shading", "shadows"}    # words of the project's own that add no primitive


def number(word):
    try:
        return float(word)
    except ValueError:
        return None


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Words:
    """The words of a text without its comments."""

    def __init__(self, text):
        self.all = " ".join(line.split("#")[0] for line in text.splitlines()).split()
        self.at = 0

    def more(self):
        return self.at < len(self.all)

    def word(self):
        self.at += 1
        return self.all[self.at - 1]

    def next_is_number(self):
        return self.more() and number(self.all[self.at]) is not None

    def numbers(self, n):
        return [float(self.word()) for _ in range(n)]

    def rest(self):
        """Numbers up to the next word."""
        found = []
        while self.next_is_number():
            found.append(float(self.word()))
        return found


def read(text):
    """The scene as the format's text has it."""
    words, scene = Words(text), {"lights": [], "spheres": [], "cones": [], "areas": [],
                                 "corners": [], "fills": [], "unknown": {}}
    plain = []
    while words.more():
        word = words.word()
        if word == "v":
            for _ in range(6):  # from, at, up, angle, hither, resolution, each by its name
                name = words.word()
                scene[name] = words.rest()
        elif word == "b":
            scene["b"] = words.numbers(3)
        elif word == "l":
            given = words.rest()
            scene["lights"].append(given)
            plain += [len(given) == 3]
        elif word == "f":
            scene["fills"].append(words.rest())
        elif word == "s":
            scene["spheres"].append((words.numbers(4), len(scene["fills"]) - 1))
        elif word == "c":
            cone = words.numbers(8)
            scene["cones"].append((cone[3], cone[7]))
        elif word in ("p", "pp"):
            size = 3 if word == "p" else 6
            corners = [words.numbers(size)[:3] for _ in range(int(words.word()))]
            area = [0.0] * 3
            for a, b in zip(corners[1:], corners[2:]):  # twice the area, as a vector
                area = [x + y for x, y in zip(area, cross(minus(a, corners[0]),
                                                          minus(b, corners[0])))]
            scene["areas"].append(area)
            scene["corners"].append(len(corners))
        else:
            scene["unknown"][word] = scene["unknown"].get(word, 0) + 1
            while words.more() and (words.next_is_number() or words.all[words.at] not in
                                    ("v", "b", "l", "f", "s", "c", "p", "pp", word)):
                words.word()
    for light, bare in zip(scene["lights"], plain):
        if bare:
            light += [1 / math.sqrt(len(plain))] * 3
    return scene


def vectors(text):
    return [[float(n) for n in found.split(",")] for found in re.findall(r"<([-+0-9.e,]+)>", text)]


def exported(text):
    """The same of an export to POV-Ray."""
    scale = float(re.search(r"lengths times ([-+0-9.e]+)", text)[1])
    scene = {"lights": [], "spheres": [], "triangles": []}
    for line in text.splitlines():
        found = vectors(line)
        if line.startswith("camera"):
            scene["from"] = [x / scale for x in found[0]]
        elif line.startswith("background"):
            scene["b"] = found[-1]
        elif line.startswith("light_source"):
            scene["lights"].append([x / scale for x in found[0]] + found[1])
        elif line.startswith("sphere") and "Look(" in line:     # glass has one more, for shadows
            radius = float(re.search(r">, *([-+0-9.e]+)", line)[1])
            look = int(re.search(r"Look\((\d+)", line)[1])
            scene["spheres"].append(([x / scale for x in found[0]] + [radius / scale], look))
        elif line.startswith(("triangle", "smooth_triangle")):
            corners = found[::2] if line.startswith("smooth") else found
            scene["triangles"].append([[x / scale for x in v] for v in corners[:3]])
    index = {m[1]: float(m[2]) for m in re.finditer(r"Index\[(\d+)\] = ([-+0-9.e]+)", text)}
    scene["looks"] = {}
    for m in re.finditer(r"Looks\[(\d+)\] = texture { pigment { rgb <([-+0-9.e,]+)> "
                         r"transmit ([-+0-9.e]+)", text):
        scene["looks"][int(m[1])] = [*map(float, m[2].split(",")), float(m[3]), index[m[1]]]
    return scene


def far(a, b, size=1.0):
    """Whether numbers differ by more than printing does."""
    return len(a) != len(b) or any(abs(x - y) > NEAR * max(size, abs(x), abs(y))
                                   for x, y in zip(a, b))


def differ(mine, tools):
    """What differs, in words; of primitives if the tool has left none out and knows no more."""
    wrong = []
    size = max((abs(x) for s, _ in mine["spheres"] for x in s), default=1.0)
    if far(mine["from"], tools["from"], size):
        wrong.append(f"from: {mine['from']} and {tools['from']}")
    if far(mine.get("b", tools["b"]), tools["b"]):
        wrong.append(f"b: {mine['b']} and {tools['b']}")
    if len(mine["lights"]) != len(tools["lights"]) or any(
            far(a, b, size) for a, b in zip(mine["lights"], tools["lights"])):
        wrong.append(f"lights: {mine['lights']} and {tools['lights']}")
    return wrong


def differ_primitives(mine, tools, facets):
    """The same of spheres with their colours, transmission and index; of triangles if asked for."""
    wrong = []
    size = max((abs(x) for s, _ in mine["spheres"] for x in s), default=1.0)
    if len(mine["spheres"]) != len(tools["spheres"]):
        wrong.append(f"{len(mine['spheres'])} and {len(tools['spheres'])} spheres")
    for (a, fill), (b, look) in zip(mine["spheres"], tools["spheres"]):
        said, inside = mine["fills"][fill], a[3] < 0    # then its index is that of what is around
        as_said = said[:3] + ([said[6], said[7]] if said[6] > 0 else [0, 1])
        if far(a[:3] + [abs(a[3])], b, size) or far(as_said[:5 - inside],
                                                    tools["looks"][look][:5 - inside]):
            wrong.append(f"sphere {a} of {as_said} and {b} of {tools['looks'][look]}")
            break
    if not facets:
        return wrong
    triangles = sum(n - 2 for n in mine["corners"])
    triangles += sum(SIDES * (1 if 0 in radii else 2) for radii in mine["cones"])
    if triangles != len(tools["triangles"]):
        wrong.append(f"{triangles} and {len(tools['triangles'])} triangles")
    if mine["cones"]:
        return wrong
    sums = [[sum(abs(a[k]) for a in areas) for k in range(3)] for areas in (
        mine["areas"], [cross(minus(b, a), minus(c, a)) for a, b, c in tools["triangles"]])]
    if any(abs(x - y) > 1e-6 * max(sums[0]) for x, y in zip(*sums)):
        wrong.append(f"areas: {sums[0]} and {sums[1]}")
    return wrong


def main(tool, *paths):
    bad = 0
    for path in paths:
        mine = read(Path(path).read_text(encoding="utf-8"))
        pov = subprocess.run([tool, "export", path, "-o", "-"], check=True, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout
        told = json.loads(subprocess.run([tool, "info", path, "--json", "-"], check=True, text=True,
                                         stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout)
        left_out = sum(row["count"] for row in told["ledger"] if row["end"] == "left out")
        tools, unknown = exported(pov), mine["unknown"].keys() - SURFACES
        wrong = differ(mine, tools)
        if not left_out and "texture" not in unknown:   # images are told in another way
            wrong += differ_primitives(mine, tools, not unknown)
        bad |= bool(wrong)
        print(f"{path}: {len(mine['spheres'])} spheres, {len(mine['areas'])} polygons, "
              f"{len(mine['cones'])} cones, {len(mine['lights'])} lights; {left_out} left out; "
              f"passed over: {' '.join(mine['unknown']) or 'nothing'}: "
              f"{'; '.join(wrong) or 'the same'}")
    return bad


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
