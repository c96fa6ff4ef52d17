# runs.py - what the tables of docs/results/texture_results.md are made of, in BUILD/textures
# SPDX-License-Identifier: Apache-2.0
"""For each scene NAME and filter WAY (nearest, off, level, between):
  NAME-WAY.png, .rms         picture of the model, and how far it is from NAME-truth.tif
  NAME-WAY.json              `sphaera texels`: texels of each level, hits of caches
  NAME-WAY-rtl.json          the same at the size of the RTL's frames
  NAME-WAY.core.json         report of the RTL's run; robot-WAY-slow: memory latency SLOW
  NAME-small-WAY-STALL.core.json  of a small frame, memory not ready in STALL percent of clocks
  NAME-fine-WAY-MEMORY.core.json  of a part of a frame of the paper's size, memory MEMORY
  NAME-fine-WAY.info.json    what that machine is; NAME-fine-WAY.json: its texels, whole frame
  NAME-walk.json             P_b of the first frames
  NAME-lodN.png, .rms        with N bits of fraction in the level
  NAME.levels.json           `sphaera accuracy`: arithmetic of the ways to choose a level
  slant-N.json               levels against the angle, views of slant.nff; slant-ball.json
NAME-truth.tif: TRUTH x TRUTH samples a pixel without MIP-mapping, the mean of them."""
import glob
import math
import os
import shutil
from pathlib import Path

from .. import intact
from ..tasks import Task, core, run, tool
from . import page

OF = ("cmodel/**/*.[ch],cmodel/**/*.cpp,cmodel/machine/*.def,rtl/*/*.v,rtl/*/*.vh,"
      "scenes/texture/*,lab/textures/runs.py")
NAMES = "kitchen", "robot", "museum"
FILTERS = {"nearest": "nearest", "off": "bilinear", "level": "level", "between": "between"}
DRAWN = "off", "level", "between"
WIDTH, HEIGHT, TRUTH = 480, 270, 8
SIZE, RTL, SLOW = f"{WIDTH}x{HEIGHT}", "160x90", "200"
EFFECTS = "shadow+reflect2+lights2+inside+facets+texture+spread+turned+boxes"
SMALL = "80x45"                                         # memory that is slow in bytes
FINE, WINDOW = "800x480", "360,216,440,264"             # the paper's pixels: a part of its frame
# what of a picture is shown: width x height + left + top
CROP = {"kitchen": "150x100+10+95", "robot": "150x100+320+85", "museum": "190x120+160+55"}
SLANTS = 89, 75, 60, 45, 30, 16, 5     # degrees of view below the horizon
SHOWN = "docs/pictures/textures"


def truth(build, target, name, source):
    def draw():
        large = target.replace("-truth.tif", "-large.png")
        run([f"{build}/sphaera", "render", source[0], "--profile", "standard", "--filter",
             "bilinear", "--transfer", "linear", "-o", large, "--size",
             f"{WIDTH * TRUTH}x{HEIGHT * TRUTH}"], f"{target}.log")
        run(["oiiotool", large, "--resize:filter=box", SIZE, "-d", "float", "-o", target],
            f"{target}.log")
        os.remove(large)
    return Task(target, [*source, f"{build}/sphaera"], draw, f"TRUE {name}")


def distance(target, picture, true):
    """How far a picture is from the truth, as oiiotool tells it."""
    return Task(target, [picture, true], ["oiiotool", "--diff", "--fail", "1", "--hardfail", "2",
                                          picture, true], prints=True)


def view(slant, target):
    """A narrow view of the floor: `at` is 1 away from the eye, 2 above it; or one of the ball,
    which fills a wider view."""
    def write():
        down = math.radians(slant) if slant != "ball" else 0
        at, angle = ("-1.4 0.7 -1.3", 40) if slant == "ball" else \
            (f"0 {2 - math.sin(down):.6g} {-math.cos(down):.6g}", 16)
        new = {"at": f"at {at}", "angle": f"angle {angle}"}
        lines = Path("scenes/texture/slant.nff").read_text(encoding="utf-8").splitlines()
        ground = Path(target).parent / "ground.png"
        if not ground.exists():
            shutil.copy("scenes/texture/ground.png", ground)
        intact.write(target, "".join(new.get(line.partition(" ")[0], line) + "\n"
                                     for line in lines))
    return Task(target, ["scenes/texture/slant.nff"], write)


def tasks(build):
    at = f"{build}/textures"
    images = sorted(glob.glob("scenes/texture/*.png"))
    found = []

    def of_model(target, source, command, *words, say="", prints=False):
        found.append(tool(build, f"{at}/{target}", source, command, source[0], *words, say=say,
                          prints=prints))

    def machine(name, way, source, size, *words):
        of_model(f"{name}.sph", source, "build", "--profile", "standard", *words, "--size", size,
                 "--filter", FILTERS[way], "-o", f"{at}/{name}.sph")

    def simulated(name, stem, *options):
        found.append(core(build, f"{at}/{name}.core.json", f"{at}/{stem}.sph", *options,
                          EFFECTS=EFFECTS, say=f"SIM {name}"))

    for name in NAMES:
        source, true = [f"scenes/texture/{name}.nff", *images], f"{at}/{name}-truth.tif"
        found.append(truth(build, true, name, source))
        for way, kind in FILTERS.items():
            both = f"{name}-{way}"
            of_model(f"{both}.png", source, "render", "--profile", "standard", "--size", SIZE,
                     "--transfer", "linear", "--filter", kind, "-o", f"{at}/{both}.png")
            found.append(distance(f"{at}/{both}.rms", f"{at}/{both}.png", true))
            for end, size in ("", SIZE), ("-rtl", RTL):
                of_model(f"{both}{end}.json", source, "texels", "--profile", "standard", "--size",
                         size, "--filter", kind, "--json", f"{at}/{both}{end}.json",
                         say="" if end else f"TEXL {both}")
            machine(both, way, source, RTL)
            simulated(both, both)
            if name == page.SLOW and way in DRAWN:
                simulated(f"{both}-slow", both, "--latency", SLOW)
        for bits in page.BITS:
            picture = f"{at}/{name}-lod{bits}.png"
            of_model(f"{name}-lod{bits}.png", source, "render", "--profile", "standard", "--size",
                     SIZE, "--lod-bits", str(bits), "--transfer", "linear", "-o", picture)
            found.append(distance(f"{at}/{name}-lod{bits}.rms", picture, true))
        of_model(f"{name}.levels.json", source, "accuracy", "--profile", "standard", "--size", SIZE,
                 "--json", f"{at}/{name}.levels.json", say=f"LEVL {name}")
        # seen, in this order: without, nearest level, two levels, the truth
        shown = [*(f"{at}/{name}-{way}.png" for way in DRAWN), true]
        found.append(Task(f"{SHOWN}/{name}.png", shown, [
            "oiiotool", *(w for p in shown for w in (p, "--cut", CROP[name])), "--mosaic:pad=2",
            "4x1", "-d", "uint8", "-o", f"{SHOWN}/{name}.png"]))
    # Figure 2 as the paper has it: its pixels, MIP off and on, as people see light
    kitchen, halves = ["scenes/texture/kitchen.nff", *images], []
    for way in "off", "between":
        halves.append(f"{at}/figure2-{way}.png")
        of_model(f"figure2-{way}.png", kitchen, "render", "--profile", "standard", "--size", FINE,
                 "--filter", FILTERS[way], "-o", halves[-1])
    found.append(Task(f"{SHOWN}/figure2.png", halves, [
        "oiiotool", *halves, "--mosaic:pad=4", "2x1", "-o", f"{SHOWN}/figure2.png"]))
    for name in page.STALLED:
        source = [f"scenes/texture/{name}.nff", *images]
        for way in DRAWN:
            small, fine = f"{name}-small-{way}", f"{name}-fine-{way}"
            machine(small, way, source, SMALL, "--accel", "box4")
            for stall in page.STALLS:
                simulated(f"{small}-{stall}", small, "--stall", str(stall))
            machine(fine, way, source, FINE, "--accel", "box4")
            for end, command in (".info.json", "info"), (".json", "texels"):
                of_model(fine + end, [f"{at}/{fine}.sph"], command, "--json", f"{at}/{fine}{end}")
            for memory in page.MEMORIES:
                kind, mhz = memory.split("_")
                simulated(f"{fine}-{memory}", fine, "--memory", kind, "--core-mhz", mhz, "--window",
                          WINDOW)
    walk = [f"scenes/texture/{page.SLOW}.nff", *images]
    of_model(f"{page.SLOW}-walk.json", walk, "build", "--profile", "standard", "--size", SIZE,
             "--frames", "0..2", "-o", f"{at}/{page.SLOW}-views.sph", "--json",
             f"{at}/{page.SLOW}-walk.json")
    for slant in *SLANTS, "ball":
        scene = f"{at}/views/slant-{slant}.nff"
        found.append(view(slant, scene))
        of_model(f"slant-{slant}.json", [scene, *images], "accuracy", "--profile", "standard",
                 "--json", f"{at}/slant-{slant}.json", "--size",
                 "192x108" if slant == "ball" else "96x54")
    drawn = [f"{at}/{name}-between.png" for name in NAMES]
    return found + [Task(f"{SHOWN}/scenes.png", drawn, [
        "oiiotool", *(w for p in drawn for w in (p, "--resize", "256x144")), "--mosaic:pad=2",
        "3x1", "-d", "uint8", "-o", f"{SHOWN}/scenes.png"])]
