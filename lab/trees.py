#!/usr/bin/env python3
# trees.py - visits in trees of four children, against a bound from below: `make trees`
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.trees TOOL FOLDER
Renders scenes with each tree and prints a table. The pictures must be the same.

The bound holds for primary rays, whatever the tree: a ray that hits a primitive must visit every
node above it, and any other ray the root. With w rays that end at each primitive the sum of w times
the nodes above is least in Huffman's tree of four children.
"""
import heapq
import json
import os
import struct
import subprocess
import sys

from .tree_options import OF_FOUR, options

NO_ID, HEAD = 0xFFFFFF, 32  # of a frame file: cmodel/core/frame_file.h
PDB = "/usr/share/pymol/data/demo/1tii.pdb"
SIZE = "160x90"
SCENES = [("`paper100`", "scenes/paper100.nff"), ("random", ["gen", "random", "-n", "256"]),
          ("sphereflake 3", ["gen", "sphereflake", "--size", "3"]),
          ("random", ["gen", "random", "-n", "1000"]), ("random", ["gen", "random", "-n", "4096"]),
          ("1TII, a protein", ["import", PDB]),
          ("sphereflake 4", ["gen", "sphereflake", "--size", "4"])]


def ids(path):
    """Of every pixel of a frame file, the primitive that its primary ray hits."""
    with open(path, "rb") as f:
        data = f.read()
    _, width, height, frames, counters = struct.unpack_from("<5I", data, 8)
    first, size = HEAD + 8 * counters, 4 * frames + 20
    return [struct.unpack_from("<I", data, first + size * i + 4 * frames)[0]
            for i in range(width * height)]


def bound(hits, primitives):
    """Least mean of visits of rays that hit these primitives of so many."""
    weights = {}
    for number in hits:
        weights[number] = weights.get(number, 0) + 1
    total = weights.pop(NO_ID, 0)
    heap = sorted([*weights.values()] + [0] * (primitives - len(weights)))
    heap = [0] * (-(len(heap) - 1) % 3) + heap
    while len(heap) > 1:
        node = sum(heapq.heappop(heap) for _ in range(4))
        total += node
        heapq.heappush(heap, node)
    return total / len(hits)


def measure(tool, folder, scene, tree):
    """Visits of a ray, and what the primary rays hit; hash of the picture."""
    frame = os.path.join(folder, "frame")
    words = [tool, "render", scene, "--profile", "standard", "--size", SIZE, *options(tree)]
    found = []
    for more in ([], ["--depth", "0", "--shadow", "off"]):
        done = subprocess.run([*words, *more, "--frame", frame, "--json", "-"], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode:
            sys.exit(f"trees: {done.stderr}")
        report = json.loads(done.stdout)
        counters = report["counters"]
        rays = sum(n for name, n in counters.items() if name.startswith("rays_"))
        found.append((counters["node_visits"] / rays, report["frame"]["picture_hash"]))
    return found, ids(frame)


def row(tool, folder, name, source):
    scene = source if isinstance(source, str) else os.path.join(folder, "scene.nff")
    if scene != source:
        subprocess.run([tool, *source, "-o", scene], check=True, stdout=subprocess.DEVNULL)
    whole, primary = [], []
    for tree in OF_FOUR:
        found, hits = measure(tool, folder, scene, tree)
        whole.append(found[0])
        primary.append(found[1])
    if len({picture for _, picture in whole}) != 1:
        sys.exit(f"trees: {scene}: the pictures are not the same")
    with open(scene, encoding="utf-8") as f:
        n = sum(line.split()[:1] == ["s"] for line in f)
    cells = [f"{visits:.2f}" for visits, _ in whole + primary]
    return f"| {name} | {n} | {' | '.join(cells)} | {bound(hits, n):.2f} |"


def main():
    tool, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    heads = ["scene", "spheres", *OF_FOUR, *(f"primary: {tree}" for tree in OF_FOUR), "bound"]
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    lines += [row(tool, folder, name, source) for name, source in SCENES]
    print("\n".join(lines))


if __name__ == "__main__":
    main()
