# board.py - clocks and rays of whole frames, that frames a second follow from: `make board-rate`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `rate` into PAGE: clocks of whole frames on the core in Verilator behind a DDR3
x16. Memory is timed for the nearest 20 MHz of that very core's clock (lab/clocks.py), of a core
that is not routed for 100. Rates follow in the page (lab/pages/rates.py)."""

from . import cores
from .cores import Core
from .. import clocks
from ..pages.place import place
from ..sweep.measures import RAYS
from ..synth import report

WIDTH, HEIGHT = 1280, 720
SIZE = f"{WIDTH}x{HEIGHT}"
SCENES = ["paper100", "random:256", "sphereflake:3"]
CORES = [Core(1, 0, 0), Core(2, 0, 0), Core(3, 0, 0)]  # those that an LFE5U-85F has room for


def behind_ddr3(core):
    """Axes of the core and of its memory."""
    at = clocks.clock(clocks.key("standard", cores.SPHERES, **core.variables()))
    return {**core.axes(), "memory": "ddr3x16", "latency": 100,
            "core_mhz": 20 * round((at.mhz if at else 100) / 20)}


def rows(build):
    runs = cores.runs(build, "board-rate", SIZE, {
        (scene, core): (scene, cores.SPHERES, behind_ddr3(core))
        for scene in SCENES for core in CORES})
    for (scene, core), run in runs.items():
        rays = sum(run["counters"].get(name, 0) for name in RAYS)
        pixels = WIDTH * HEIGHT
        yield [f"`{scene}`", core.name(), f"{cores.cycles(run) / pixels:.2f}",
               f"{rays / pixels:.2f}"]


def main(build, page):
    head = ["scene", "pipes", "clocks a pixel", "rays a pixel"]
    place(page, "make board-rate", {"pipes_rate": report.table(head, list(rows(build)), 2)})
