# asks.py - what every scene asks for: the core that just draws it, as `sphaera info` says
# SPDX-License-Identifier: Apache-2.0
"""All that scenes name, whether rays of the frame meet it or not. Writes the lists of scenes/ and
its folders into docs/results/data/asks.tsv; those of scenes/effects stand in effects.txt there.
tests/builder/test_effects_scenes.c holds both."""
import subprocess
import tempfile
import textwrap
from pathlib import Path

from .. import intact

RECORD = Path("docs/results/data/asks.tsv")
EFFECTS = Path("scenes/effects/effects.txt")
HEAD = ("# asks.tsv - scene, core that it asks for: 64x36, two reflections, four children a node\n"
        "# SPDX-License-Identifier: Apache-2.0\n# written by lab/effects/asks.py\n")


def listed():
    """(name, what is simulated, options, core) of each line of effects.txt."""
    lines = EFFECTS.read_text(encoding="utf-8").splitlines()
    return [line.split() for line in lines if line and not line.startswith("#")]


def file_of(name):
    """The scene of such a line: its name without bih, which alone is the scene none."""
    name = "none" if name == "bih" else name.removesuffix("_bih")
    return f"scenes/effects/effects.nff:{name}"


def scenes():
    """Names of all scenes but those of scenes/effects, those without a folder first."""
    found = [path.relative_to("scenes") for path in Path("scenes").rglob("*.nff")
             if path.parent.name != "effects"]
    return sorted((str(path.with_suffix("")) for path in found), key=lambda n: ("/" in n, n))


def asked(tool, scene):
    """The list of a scene's machine."""
    with tempfile.TemporaryDirectory() as folder:
        machine = folder + "/machine.sph"
        subprocess.run([tool, "build", scene, "--profile", "standard", "--size", "64x36",
                        "--accel", "bvh4", "--effects", "all", "-o", machine],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        info = subprocess.run([tool, "info", machine], check=True, stdout=subprocess.PIPE,
                              text=True).stdout
    return next(line.split()[1] for line in info.splitlines() if line.startswith("core "))


def table():
    """Each core with the scenes of RECORD that ask for it, a paragraph a core."""
    found = {}
    for line in RECORD.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            name, core = line.split("\t")
            found.setdefault(core, []).append(f"`{name}`")
    return "\n".join(textwrap.fill(f"- `{core}`: {', '.join(names)}", 100, subsequent_indent="  ",
                                   break_on_hyphens=False)
                     for core, names in found.items())


def main(tool):
    intact.write(RECORD, HEAD + "".join(f"{name}\t{asked(tool, f'scenes/{name}.nff')}\n"
                                        for name in scenes()))
