# times.py - what accuracy costs in time, as a plot: clocks of cores, and tables of accuracy.md
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/pictures/accuracy/pareto_milliseconds.svg; FOLDER gets the plot's data. It needs no
result of a run, so `make study-seeds` draws it anew when a clock changed."""

from .. import clocks
from ..pages import data
from . import gather, plots, points

PICTURE = "docs/pictures/accuracy/pareto_milliseconds.svg"


def column(table, name):
    """{profile: figure} of a table of accuracy.md."""
    head, rows = data.read(f"accuracy.{table}")
    return {row[0].strip("`"): row[head.index(name)] for row in rows}


def series():
    """The core at its own clock, if that very core is routed, the golden model, the simulated core:
    (milliseconds of a frame, error, name) of each profile."""
    frame = column("costs", "cycles a frame")
    own = {p: clocks.milliseconds(clocks.key(p, points.CORE), float(frame[p]), "{:.3g}")
           for p in points.PROFILES}
    found = {"core at its own\\nclock, routed": own,
             "golden model,\\none thread": column("costs", "model, ms"),
             "core simulated\\nby Verilator": column("costs", "simulated, ms")}
    psnr = column("profiles", "PSNR")
    return [(title, [(float(ms[p]), gather.error(float(psnr[p])), f"{p} {ms[p]} ms")
                     for p in points.PROFILES if ms[p] not in ("-", clocks.NOT)])
            for title, ms in found.items()]


def main(folder):
    plots.draw(PICTURE, folder, f"What accuracy costs in time: a frame of {points.FRAME}, mean of "
               f"{len(gather.COMMON)} scenes (down: truer)", "ms a frame (log)", series(), True)
