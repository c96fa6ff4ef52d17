# board.py - frames and rays a second of a core at its clock: `make board-rate`
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.rate.board BUILD PAGE
Puts the table `rate` into PAGE: clocks of frames on the core in Verilator behind a DDR3 x16, at the
clock that a placer gave this very core, or else the first one of the table; memory is timed for the
nearest 20 MHz. Of 64 tiles a frame eight are drawn, one of each row and column, each with cold
caches. The frame's clocks are theirs, times what `expected` says of the whole frame over what it
says of them; the error is that of the jackknife."""
import json
import sys

from . import cores
from .cores import Core
from ..pages import data
from ..pages.place import place
from ..report import frames
from ..synth import report

WIDTH, HEIGHT, GRID = 1280, 720, 8
SIZE = f"{WIDTH}x{HEIGHT}"
SCENES = ["paper100", "random:256", "sphereflake:3"]
CORES = [Core(1, 0, 0), Core(3, 0, 0)]  # those that an LFE5U-85F has room for
OPTIONS = ["--memory=ddr3x16", "--latency=100"]
RAYS = "rays_primary", "rays_shadow", "rays_reflected", "rays_refracted"


def clock(effects, core):
    """(MHz, whose) of accuracy.seeds: the median of the core's, or of the first core there."""
    head, found = data.read("accuracy.seeds")
    key = cores.run("sh", "sim/key.sh", "standard", effects, "ecp5", **core.variables()).strip()
    own = [row for row in found if row[0].strip("`") == key]
    row = (own or found)[0]
    return float(row[head.index("median")]), "its own" if own else row[0]


def tiles():
    """Windows, one of each row and column of GRID x GRID."""
    w, h = WIDTH // GRID, HEIGHT // GRID
    for i in range(GRID):
        j = (3 * i + 1) % GRID
        yield i * w, j * h, (i + 1) * w, (j + 1) * h


def parts(frame, window):
    """(visits, pixels) of 256 pixels after another, as the walk sends them."""
    visits = [frame.pixels[y * frame.width + x].visits for x, y in frames.walk(window)]
    some = [visits[n:n + 256] for n in range(0, len(visits), 256)]
    return [(sum(part), len(part)) for part in some]


def expected(some, pipes):
    """Clocks of such parts if pipes alone set the pace, and one pixel a clock."""
    return sum(max(visits / pipes, pixels) for visits, pixels in some)


def estimate(drawn, guessed, whole):
    """(clocks of the frame, standard error) by the ratio of tiles drawn to what was guessed."""
    n, ratio = len(drawn), sum(drawn) / sum(guessed)
    left = [(sum(drawn) - d) / (sum(guessed) - g) for d, g in zip(drawn, guessed)]
    mean = sum(left) / n
    error = ((n - 1) / n * sum((x - mean) ** 2 for x in left)) ** 0.5
    return ratio * whole, error * whole


def rows(bench):
    whole = 0, 0, WIDTH, HEIGHT
    for scene in SCENES:
        machine = bench.machine(scene)
        path = machine.with_suffix(".frame")
        said = json.loads(cores.run(f"{bench.build}/sphaera", "render", str(machine), "--frame",
                                    str(path), "--json", "-"))
        rays = sum(said["counters"].get(name, 0) for name in RAYS)
        frame = frames.Frame(path)
        of_frame, of_tiles = parts(frame, whole), [parts(frame, window) for window in tiles()]
        for core in CORES:
            megahertz, whose = clock(cores.SPHERES, core)
            drawn = [cores.cycles(bench.counted(
                scene, cores.SPHERES, core, *OPTIONS, f"--core-mhz={20 * round(megahertz / 20)}",
                "--window=" + ",".join(map(str, window)))) for window in tiles()]
            guessed = [expected(some, core.pipes) for some in of_tiles]
            clocks, error = estimate(drawn, guessed, expected(of_frame, core.pipes))
            rate = 1e6 * megahertz / clocks
            yield [f"`{scene}`", core.name(), f"{clocks / WIDTH / HEIGHT:.2f}",
                   f"{100 * error / clocks:.1f}", f"{megahertz:.1f}", whose, f"{rate:.1f}",
                   f"{rays * rate / 1e6:.1f}"]


def main(build, page):
    head = ["scene", "pipes", "clocks a pixel", "error, %", "MHz", "clock of", "frames/s",
            "million rays/s"]
    place(page, {"rate": report.table(head, list(rows(cores.Bench(build, SIZE))), 2)})


if __name__ == "__main__":
    main(*sys.argv[1:])
