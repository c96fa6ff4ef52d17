# left_out.py - what leaving out saves: cells and cycles of scenes, before and after
# SPDX-License-Identifier: Apache-2.0
"""Each scene with all that it names (--effects all) and without what no ray of its frame meets, at
the profile and in the tree that the tool takes: the cells of the core that the machine asks for,
its cycles a pixel in RTL with cold caches, and those of the same machine on the core with
everything. Puts the table `left_out` into PAGE."""
import json
import subprocess
import sys
from pathlib import Path

from . import run, scenes
from ..pages.place import place
from ..synth import results

# of the last nothing is left out
SCENES = ("tests/scenes/met.nff:behind", "tests/scenes/met.nff:hidden_mirror",
          "tests/scenes/met.nff:light_below", "scenes/texture/hall.nff")
HEAD = ["scene", "", "profile", "core", "LUT4eq", "MULT", "DP16KD", "cycles a pixel",
        "on the whole core"]
COLUMNS = ("lut4eq", "mult", "bram")
WIDTH, HEIGHT = map(int, scenes.SIZE.split("x"))


def machine(tool, scene, options, file):
    """Builds it; its profile, and the core that it asks for."""
    made = subprocess.run([tool, "build", scene, "--size", scenes.SIZE, *options, "-o", file,
                           "--json", "-"], check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL)
    return json.loads(made.stdout)["machine"]["profile"], scenes.core_list(tool, file)


def cycles(file, core):
    """A pixel of the machine, on a core."""
    return f"{run.simulate(run.core(core, file), file)[0]['cycles'] / (WIDTH * HEIGHT):.2f}"


def measured(build, file, profile, core):
    """Cells and cycles a pixel of a machine on its core, and cycles on the one with everything."""
    print(f"  SYNTH {results.key(profile, core)}", file=sys.stderr, flush=True)
    results.synthesise(build, [core], PROFILES=profile)
    cells = results.read(Path(build, "synth", results.key(profile, core)))["core"]
    whole = scenes.whole(core) + "+camera" * ("camera" in core.split("+"))
    return [*(str(cells[name]) for name in COLUMNS), cycles(file, core), cycles(file, whole)]


def main(tool, build, page):
    folder = Path(build, "left_out")
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for scene in SCENES:
        name = Path(scene.rpartition(":")[2]).stem
        before = None
        for which, when in (("all", "with all"), ("met", "left out")):
            file = folder / f"{name}-{which}.sph"
            profile, core = machine(tool, scene, ["--effects", which], file)
            if core == before:
                rows[-1][1] = "nothing left out"
                continue
            before = core
            rows.append([name if which == "all" else "", when, profile, f"`{core}`",
                         *measured(build, file, profile, core)])
    place(page, "make left-out", {"left_out": [HEAD] + rows})
