#!/usr/bin/env python3
# profile.py - a ground under many spheres, and what was expected of profiles against what is
# SPDX-License-Identifier: Apache-2.0
"""usage: profile.py cover          a ground of radius 1000 under 480 spheres of 0.2 and three of 1
       profile.py expected RUNS  a row each; exit code 1 if one was worse than expected

RUNS: what `sphaera accuracy` prints, of many runs one after another, each behind a line "run SCENE
PROFILE". Worse: its dB are less, or more pixels see another thing. Edges that move hit pixels by
chance: these may be more by three times the root of their number and three. Where a plane goes on
beyond the grid few pixels are far off, and a sample of them is known: half a dB."""
import math
import re
import sys


def cover():
    state = 7

    def chance():
        nonlocal state
        state = state * 16807 % 2147483647
        return state / 2147483647
    print("v\nfrom 13 2 3\nat 0 0 0\nup 0 1 0\nangle 20\nhither 0.1\nresolution 320 180\n"
          "b 0.6 0.75 1\nl 30 40 20 0.9 0.9 0.9\nf 0.5 0.5 0.5 0.8 0 0 0 1\ns 0 -1000 0 1000")
    for n in range(22 * 22):
        x, z = (at - 11 + 0.9 * chance() for at in divmod(n, 22))
        red, green, blue = chance(), chance(), chance()
        mirrors = 0.6 if chance() < 0.2 else 0
        print(f"f {red:.3f} {green:.3f} {blue:.3f} 0.8 {mirrors:.2f} 0 0 1")
        if n < 480:
            y = math.sqrt(1000.2 * 1000.2 - x * x - z * z) - 1000
            print(f"s {x:.6f} {y:.6f} {z:.6f} 0.2")
    print("f 0.7 0.6 0.5 0.2 0.8 0 0 1\ns 4 1 0 1\ns 0 1 0 1\n"
          "f 0.4 0.2 0.1 0.8 0 0 0 1\ns -4 1 0 1")


def row(scene, profile, text):
    """The row of a run, and whether it is worse."""
    said = {word[0]: word[1:] for word in map(str.split, text.splitlines()) if word}
    if "psnr" not in said:
        return f"| {scene} | {profile} | does not fit |", False
    psnr, seen = said["psnr"][0], sum(int(said["wrong"][i].rstrip(",")) for i in (1, 4))
    expected, _, wrong = said["expected"][:3]
    cut = 0.5 if "the plane goes on beyond the grid" in text else 0
    wrong = float(wrong)
    worse = seen > wrong + 3 * math.sqrt(wrong) + 3 or float(psnr) + cut < float(expected)
    return (f"| {scene} | {profile} | {psnr} | {expected} | {seen} | {wrong:.1f} | "
            f"{said['expected'][-3]} |{' worse than expected' * worse}"), worse


def judge(name):
    with open(name, encoding="utf-8") as f:
        runs = re.findall(r"^run (\S+) (\S+)\n((?:(?!run ).*\n)*)", f.read(), re.M)
    rows = [row(*run) for run in runs]
    print(*(text for text, _ in rows), sep="\n")
    return not rows or any(worse for _, worse in rows)


if sys.argv[1] == "cover":
    cover()
else:
    sys.exit(judge(sys.argv[2]))
