# left_out.py - what leaving out saves: cells and cycles of scenes, before and after
# SPDX-License-Identifier: Apache-2.0
"""Each scene with everything and without, at the profile and in the tree that the tool takes: the
cells of the core that the machine asks for, and its cycles a pixel in RTL with cold caches. Puts
the table `left_out` into PAGE. Before is --effects all; of a scene whose frame meets all that it
names, every effect that a user may switch on, on the core with everything."""
import json
import subprocess
import sys
from pathlib import Path

from . import run, scenes
from ..pages.place import place
from ..synth import results

MET = ("behind", "hidden_mirror", "light_below", "clear_behind")
SCENES = [(name, f"tests/scenes/met/{name}.nff", ["--effects", "all"]) for name in MET] + [
    ("texture/hall", "scenes/texture/hall.nff", None)]
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
    for name, scene, everything in SCENES:
        files = [str(folder / f"{name.replace('/', '.')}-{when}.sph") for when in ("all", "met")]
        profile, own = machine(tool, scene, [], files[1])
        after = [profile, own]
        options = scenes.forced(["--profile", profile]) if everything is None else everything
        before = list(machine(tool, scene, options, files[0]))
        if everything is None:
            before[1] = scenes.whole(own)
        rows += [[name if file == files[0] else "", when, *of[:1], f"`{of[1]}`",
                  *measured(build, file, *of)]
                 for file, when, of in zip(files, ("with all", "left out"), (before, after))]
    place(page, "make left-out", {"left_out": [HEAD] + rows})
