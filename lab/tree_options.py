# tree_options.py - the trees that studies draw with, and what `sphaera build` is told for each
# SPDX-License-Identifier: Apache-2.0
"""NAME: default, a tree of bvh4 (paper, balanced, reinserted, hw, hw1, hw2), a way of --accel, or
bih and listing with the most primitives of a leaf behind them: bih1, listing8."""
import re

OF_FOUR = ("paper", "balanced", "reinserted")
BVH4 = OF_FOUR + ("hw", "hw1", "hw2")
ACCELS = ("bvh4", "box4", "bih", "brute")


def options(name):
    """Options of `sphaera build`, a list of words."""
    if name == "default":
        return []
    if name in BVH4:
        return ["--tree", name]
    if name in ACCELS:
        return ["--accel", name]
    leaves = re.fullmatch(r"(bih|listing)(\d+|infinity)", name)
    if not leaves:
        raise ValueError(f"no tree is called {name}: {', '.join(BVH4 + ACCELS)}, bihN, listingN")
    return ["--accel", "bih", "--max-prims", leaves[2]] \
        + (["--bih", "listing"] if leaves[1] == "listing" else [])


def main(name):
    print(*options(name))
