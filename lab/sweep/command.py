# command.py - `sphaera sweep`: every value of some axes with every other, as tables and plots
# SPDX-License-Identifier: Apache-2.0
"""usage: sphaera sweep [FILE] [--AXIS VALUE...]... [OPTION...]
       BUILD=folder python3 -m lab sweep ... is the same; `sphaera sweep --help` has the options

Measures every point and writes, into a folder, sweep.csv, a row a point, and a plot of each figure
shown. FILE: spec.py. Names of files are from the folder FROM of the environment, which is where the
tool was called. Exit code: 0 all is measured, 1 something is missing or failed, 2 the sweep is not
understood."""
import hashlib
import json
import os
import sys

from .. import intact
from pathlib import Path
from . import axes, measures, plots, run, spec, table
from .axes import Wrong

OWN = {"out": "", "jobs": "", "engine": "", "list": None, "axes": None}  # None: no value


def taken(words):
    """(options of OWN, the other words)"""
    own, rest, at = {}, [], 0
    while at < len(words):
        name, equals, value = words[at][2:].partition("=")
        if not words[at].startswith("--") or name not in OWN:
            rest.append(words[at])
        elif OWN[name] is None:
            own[name] = "1"
        elif equals:
            own[name] = value
        else:
            at += 1
            if at == len(words):
                raise Wrong(f"--{name}: no value is given")
            own[name] = words[at]
        at += 1
    if not own.get("jobs", "1").isdecimal() or not 1 <= int(own.get("jobs", "1")) <= 1024:
        raise Wrong(f"--jobs: {own['jobs']} is no number of 1 to 1024")
    if own.get("engine", "make") not in ("make", "slurm"):
        raise Wrong(f"--engine: {own['engine']} is none of make, slurm"
                    f"{axes.perhaps(own['engine'], ['make', 'slurm'])}")
    return own, rest


def told():
    text = ""
    for name in axes.KNOWN:
        if name in axes.AXES:
            rule, _ = axes.variables.spoken(axes.RULES[name], axes.DEFINITION.constants)
            about = axes.TABLE.texts.get(name.upper(), ["reflections of the reference"])[0]
            usual = axes.DEFAULTS[name]
        elif name in axes.WIDTHS:
            rule, about = "..".join(map(str, axes.DEFINITION.bounds[name])), "bits of the profile"
            usual = ""
        else:
            size = axes.DEFINITION.sizes[name]
            rule, about, usual = f"{size.least}..{size.most}", size.about, size.standard
        shapes = [m for m, names in axes.SHAPES.items() if name in names]
        text += f"  {name:<15} {about}" + f": {rule}" * bool(rule)
        text += f" ({usual})" * bool(usual) + f"; {', '.join(shapes)}" * bool(shapes) + "\n"
    return text


def keys_of(tool, build):
    """What table.rows() asks: the key of a job, or why it cannot be."""
    own = {}

    def core(point):
        """(profile, effects) of the machine's own core, which auto stands for"""
        w = axes.words(axes.job("counts", **{n: v for n, v in point.items()
                                             if n in axes.SHAPES["counts"]}))
        key = json.dumps(w)
        if key not in own:
            report, no = measures.reported(tool, build, dict(w, effects="auto"), "build", "-o",
                                           os.devnull)
            own[key] = no or {"profile": report["machine"]["profile"],
                              "effects": report["machine"]["core"]}
        return own[key]

    def key(measure, point):
        plain = axes.folded(point)
        if measure == "cells" and "auto" in (plain.get("effects", "auto"),
                                             plain.get("profile")):
            if not plain.get("scene"):
                plain["effects"] = plain.get("effects", "all")
            found = core(plain) if plain.get("scene") else {}
            if "refused" in found:
                return found
            for name in ("profile", "effects"):
                if plain.get(name, "auto") == "auto":
                    plain[name] = found.get(name, plain.get(name))
        if measure in ("cycles", "cells"):
            w = {**axes.DEFAULTS, **plain}
            effects = "all" if w["effects"] == "auto" else w["effects"]
            profile = "draft" if w["profile"] == "auto" else w["profile"]
            try:
                axes.cores.key(profile, effects, environment=measures.variables(w))
            except Wrong as why:
                return {"refused": str(why)}
        return axes.job(measure, **plain)
    return key


def main(words):
    if not words or words[0] in ("--help", "-h", "-?", "--usage"):
        print(__doc__)
        return 0 if words else 2
    os.environ.setdefault("FROM", os.getcwd())
    try:
        return swept(*taken(words))
    except Wrong as why:
        print(f"sphaera sweep: {why}", file=sys.stderr)
        return 2


def swept(own, words):
    if "axes" in own:
        print(told(), end="")
        return 0
    wanted, file = spec.of_words(words)
    build = os.environ.get("BUILD") or "build"
    tool = f"{build}/sphaera"
    key = keys_of(tool, build)
    keys = [key(measure, point) for point in wanted.points for measure in wanted.measures]
    keys = list(dict.fromkeys(k for k in keys if isinstance(k, str)))
    if not os.path.exists(tool):
        raise Wrong(f"there is no {tool}: make tool")
    beside = wanted.said.get("beside", [""])[0]
    if beside:
        table.read(beside)  # before anything is run
    said = json.dumps([wanted.measures, wanted.points, wanted.said], sort_keys=True)
    name = hashlib.sha256(said.encode()).hexdigest()[:8]
    if file:
        name = f"{Path(file).stem}-{name}"
    if "list" in own:
        left = [k for k in keys if run.Results(run.folder(build)).look(k) is None]
        print(f"{len(wanted.points)} points, {len(keys)} jobs, {len(left)} to run: about "
              f"{sum(map(run.guess, left)):.0f} seconds of a processor")
        return 0
    os.environ.update({v: own[k] for k, v in (("jobs", "JOBS"), ("engine", "ENGINE")) if k in own})
    ended = run.run(tool, build, keys, f"sweep {name}")
    columns, made, missing = table.rows(wanted, key, run.Results(run.folder(build)))
    figures = table.shown(wanted, columns)
    if beside:
        columns, lost = table.put_beside(columns, made, beside)
        for row in lost:
            print(f"{beside}: no point of this sweep is {', '.join(row)}", file=sys.stderr)
    folder = spec.from_here(own["out"]) if "out" in own else f"{build}/sweep/{name}"
    os.makedirs(folder, exist_ok=True)
    intact.write(f"{folder}/sweep.csv", table.of_csv(columns, made))
    drawn = plots.everything(folder, wanted, made, figures)
    print(table.printed(wanted, columns, made), end="")
    print("\n".join(["", f"{folder}/sweep.csv", *drawn]))
    if missing:
        print(f"sphaera sweep: {missing} results are missing; the same command goes on from here",
              file=sys.stderr)
    return 1 if missing or ended else 0
