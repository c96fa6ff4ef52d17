# cores.py - cells of the cores that pages speak of, synthesised anew when their sources changed
# SPDX-License-Identifier: Apache-2.0
"""Synthesises what is old; --check says what is, and exits with 1 if anything is.

A page names a core by its list of effects (sim/cores.py), profile standard, one engine, ECP5.
The record has its cells, commit and day, and the digest of the RTL files that it was read from,
by which `make pages` tells whether to synthesise it anew. Comments and white space do not count.
A page shows what the record has, however old."""
import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from .. import intact
from ..synth import results
from . import markdown, measured, verilog

RECORD = Path("docs/results/data/cores.json")
SCRIPT = Path("synth/target.sh")
BUDGET = Path("synth/budget.txt")
BUILD = Path(os.environ.get("BUILD", "build"))
COLUMNS = {"mult": "MULT18X18D", "lut4eq": "LUT4eq", "ff": "FF", "bram": "DP16KD",
           "dpr": "DPR16X4"}
MAIN = ("mult", "lut4eq", "ff", "bram")
SECONDS = 90
REGIONS = "core", "cores", "inside"


COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/|^`timescale[^\n]*", re.S | re.M)


class Unmeasured(Exception):
    """A core that the record does not have."""


def record():
    return json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {}


def write(known):
    """A core is a few lines, a module one."""
    text = json.dumps({name: known[name] for name in sorted(known)}, indent=1)
    text = re.sub(r"\[[^][]*\]", lambda m: " ".join(m[0].split()), text)
    RECORD.parent.mkdir(parents=True, exist_ok=True)
    intact.write(RECORD, text + "\n")


def number(value):
    """21 937"""
    return f"{value:,}".replace(",", " ") if value > 9999 else str(value)


def entry(core):
    cores = record()
    if core not in cores:
        raise Unmeasured(f"nobody has synthesised the core {core}: make pages")
    return cores[core]


def core(name, *columns):
    """Its cells in words, or the number of one column."""
    cells = entry(name)["cells"]
    if columns:
        return ", ".join(number(cells[column]) for column in columns)
    return ", ".join(f"{number(cells[column])} {COLUMNS[column]}" for column in MAIN)


def cores(*names):
    """A row a core."""
    return markdown.table(["`EFFECTS`", *COLUMNS.values()],
                          [[f"`{name}`"] + [number(entry(name)["cells"][c]) for c in COLUMNS]
                           for name in names])


def inside(name, *modules):
    """A row a module of a core, all its instances with what is in them."""
    parts = entry(name)["modules"]
    missing = [module for module in modules if module not in parts]
    if missing:
        raise Unmeasured(f"the core {name} has no {missing[0]}")
    return markdown.table([f"module of `{name}`", *COLUMNS.values()],
                          [[f"`{module}`"] + [number(n) for n in parts[module]]
                           for module in modules])


def yosys():
    """The version that made them, or the versions."""
    return ", ".join(sorted({" ".join(e["yosys"].split()[:2]) for e in record().values()}))


def runs():
    """The commits that they are of."""
    of = {}
    for name, entry_of in record().items():
        of.setdefault((entry_of["day"], entry_of["commit"]), []).append(f"`{name}`")
    if len(of) == 1:
        return "synthesised at commit {1} of {0}".format(*next(iter(of)))
    return "synthesised at commit " + "; ".join(
        f"{commit} of {day}: {', '.join(names)}" for (day, commit), names in sorted(of.items()))


def budget(module):
    """What synth/budget.txt allows a module."""
    for line in BUDGET.read_text(encoding="utf-8").splitlines():
        word = line.split()
        if word[:1] == [module]:
            return f"{number(int(word[1]))} MULT18X18D and {number(int(word[2]))} LUT places"
    raise Unmeasured(f"{BUDGET} has no line for {module}")


def wanted(pages):
    """Lists of the cores that regions of the pages name, each once."""
    found = []
    for page in pages:
        for name in markdown.names(page.read_text(encoding="utf-8")):
            maker, *words = name.split()
            if maker in REGIONS:
                found += words if maker == "cores" else words[:1]
    return sorted(set(found))


def sources(modules):
    """Digest of the files of a core's modules; None if one is not there any more."""
    paths = verilog.files()
    if not set(modules) <= set(paths):
        return None
    flow = re.search(r"^case \$target in.*?^esac", SCRIPT.read_text(encoding="utf-8"), re.M | re.S)
    files = {paths[module] for module in modules} | set(Path("rtl").rglob("*.vh"))
    each = sorted(path.name + "".join(COMMENT.sub(" ", path.read_text(encoding="utf-8")).split())
                  for path in files)
    return hashlib.sha256("\0".join([*each, *flow[0].split()]).encode()).hexdigest()[:8]


def parameters(core_list):
    """What the core is elaborated with."""
    words = []
    for command in ["profile", "standard"], ["parameters", core_list]:
        words += subprocess.run(["sim/cores.py", *command], check=True,
                                stdout=subprocess.PIPE).stdout.decode().split()
    return words


def stale(pages):
    """Cores whose cells are not those of today's sources."""
    return [name for name in wanted(pages) if is_stale(name)]


def is_stale(name):
    known = record().get(name)
    return (known is None or known["sources"] != sources(known["modules"])
            or known["parameters"] != parameters(name))


def synthesise(names):
    """Runs Yosys, one core after the other, and writes the record after each."""
    for name in names:
        subprocess.run(["make", "--no-print-directory", "-f", "make/area.mk", "results",
                        f"B={BUILD}", f"EFFECTS={name}"], check=True)
        run = results.read(BUILD / "synth" / results.key("standard", name))
        known = record()
        commit, day = measured.commit()
        known[name] = {"parameters": parameters(name), "yosys": run["yosys"], "commit": commit,
                       "day": day,
                       "cells": {column: run["core"][column] for column in COLUMNS},
                       "modules": {module: [row["total"][column] for column in COLUMNS]
                                   for module, row in sorted(run["modules"].items())},
                       "sources": sources(run["modules"])}
        write(known)


def main(check=False):
    pages = markdown.pages()
    """Drops what no page names, synthesises what is old."""
    if check:
        for name in stale(pages):
            print(f"cells of the core {name} are not those of these sources: make pages")
        sys.exit(bool(stale(pages)))
    named, known = wanted(pages), record()
    if set(known) - set(named):
        write({name: known[name] for name in known if name in named})
    names = stale(pages)
    if names:
        print(f"pages: cells of {len(names)} of {len(named)} cores are older than the RTL; Yosys "
              f"takes about {SECONDS} s each:\n  " + "\n  ".join(names), flush=True)
    synthesise(names)
