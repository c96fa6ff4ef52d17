# pictures.py - a BIH on a screen, as Figure 4.3 of its thesis has it
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess

# MAX_TREE_DEPTH and MAX_PRIMS of Scenario 1 with 64 spheres
DRAWN = (("1", "1"), ("3", "1"), ("infinity", "1"), ("infinity", "64"), ("infinity", "32"),
         ("infinity", "2"))


def main(tool, folder, shown):
    os.makedirs(shown, exist_ok=True)
    scene = f"{folder}/drawn.nff"
    run = dict(check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    subprocess.run([tool, "gen", "scenario1", "-n", "64", "-o", scene], **run)
    for depth, prims in DRAWN:
        subprocess.run([tool, "render", scene, "--profile", "standard", "--size", "160x272",
                        "--depth", "0", "--shadow", "off", "--accel", "bih", "--max-tree-depth",
                        depth, "--max-prims", prims, "--walk", f"{shown}/depth{depth}-{prims}.png"],
                       **run)
