# measure.py - runs what the tables of docs/results/trees.md are made of, once
# SPDX-License-Identifier: Apache-2.0
"""Leaves NAME.json in FOLDER for each machine: what build and render report, times of several runs.
A result that is younger than the tool is kept, of the RTL if it is younger than that too. --rtl
also runs the machines of list `speed` and `trees` through the RTL: NAME.core.json, with
sim/core.sh. --rtl-small runs no more than the small frames of `speed` and those of `trees` through
the RTL."""
import json
import os

from .. import intact
from ..pages import whole
from ..runner import Runner as Runs, core_name
from ..tree_options import options

SPHERES = 4096
PRIMS = [1, 2, 4, 8, 16]
FEW = [64, 128, 256]
MANY = [1024, 2048, 4096]
SCENES = ["sphereflake2", "paper100", "random4096", "room", "scenario1", "scenario2", "scenario3"]
ACCELS = ["paper", "balanced", "reinserted", "box4", "bih1", "bih4", "bih8", "brute"]
# of these the RTL draws
SCENES_RTL = ["paper100", "random4096", "room"]
ACCELS_RTL = ["reinserted", "box4", "bih1", "bih4", "bih8"]
# only primary rays; no shadows
PRIMARY = ["--depth", "0", "--shadow", "off"]
RENDERS = 3
# the thesis's frame; what of Figure 4.4 the RTL draws of it
DRAWN = ("1", 1), ("3", 1), *(("infinity", prims) for prims in (1, 64, 32, 2))
FULL = ["--size", "640x1088"]
FULL_RTL = [(1, 64, "bih1", 1), (1, 64, "bih8", 1), *((s, 64, "bih1", 2) for s in (1, 2, 3))]


class Runner(Runs):
    def __init__(self, tool, folder, rtl):
        super().__init__(tool, folder)
        self.rtl = rtl

    def generated(self, kind, n, radius=1):
        """A scene file without Whitted's sum, which every core can draw."""
        name = f"{kind}-{n}-{radius}.nff"
        if not self.fresh(name):
            more = [] if kind == "random" else ["--radius", str(radius), "--plain"]
            self.run("gen", kind, "-n", str(n), *more, "-o", self.path(name))
        return self.path(name)

    def machine(self, name, scene, build, renders=1):
        """Builds, and renders if asked for; NAME.json has both reports and all times."""
        if self.fresh(name + ".json"):
            return
        print("  RUN ", name, flush=True)
        sph, result = self.path(name + ".sph"), {}
        result["build"] = json.loads(self.run("build", scene, "--profile", "standard", *build,
                                              "-o", sph, "--json", "-"))
        if renders:
            runs = [json.loads(self.run("render", sph, "-t", "1", "--json", "-"))
                    for _ in range(renders)]
            result["render"], result["render_times"] = runs[0], [r["cpu_seconds"] for r in runs]
        intact.write(self.path(name + ".json"), json.dumps(result, indent=1))

    def core(self, name, pipes=1):
        """The machine through the RTL, twice: the second time with warm caches."""
        if self.rtl and not self.fresh(core_name(name, pipes), *whole.RTL):
            self.simulate(name, "auto", 100, pipes)


def scene_file(runner, name):
    if name == "room":
        return "scenes/facets/room.nff"
    if name == "random4096":
        return runner.generated("random", 4096)
    if name.startswith("scenario"):
        return runner.generated(name, SPHERES)
    return f"scenes/{name}.nff"


def tree(runner, scene, way):
    size = "90x153" if scene.startswith("scenario") else "160x90"
    runner.machine(f"trees-{scene}-{way}", scene_file(runner, scene),
                   options(way) + ["--size", size, "--axes", "camera"])
    if scene in SCENES_RTL and way in ACCELS_RTL:
        runner.core(f"trees-{scene}-{way}")


def small(runner):
    """What the cycles and the limits of Figure 4.4 are read from, frames of 40 x 68 pixels, and
    those of the other trees."""
    for scene in SCENES_RTL:
        for way in ACCELS_RTL:
            tree(runner, scene, way)
    for number in 1, 2, 3:
        for n in FEW:
            for way in ["brute"] + [f"bih{p}" for p in PRIMS]:
                name = f"rtl-{number}-{n}-{way}"
                runner.machine(name, runner.generated(f"scenario{number}", n),
                               options(way) + PRIMARY + ["--size", "40x68"])
                runner.core(name)


def main(tool, folder, rtl=False, rtl_small=False):
    runner = Runner(tool, folder, rtl or rtl_small)
    if runner.rtl:
        small(runner)
    if rtl_small:
        return
    for number in 1, 2, 3:
        kind = f"scenario{number}"
        for how in "bih1", "bih8", "listing1", "listing8":
            runner.machine(f"table-{number}-{how}", runner.generated(kind, SPHERES), options(how),
                           0)
        for n in MANY:
            for prims in PRIMS:
                runner.machine(f"memory-{number}-{n}-{prims}", runner.generated(kind, n, 0.001),
                               options(f"bih{prims}") + ["--profile", "fine"], 0)
        for n in FEW:
            for way in ["brute"] + [f"bih{p}" for p in PRIMS]:
                scene = runner.generated(kind, n)
                name = f"speed-{number}-{n}-{way}"
                runner.machine(name, scene, options(way) + PRIMARY + FULL, RENDERS)
                for *drawn, pipes in FULL_RTL:
                    if drawn == [number, n, way]:
                        runner.core(name, pipes)
    for scene in SCENES:
        for way in ACCELS:
            tree(runner, scene, way)


def pictures(tool, folder, shown):
    """A BIH on a screen, of Scenario 1 with 64 spheres, as Figure 4.3 has it: MAX_TREE_DEPTH and
    MAX_PRIMS."""
    os.makedirs(shown, exist_ok=True)
    run = Runs(tool, folder)
    run.run("gen", "scenario1", "-n", "64", "-o", run.path("drawn.nff"))
    for depth, prims in DRAWN:
        run.run("render", run.path("drawn.nff"), "--profile", "standard", "--size", "160x272",
                *PRIMARY, "--accel", "bih", "--max-tree-depth", depth, "--max-prims", prims,
                "--walk", f"{shown}/depth{depth}-{prims}.png")
