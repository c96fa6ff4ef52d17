# scenes.py - machines of every scene for `make effects`, and the lists of their cores
# SPDX-License-Identifier: Apache-2.0
"""Leaves in FOLDER, for each scene of scenes/ and its folders, of scenes/effects those that are
simulated in full or show one effect: NAME.sph as the scene asks, NAME.forced.sph with every effect
forced on, NAME.build.json, both rewritten only if they changed; lists: what is to be synthesised;
scenes: names in the order of the report, with a point for the stroke of a folder."""
import json
import os
import subprocess
from pathlib import Path

from .. import intact
from ..synth import results
from ..synth.results import key
from . import asks

SIZE, PROFILE, SECONDS = "160x90", "standard", 75
MORE = ("texture", "refract", "specular", "sum")  # what `all` has not
WHOLE = "+".join(("all",) + MORE)
# the whole core without one of them; without sum there are no highlights either
PRICED = {"texture": "all+refract+specular+sum", "refract": "all+texture+specular+sum",
          "specular": "all+texture+refract+sum", "sum and specular": "all+texture+refract",
          "texture, refract, specular and sum": "all"}


def names(which):
    """Words of the list of effects: those of the core `all`, those that have a count."""
    ran = subprocess.run(["sim/cores.py", "parameters", "--names", which], check=True,
                         stdout=subprocess.PIPE)
    return ran.stdout.decode().split()


def whole(cores):
    """The core with everything that draws what a core draws."""
    words = cores.split("+")
    more = WHOLE if set(words) & set(MORE) else "all"
    return more + "".join("+" + word for word in ("smooth", "clear", "spread", "bih", "boxes",
                                                  "turned") if word in words)


def scenes():
    """(name, file, options) of each scene."""
    rows = [(name, f"scenes/{name}.nff", ["--accel=bvh4"]) for name in asks.scenes()]
    for name, kind, options, _ in asks.listed():
        if kind in ("full", "pair") or "_" not in name:
            rows.append(("effects/" + name, asks.file_of(name),
                         [] if options == "-" else options.split(",")))
    return [(name.replace("/", "."), scene, options) for name, scene, options in rows]


def forced(options):
    """The same machine with everything on that a user may switch on without another picture."""
    more = ["--shadow=on", "--reflect=on", "--inside=on"]
    return options + more + (["--interpenetrate=on"] if "--traverse=first" in options else [])


def build(tool, scene, options, machine):
    """Builds the machine; the report of build. An unchanged file keeps its time."""
    with intact.beside(machine, anew=True) as new:
        made = subprocess.run([tool, "build", scene, "--profile", PROFILE, "--size", SIZE, *options,
                               "--effects", "all", "-o", new, "--json", "-"], check=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return json.loads(made.stdout)


def core_list(tool, machine):
    info = subprocess.run([tool, "info", machine], check=True, stdout=subprocess.PIPE).stdout
    return next(line.split()[1] for line in info.decode().splitlines() if line.startswith("core "))


def cores(build):
    """Synthesises the lists that main() has left."""
    results.synthesise(build, Path(build, "effects/lists").read_text(encoding="utf-8").split())


def main(tool, folder, synth):
    os.makedirs(folder, exist_ok=True)
    wanted = ["all", "none", WHOLE, *PRICED.values()]
    wanted += ["all-" + name for name in names("all")]
    built = []
    for name, scene, options in scenes():
        base = f"{folder}/{name}"
        report = build(tool, scene, options, base + ".sph")
        build(tool, scene, forced(options), base + ".forced.sph")
        cores = core_list(tool, base + ".sph")
        report.update(scene=scene, options=options, list=cores, whole=whole(cores))
        Path(base + ".build.json").write_text(json.dumps(report, indent=1), encoding="utf-8")
        wanted += [cores, whole(cores)]
        built.append(name)
    for old in Path(folder).glob("*.sph"):
        if old.stem.removesuffix(".forced") not in built:
            old.unlink()
    Path(folder, "scenes").write_text("\n".join(built) + "\n", encoding="utf-8")
    wanted = list(dict.fromkeys(wanted))
    Path(folder, "lists").write_text(" ".join(wanted) + "\n", encoding="utf-8")
    there = sum(os.path.exists(f"{synth}/{key(PROFILE, w)}/stat.json") for w in wanted)
    print(f"effects: {len(built)} scenes; {len(wanted)} cores to synthesise, {there} of them were "
          f"before.\n  What is new takes about {SECONDS} s of a processor a core, "
          f"{len(wanted) * SECONDS // 60} minutes for all,\n  and about half a minute a scene.",
          flush=True)
