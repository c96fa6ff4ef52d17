# board.py - frames and rays a second of a core at its clock: `make board-rate`
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.rate.board BUILD PAGE
Puts the table `rate` into PAGE: clocks of whole frames on the core in Verilator behind a DDR3 x16,
at the median clock that a placer gave this very core (`make study-seeds`). Memory is timed for the
nearest 20 MHz, of a core that is not placed for 100."""
import sys

from . import cores
from .cores import Core
from ..pages import data
from ..pages.place import place
from ..synth import report

WIDTH, HEIGHT = 1280, 720
SIZE = f"{WIDTH}x{HEIGHT}"
SCENES = ["paper100", "random:256", "sphereflake:3"]
CORES = [Core(1, 0, 0), Core(2, 0, 0), Core(3, 0, 0)]  # those that an LFE5U-85F has room for
OPTIONS = ["--memory=ddr3x16", "--latency=100"]
RAYS = "rays_primary", "rays_shadow", "rays_reflected", "rays_refracted"


def clock(effects, core):
    """MHz of the core in accuracy.seeds, None: it is not placed."""
    head, found = data.read("accuracy.seeds")
    key = cores.run("sh", "sim/key.sh", "standard", effects, "ecp5", **core.variables()).strip()
    own = [float(row[head.index("median")]) for row in found if row[0].strip("`") == key]
    return own[0] if own else None


def rows(bench):
    for scene in SCENES:
        for core in CORES:
            megahertz = clock(cores.SPHERES, core)
            counted = bench.counted(scene, cores.SPHERES, core, *OPTIONS,
                                    f"--core-mhz={20 * round((megahertz or 100) / 20)}")
            rays = sum(counted["cold"]["counters"].get(name, 0) for name in RAYS)
            clocks = cores.cycles(counted)
            placed = [f"{megahertz:.1f}", f"{1e6 * megahertz / clocks:.1f}",
                      f"{rays * megahertz / clocks:.1f}"] if megahertz else ["not placed", "-", "-"]
            yield [f"`{scene}`", core.name(), f"{clocks / WIDTH / HEIGHT:.2f}", *placed,
                   f"{30 * clocks / 1e6:.0f}"]


def main(build, page):
    head = ["scene", "pipes", "clocks a pixel", "MHz", "frames/s", "million rays/s",
            "MHz for 30 frames/s"]
    place(page, "make board-rate", {
        "rate": report.table(head, list(rows(cores.Bench(build, SIZE))), 2)})


if __name__ == "__main__":
    main(*sys.argv[1:])
