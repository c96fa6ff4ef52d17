# cells.py - cells of cores of 1 to 4 traversal pipes: `make pipes-cells`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `cells` into PAGE. What `make synth` has made of the same RTL is taken as it
is."""

from . import cores
from .pipes import FEW, RULE
from ..pages.place import place
from ..sweep.run import measured
from ..synth import report, results

COLUMNS = ["mult", "places", "ff", "bram"]
DEVICE = ["LFE5U-85F has", 156, 83640, 83640, 208]  # its data sheet


def main(build, page):
    heads, built = dict(results.columns("ecp5")), RULE + [FEW]
    runs = measured(build, "pipes-cells", "cells",
                    [{"effects": cores.SPHERES, **core.axes()} for core in built])
    rows = [[core.name(), *(run["core"][column] for column in COLUMNS)]
            for core, run in zip(built, runs)]
    table = report.table(["pipes", *(heads[column] for column in COLUMNS)], rows + [DEVICE])
    place(page, "make pipes-cells", {"pipes_cells": table})
