# runs.py - Table I of the texture paper on its scenes: docs/results/texture_results.md
# SPDX-License-Identifier: Apache-2.0
"""The folder BART of the environment has scene_kitchen, scene_museum and scene_robot as BART's
authors pack them: aff/ and TextureFiles/ in each. Nothing of it is kept but figures. BUILD/bart
holds, for each scene NAME, frame AT of its animation and filter WAY (off, level, between):
  NAME-AT.json, .png         machine with every light, and `sphaera render`: counters
  NAME-AT-WAY.json           `sphaera texels`: levels, hits of caches; light rays fetch no texel
  NAME-AT-WAY.core.json      the RTL on WINDOW of the frame in the middle, memory MEMORY
  NAME-AT-pipesN.core.json   the RTL on that whole frame, a core of N pipes and SIZES
  NAME.levels.json           `sphaera accuracy` of a small frame: operations of a decision
  NAME.sequence.json         frames one behind the other: P_b kept, times"""
import os
import re
import sys
from collections import namedtuple
from pathlib import Path

from ..tasks import Task, core, run
from ..textures.runs import FILTERS
from . import page

# top: its file; frames of its animation, the one in the middle, and some in a row
Scene = namedtuple("Scene", "top frames middle row")
SOME = 50, 150, 250, 350, 400, 550, 650, 750
SCENES = {
    "kitchen": Scene("scene_kitchen/aff/kitchen.aff", SOME, 400, None),
    "robot": Scene("scene_robot/aff/Robot.aff", SOME, 400, "398..401"),
    "museum": Scene("scene_museum/aff/museum5.aff", (18, 56, 93, 150, 168, 206, 243, 281), 150,
                    "148..151")}
SIZE, SMALL, WINDOW = "800x480", "80x48", "320,192,480,288"
EFFECTS = "shadow+reflect2+lights6+facets+smooth+clear+turned+texture+boxes"    # one core for all
# triangles take long, so more rays are on their way; and there are many of them
SIZES = "slots=128,node_lines=1024,leaf_lines=1024"
MEMORY = ["--memory", "ddr3x16", "--core-mhz", "84"]


def folder():
    """Of the scenes."""
    found = os.environ.get("BART", "")
    if not found:
        sys.exit("bart: BART names no folder: make bart BART=FOLDER")
    for scene in SCENES.values():
        if not Path(found, scene.top).is_file():
            sys.exit(f"bart: BART={found} has no {scene.top}")
    return found


def tasks(build):
    at, path, scenes = f"{build}/bart", f"{build}/sphaera", folder()
    found = []

    def of_model(target, name, command, *words, profile=True, say=""):
        """All frames of a scene have the profile that the middle one asks for, so one core draws
        them."""
        known = f"{at}/{name}.profile"

        def make():
            chosen = re.search(r"^profile *([a-z]*)", Path(known).read_text("utf-8"), re.M)[1]
            run([path, command, f"{scenes}/{SCENES[name].top}", *words, "--profile", chosen],
                f"{target}.log")
        found.append(Task(target, [known], make, say))

    def simulated(stem, machine, pipes, *options):
        target = f"{at}/{stem}.core.json"
        found.append(core(build, target, f"{at}/{machine}.sph", *MEMORY, *options, "--watchdog",
                          "10000000", EFFECTS=EFFECTS, PIPES=str(pipes), SIZES=SIZES,
                          say=f"SIM {stem}"))

    for name, scene in SCENES.items():
        top, known, middle = f"{scenes}/{scene.top}", f"{at}/{name}.profile", str(scene.middle)

        def profile(top=top, known=known, middle=middle):
            run([path, "build", top, "--at", middle, "--size", SIZE, "-o", f"{known}.sph"], known)
            os.remove(f"{known}.sph")
        found.append(Task(known, [path], profile))
        of_model(f"{at}/{name}.levels.json", name, "accuracy", "--at", middle, "--size", SMALL,
                 "--json", f"{at}/{name}.levels.json", say=f"LEVL {name}")
        if scene.row:
            of_model(f"{at}/{name}.sequence.json", name, "render", "--frames", scene.row, "--size",
                     SIZE, "-o", f"{at}/{name}-row.png", "--json", f"{at}/{name}.sequence.json",
                     say=f"ROW {name}")
        for frame in scene.frames:
            stem = f"{name}-{frame}"
            for way in page.MIP:
                of_model(f"{at}/{stem}-{way}.json", name, "texels", "--at", str(frame), "--size",
                         SIZE, "--shadow", "off", "--filter", FILTERS[way], "--json",
                         f"{at}/{stem}-{way}.json", say=f"TEXL {stem}-{way}")
                if way == "between" or frame == scene.middle:
                    of_model(f"{at}/{stem}-{way}.sph", name, "build", "--at", str(frame), "--size",
                             SIZE, "-o", f"{at}/{stem}-{way}.sph", "--filter", FILTERS[way],
                             say=f"BART {stem}-{way}")
            machine = f"{at}/{stem}-between.sph"
            found.append(Task(f"{at}/{stem}.json", [machine], [
                path, "render", machine, "-o", f"{at}/{stem}.png", "--json", f"{at}/{stem}.json"],
                f"DRAW {stem}"))
        stem = f"{name}-{middle}"
        for way in page.MIP:
            simulated(f"{stem}-{way}", f"{stem}-{way}", 1, "--window", WINDOW)
        for pipes in page.PIPES:
            simulated(f"{stem}-pipes{pipes}", f"{stem}-between", pipes)
    return found


def tables(place, build):
    """docs/results/texture_results.md, from what is there."""
    page.main(place, f"{build}/bart", SIZE, *(
        f"{name}:{s.middle}:{','.join(map(str, s.frames))}" for name, s in SCENES.items()))
