# measure.py - runs what the tables of docs/results/scenarios.md are made of, once
# SPDX-License-Identifier: Apache-2.0
"""Leaves NAME.json in FOLDER for each machine: what build and render report, times of several runs.
A result that is younger than the tool is kept, of the RTL if it is younger than that too. --rtl
also runs the machines of list `speed` and `trees` through the RTL: NAME.core.json, with
sim/core.sh. --rtl-small runs no more than the small frames of `speed` and those of `trees` through
the RTL."""
import json
import os
import subprocess
import sys

from .. import intact
from ..pages import whole
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
FULL = ["--size", "640x1088"]
FULL_RTL = [(1, 64, "brute"), (1, 64, "bih1"), (1, 64, "bih8")]


class Runner:
    def __init__(self, tool, folder, rtl):
        self.tool, self.folder, self.rtl = tool, folder, rtl
        os.makedirs(folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def fresh(self, path, *sources):
        """Whether a result is there, younger than the tool and the files of these patterns."""
        return os.path.exists(path) and os.path.getmtime(path) > os.path.getmtime(self.tool) \
            and bool(whole.there(path, *sources))

    def run(self, *words):
        done = subprocess.run([self.tool, *words], stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode:
            sys.exit(f"measure: {' '.join(words)} failed")
        return done.stdout

    def generated(self, kind, n, radius=1):
        """A scene file without Whitted's sum, which every core can draw."""
        path = self.path(f"{kind}-{n}-{radius}.nff")
        if not self.fresh(path):
            more = [] if kind == "random" else ["--radius", str(radius), "--plain"]
            self.run("gen", kind, "-n", str(n), *more, "-o", path)
        return path

    def machine(self, name, scene, build, renders=1):
        """Builds, and renders if asked for; NAME.json has both reports and all times."""
        target = self.path(name + ".json")
        if self.fresh(target):
            return
        print("  RUN ", name, flush=True)
        sph, result = self.path(name + ".sph"), {}
        result["build"] = json.loads(self.run("build", scene, "--profile", "standard", *build,
                                              "-o", sph, "--json", "-"))
        if renders:
            runs = [json.loads(self.run("render", sph, "-t", "1", "--json", "-"))
                    for _ in range(renders)]
            result["render"], result["render_times"] = runs[0], [r["cpu_seconds"] for r in runs]
        intact.write(target, json.dumps(result, indent=1))

    def core(self, name):
        """The machine through the RTL, twice: the second time with warm caches."""
        target = self.path(name + ".core.json")
        if not self.rtl or self.fresh(target, *whole.RTL):
            return
        print("  SIM ", name, flush=True)
        build = os.path.dirname(os.path.abspath(self.tool))
        words = ["sh", "sim/core.sh", "--machine", self.path(name + ".sph"), "--warm",
                 "--latency", "100", "--json"]
        env = dict(os.environ, EFFECTS="auto", BUILD=build, JOBS="1")
        with intact.beside(target) as new:
            if subprocess.run([*words, new], env=env, stdout=subprocess.DEVNULL,
                              check=False).returncode:
                sys.exit(f"measure: {name}: {' '.join(words)} failed")


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
                if (number, n, way) in FULL_RTL:
                    runner.core(name)
    for scene in SCENES:
        for way in ACCELS:
            tree(runner, scene, way)
