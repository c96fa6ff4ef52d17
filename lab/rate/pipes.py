# pipes.py - cycles a pixel for 1 to 4 traversal pipes: `make pipes`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `cycles` into PAGE. A core is built for each number of units, and serves
all scenes that ask no more of it."""

from . import cores
from .cores import Core
from ..pages.place import place
from ..synth import report

SIZE = "320x180"
RULE = [Core(n, 0, 0) for n in (1, 2, 3, 4)]
FEW = Core(4, 0, 2)  # two shading units for four pipes
SCENES = {
    cores.SPHERES: (RULE + [FEW], ["paper100", "random:256", "sphereflake:3", "protein", "paper5",
                                   "inside"]),
    cores.GLASS: ([RULE[0], RULE[3]], ["refraction/nested"]),
}


def rows(build):
    asked = {(scene, core): (scene, effects, core.axes())
             for effects, (built, scenes) in SCENES.items() for scene in scenes for core in built}
    runs = cores.runs(build, "pipes", SIZE, asked)
    for scene in dict.fromkeys(scene for scene, _ in asked):
        found = {core: cores.cycles(run) / run["pixels"] for (of, core), run in runs.items()
                 if of == scene}
        yield [f"`{scene}`", *(f"{found[c]:.2f}" if c in found else "-" for c in RULE + [FEW]),
               f"{found[RULE[0]] / found[RULE[3]]:.2f}"]


def main(build, page):
    head = ["scene", *(core.name() for core in RULE + [FEW]), "4 against 1"]
    place(page, "make pipes", {"pipes_cycles": report.table(head, list(rows(build)))})
