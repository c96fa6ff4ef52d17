# measure.py - runs what the tables of docs/results/papers.md are made of, once
# SPDX-License-Identifier: Apache-2.0
"""PART: functions of this file, all if none is named. Leaves NAME.json in FOLDER for each run of
the model, NAME.core.json for those of the RTL. A result that is younger than the tool is kept."""
import math
import os
import re
import shutil
import subprocess

from .. import intact, tree_options
from ..pages import whole
from ..runner import Runner as Runs
from . import scenes

# spheres at random, and in a column: how many
RANDOM = [256, 1000, 4096, 10000, 100000, 1000000]
COLUMN = [16, 64, 256, 1024, 4096]
SEARCHED = ["paper5", "paper100", *(f"random{n}" for n in RANDOM), *(f"column{n}" for n in COLUMN)]
# what is tried instead of spheres: boxes, icospheres that were cut so many times
SHAPES = ["box", "1", "2", "3"]
REPLACED = ["paper5", "paper100", "sphereflake2"]
# cores that draw them; their cells are those that `make synth EFFECTS=` left
SHAPES_CORE = {"sphere": "shadow+reflect4+lights3+inside",
               "facet": "shadow+reflect4+lights3+inside+facets+turned+boxes"}
SEARCH = ["--tree", "paper", "--traverse", "first", "--interpenetrate", "off", "--depth", "0",
          "--shadow", "off"]
FIRST = ["--tree", "paper", "--traverse", "first", "--interpenetrate"]
CORRECTED = {"nearest": [], "first": [*FIRST, "off"], "mended": [*FIRST, "on"]}
# frames of which the view meets a corner, by SHIFTED heights, against their part of a picture of
# twice the width and three times the height, in which it meets the middle; how often they are tried
MOVED = {"oblique": "scenes/oblique.nff", "paper100": "scenes/paper100.nff",
         "room": "scenes/facets/room.nff", "water": "scenes/refraction/water.nff"}
SHIFTED, MOVED_SIZE = (1 / 4, 1 / 3), (320, 180)
# one core for the three parts of the paper's machine; its frame has 160x90 pixels
PARTS, PARTS_CORE = ["paper5", "paper100"], "shadow+reflect2+lights1+inside"
DEPTHS = [0, 1, 2]
# as many reflections as most scenes here are drawn with, and ten, by one core
BOUNCES, BOUNCES_CORE = [2, 10], "shadow+reflect10+lights2+inside+facets+texture+spread+bih"
BOUNCED = {"kitchen": "scenes/texture/kitchen.nff", "mirrors": "tests/scenes/mirrors.nff"}
# where a record of P_b alone is asked for, as many pixels as the texture paper's tables here have
MAPPED = ["kitchen", "hall", "museum", "robot"]
FIELD = 200  # a side of the ground, twice its square triangles
# what the scenes of the texture paper ask for, and its ten bounces: synthesised, not run
PARK_CORE = "shadow+reflect10+lights6+facets+texture+smooth+clear+turned+boxes"
# a hierarchy of 64 spheres: MAX_PRIMS, MAX_TREE_DEPTH; brute force beside them
LEAVES = [1, 2, 4, 8, 16, 32, 64]
LEVELS = [1, 2, 3, 4, 5, 6, 7]
# ways to choose a level: path length, BMRT's estimate, ray differentials
WAYS = ["mended", "bmrt", "rays"]
# the thesis's three scenarios, with as many spheres as its Figure 4.4 has
SCENARIOS = {"scenario1": 64, "scenario2": 128, "scenario3": 256}
# where the model's instructions go: scenes and their trees
PROFILED = {"paper100": [], "random4096": [], "lattice64": tree_options.options("bih8")}


class Runner(Runs):
    def keep(self, name, *words, good=(0,)):
        """What a command reports."""
        if self.fresh(name + ".json"):
            return
        print("  RUN ", name, flush=True)
        intact.write(self.path(name + ".json"), self.run(*words, "--json", "-", good=good))

    def made(self, name, lines):
        path = self.path(name + ".nff")
        intact.write(path, "\n".join(lines) + "\n")
        return path

    def core(self, name, effects, scene, *how):
        """A machine through the RTL, with cold and with warm caches."""
        if not self.fresh(name + ".core.json", *whole.RTL):
            self.run("build", scene, "--profile", "standard", *how, "-o", self.path(name + ".sph"))
            self.simulate(name, effects, 20)

    def random(self, n):
        path = self.path(f"random{n}.nff")
        if not os.path.exists(path):
            self.run("gen", "random", "-n", str(n), "-o", path)
        return path


def operations(run):
    for scene in "paper5", "views/inside":
        run.keep("operations-" + os.path.basename(scene), "operations", f"scenes/{scene}.nff",
                 "--size", "64x36", "--profile", "standard")


def search(run):
    """The paper's tree and its walk, primary rays alone."""
    found = {"paper5": "scenes/paper5.nff", "paper100": "scenes/paper100.nff"}
    found.update({f"random{n}": run.random(n) for n in RANDOM})
    found.update({f"column{n}": run.made(f"column{n}", scenes.column(n)) for n in COLUMN})
    for name, scene in found.items():
        run.keep("search-" + name, "render", scene, *SEARCH, "--size", "64x36", "--profile",
                 "reference")


def corrected(run):
    """The nearest hit, the first one, and the first one mended; five spheres beside them."""
    run.keep("drawn-paper5", "render", "scenes/paper5.nff", "--size", "320x180", "-o",
             run.path("paper5.png"))
    for name, scene in (("hidden", run.made("hidden", scenes.hidden())),
                        ("paper100", "scenes/paper100.nff")):
        for way, how in CORRECTED.items():
            frame = run.path(f"{name}-{way}.frame")
            run.keep(f"corrected-{name}-{way}", "render", scene, *how, "--size", "320x180",
                     "--profile", "fine", "--frame", frame, "-o", run.path(f"{name}-{way}.png"))
            if way != "nearest":
                run.keep(f"differ-{name}-{way}", "compare", "--ignore-work", frame,
                         run.path(f"{name}-nearest.frame"), good=(0, 1))


def ppm(path):
    with open(path, "rb") as f:
        data = f.read()
    return data.split(b"\n255\n", 1)[1]


def psnr(one, other):
    square = sum((a - b) ** 2 for a, b in zip(ppm(one), ppm(other))) / len(ppm(one))
    return 10 * math.log10(255 ** 2 / square) if square else math.inf


def shapes(run):
    """Spheres, and what others draw instead, against the spheres as they are written."""
    for scene in REPLACED:
        path = f"scenes/{scene}.nff"
        truth = run.path(f"{scene}-truth.ppm")
        view = ["--size", "160x90", "--transfer", "linear", "-o"]
        if not run.fresh(f"{scene}-truth.ppm"):
            run.run("reference", path, *view, truth)
        for shape in ["sphere", *SHAPES]:
            name = f"shape-{scene}-{shape}"
            picture = run.path(name + ".ppm")
            made = path if shape == "sphere" else run.made(name, scenes.replaced(path, shape))
            if not run.fresh(name + ".psnr"):
                run.keep(name, "render", made, "--profile", "reference", *view, picture)
                intact.write(run.path(name + ".psnr"), f"{psnr(truth, picture):.2f}\n")
            run.core(name, SHAPES_CORE["sphere" if shape == "sphere" else "facet"], made, "--size",
                     "48x27")


def moved(run):
    """An oblique frustum: the model by the registers of its first ray, the double reference as a
    part of a picture that is none, and the RTL beside the model."""
    width, height = MOVED_SIZE
    left, top = width // 2 + round(SHIFTED[0] * height), height - round(SHIFTED[1] * height)
    aside = "--shift", ",".join(map(repr, SHIFTED))
    for name, scene in MOVED.items():
        path, cut, picture = (run.path(f"moved-{name}{part}") for part in
                              ("-wide.nff", "-part.ppm", ".ppm"))
        if not run.fresh(f"moved-{name}.psnr"):
            wide = path.replace(".nff", ".ppm")
            intact.write(path, scenes.wider(scene, 3))
            run.keep("moved-" + name, "render", scene, "--profile", "standard", *aside, "--size",
                     f"{width}x{height}", "--transfer", "linear", "-o", picture)
            run.run("reference", path, "--size", f"{2 * width}x{3 * height}", "--transfer",
                    "linear", "-o", wide)
            subprocess.run(["oiiotool", wide, "--cut", f"{width}x{height}+{left}+{top}", "-o",
                            cut], check=True)
            intact.write(run.path(f"moved-{name}.psnr"), f"{psnr(cut, picture):.2f}\n")
        straight = run.path(f"straight-{name}.ppm")
        if not run.fresh(f"straight-{name}.psnr"):
            view = ["--size", f"{width}x{height}", "--transfer", "linear", "-o"]
            plain = run.made(f"straight-{name}", scenes.wider(scene, 1).split("\n"))
            run.run("render", plain, "--profile", "standard", *view, straight)
            run.run("reference", plain, *view, cut)
            intact.write(run.path(f"straight-{name}.psnr"), f"{psnr(cut, straight):.2f}\n")
    run.core("moved-oblique", PARTS_CORE, MOVED["oblique"], "--size", "64x36")


def parts(run):
    """Rendering, L1 and L2: frames of one depth each, by one core."""
    for scene in PARTS:
        for depth in DEPTHS:
            run.core(f"parts-{scene}-{depth}", PARTS_CORE, f"scenes/{scene}.nff", "--size",
                     "160x90", "--depth", str(depth))


def bounces(run):
    """Ten reflections one after another, as the texture paper has them, beside two."""
    for scene, path in BOUNCED.items():
        for depth in BOUNCES:
            run.core(f"bounces-{scene}-{depth}", BOUNCES_CORE, path, "--size", "48x27", "--accel",
                     "bih", "--axes", "camera", "--depth", str(depth))


def bases(run):
    """P_b apart from the mapping record: what caches of such lines would miss, 16 P_b in a line."""
    found = {name: f"scenes/texture/{name}.nff" for name in MAPPED}
    shutil.copy(f"scenes/texture/{scenes.IMAGE}", run.path(scenes.IMAGE))
    found["field"] = run.made("field", scenes.field(FIELD))
    for name, scene in found.items():
        run.keep("bases-" + name, "texels", scene, "--profile", "standard", "--size", "480x270",
                 "--filter", "level")


def leaves(run):
    """The thesis's two parameters of a hierarchy, and brute force by the same core."""
    scene = run.path("lattice64.nff")
    if not run.fresh("lattice64.nff"):
        run.run("gen", "scenario1", "-n", "64", "--plain", "-o", scene)
    ways = {f"prims{n}": tree_options.options(f"bih{n}") for n in LEAVES}
    ways.update({f"levels{n}": tree_options.options("bih1") + ["--max-tree-depth", str(n)]
                 for n in LEVELS})
    ways["brute"] = tree_options.options("brute")
    for name, how in ways.items():
        run.core(f"leaves-{name}", "lights1+facets+bih", scene, *how, "--size", "40x68",
                 "--depth", "0", "--shadow", "off")


def ways(run):
    """A floor to the horizon, in a flat mirror and in a ball: by each way to choose a level, and as
    the mean of 8 x 8 samples of the whole image, levels-*.exr; the last eight times as wide."""
    how = {way: ["--levels", way, "--size", "240x135"] for way in WAYS}
    how["samples"] = ["--filter", "nearest", "--size", "1920x1080"]
    for way, words in how.items():
        picture = run.path(f"levels-{way}.exr")
        if not run.fresh(f"levels-{way}.exr"):
            print("  RUN  levels-" + way, flush=True)
            run.run("reference", "scenes/texture/slant.nff", *words, "-o", picture)
    for way in WAYS:
        said = subprocess.run(["oiiotool", run.path(f"levels-{way}.exr"), "--ch", "R,G,B",
                               run.path("levels-samples.exr"), "--ch", "R,G,B",
                               "--resize:filter=box", "240x135", "--diff"], check=False,
                              stdout=subprocess.PIPE, text=True).stdout
        intact.write(run.path(f"levels-{way}.rms"),
                     re.search(r"RMS error = ([0-9.]+)", said)[1] + "\n")


def scenarios(run):
    """Pictures of the thesis's scenarios."""
    for name, n in SCENARIOS.items():
        scene = run.path(name + ".nff")
        if not run.fresh(name + ".png"):
            print("  RUN ", name, flush=True)
            run.run("gen", name, "-n", str(n), "-o", scene)
            run.run("render", scene, "--size", "640x1088", "--depth", "4", "-o",
                    run.path(name + ".png"))


def profile(run):
    """The share of a frame's instructions that the search for intersections takes, in the literal
    model, as Valgrind counts them: NAME.profile. Without Valgrind the last figures stay."""
    if not shutil.which("valgrind"):
        print("measure: no valgrind here (`make papers-setup` installs it): no profile", flush=True)
        return
    for name, how in PROFILED.items():
        if run.fresh(name + ".profile"):
            continue
        print("  PROF", name, flush=True)
        machine, counted = run.path(name + "-profile.sph"), run.path(name + ".callgrind")
        scene = "scenes/paper100.nff" if name == "paper100" else run.path(name + ".nff")
        run.run("build", scene, "--profile", "standard", "--size", "64x36", *how, "-o", machine)
        subprocess.run(["valgrind", "-q", "--tool=callgrind", "--callgrind-out-file=" + counted,
                        run.tool, "render", machine, "--literal", "--threads", "1", "--frame",
                        machine + ".frame"], stdout=subprocess.DEVNULL, check=True)
        lines = subprocess.run(["callgrind_annotate", "--inclusive=yes", counted], check=True,
                               stdout=subprocess.PIPE, text=True).stdout
        spent = {function: int(count.replace(",", "")) for count, function in
                 re.findall(r"^ *([0-9,]+) .*:(sph_\w+) \[", lines, re.M)}
        intact.write(run.path(name + ".profile"),
                     f"{100 * spent['sph_traverse'] / spent['sph_render']:.0f}\n")


PARTS_OF = {part.__name__: part for part in (operations, search, corrected, shapes, moved, parts,
                                             bounces, bases, leaves, ways, scenarios, profile)}


def main(tool, folder, *names):
    run = Runner(tool, folder)
    for name in names or PARTS_OF:
        PARTS_OF[name](run)
