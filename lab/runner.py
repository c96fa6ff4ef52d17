# runner.py - commands that experiments run one after the other, and results that they keep
# SPDX-License-Identifier: Apache-2.0
import os
import re
import subprocess
import sys
from pathlib import Path

from . import intact
from .pages import whole

PROTEIN = "/usr/share/pymol/data/demo/1tii.pdb"


def said(*words, good=(0,), **variables):
    """What a command prints; the end if its exit code is none of the good ones."""
    words = [str(word) for word in words]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=dict(os.environ, **variables), check=False)
    if done.returncode not in good:
        sys.exit(f"{' '.join(words)}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def named(scene):
    """The file of a scene of scenes/, or FILE:NAME of a folder's file with several."""
    folder, _, name = scene.rpartition("/")
    shelf = Path("scenes", folder, f"{folder}.nff")
    return f"{shelf}:{name}" if folder and shelf.is_file() else f"scenes/{scene}.nff"


def text_of(scene):
    """The text of a scene file, or of FILE:NAME what all its scenes share and the own part."""
    file, _, name = str(scene).rpartition(":")
    if not file:
        return Path(scene).read_text(encoding="utf-8")
    shared, *parts = re.split(r"(?m)^scene[ \t]+", Path(file).read_text(encoding="utf-8"))
    return shared + next(part.partition("\n")[2] for part in parts if part.split()[0] == name)


def scene_file(tool, scene, made):
    """The file of a scene of scenes/, or of KIND:N of `sphaera gen` or protein, which is made."""
    if scene == "protein":
        said(tool, "import", PROTEIN, "-o", made)
    elif ":" in scene:
        said(tool, "gen", scene, "--seed", "1", "-o", made)
    else:
        return named(scene)
    return made


def core_name(name, pipes=1):
    """The file of a machine's run through the RTL."""
    return f"{name}.core{'' if pipes == 1 else pipes}.json"


class Runner:
    """Runs of the tool, whose results lie in a folder."""

    def __init__(self, tool, folder):
        self.tool, self.folder = tool, folder
        self.build = os.path.dirname(os.path.abspath(tool))
        os.makedirs(folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def fresh(self, name, *sources):
        """Whether a result is there, younger than the tool and the files of these patterns."""
        path = self.path(name)
        return os.path.exists(path) and os.path.getmtime(path) > os.path.getmtime(self.tool) \
            and bool(whole.there(path, *sources))

    def run(self, *words, good=(0,)):
        return said(self.tool, *words, good=good)

    def simulate(self, name, effects, latency, pipes=1):
        """The machine NAME.sph through the RTL, with cold and with warm caches: NAME.core.json,
        with several pipes NAME.coreN.json"""
        print("  SIM ", name, flush=True)
        with intact.beside(self.path(core_name(name, pipes))) as new:
            said("sh", "sim/core.sh", "--machine", self.path(name + ".sph"), "--warm", "--latency",
                 latency, "--json", new, EFFECTS=effects, PIPES=str(pipes), BUILD=self.build,
                 JOBS="1")
