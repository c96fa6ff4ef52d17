# cells.py - cells of cores of 1 to 4 traversal pipes: `make pipes-cells`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `cells` into PAGE. What `make synth` has made of the same RTL is taken as it
is."""
import sys

from . import cores
from .pipes import FEW, RULE
from ..pages.place import place
from ..runner import said
from ..synth import report, results

COLUMNS = ["mult", "places", "ff", "bram"]
DEVICE = ["LFE5U-85F has", 156, 83640, 83640, 208]  # its data sheet


def cells(build, core):
    """The counts of a core by the keys of results.py."""
    print(f"  SYN  pipes: {core.name()}", file=sys.stderr, flush=True)
    of = {"PROFILE": "standard", "EFFECTS": cores.SPHERES, **core.variables()}
    said("make", "--no-print-directory", f"B={build}", "synth",
         *(f"{name}={value}" for name, value in of.items()))
    key = said("sim/cores.py", "key", of["PROFILE"], of["EFFECTS"], "ecp5", **core.variables())
    return results.read(f"{build}/synth/{key.strip()}")["core"]


def main(build, page):
    heads = dict(results.columns("ecp5"))
    rows = []
    for core in RULE + [FEW]:
        counts = cells(build, core)
        rows.append([core.name(), *(counts[column] for column in COLUMNS)])
    table = report.table(["pipes", *(heads[column] for column in COLUMNS)], rows + [DEVICE])
    place(page, "make pipes-cells", {"pipes_cells": table})
