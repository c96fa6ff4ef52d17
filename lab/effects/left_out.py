# left_out.py - what leaving out saves: cells and cycles of scenes, before and after
# SPDX-License-Identifier: Apache-2.0
"""Each scene with all that it names (--effects all) and without what no ray of its frame meets, at
the profile and in the tree that the tool takes: the cells of the core that the machine asks for,
and its cycles a pixel in RTL with cold caches. Puts the table `left_out` into PAGE."""
import json
import subprocess
import sys
from pathlib import Path

from . import run, scenes
from ..pages.place import place
from ..synth import results

SCENES = ("behind", "hidden_mirror", "light_below")     # of tests/scenes/met.nff
HEAD = ["scene", "", "profile", "core", "LUT4eq", "MULT", "DP16KD", "cycles a pixel"]
COLUMNS = ("lut4eq", "mult", "bram")
WIDTH, HEIGHT = map(int, scenes.SIZE.split("x"))


def machine(tool, scene, options, file):
    """Builds it; its profile, and the core that it asks for."""
    made = subprocess.run([tool, "build", scene, "--size", scenes.SIZE, *options, "-o", file,
                           "--json", "-"], check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL)
    return json.loads(made.stdout)["machine"]["profile"], scenes.core_list(tool, file)


def measured(build, file, profile, core):
    """Cells and cycles a pixel of a machine on a core."""
    print(f"  SYNTH {results.key(profile, core)}", file=sys.stderr, flush=True)
    results.synthesise(build, [core], PROFILES=profile)
    cells = results.read(Path(build, "synth", results.key(profile, core)))["core"]
    cycles = run.simulate(run.core(core, file), file)[0]["cycles"] / (WIDTH * HEIGHT)
    return [*(str(cells[name]) for name in COLUMNS), f"{cycles:.2f}"]


def main(tool, build, page):
    folder = Path(build, "left_out")
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for name in SCENES:
        for which, when in (("all", "with all"), ("met", "left out")):
            file = folder / f"{name}-{which}.sph"
            profile, core = machine(tool, f"tests/scenes/met.nff:{name}", ["--effects", which],
                                    file)
            rows.append([name if which == "all" else "", when, profile, f"`{core}`",
                         *measured(build, file, profile, core)])
    place(page, "make left-out", {"left_out": [HEAD] + rows})
