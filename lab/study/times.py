# times.py - what accuracy costs in time, as a plot: of tables of accuracy.md and clocks of cores
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/pictures/accuracy/pareto_milliseconds.svg; FOLDER gets the plot's data. It needs no
result of a run, so `make study-seeds` draws it anew when a clock changed."""
from ..pages import rates
from . import gather, plots, points

PICTURE = "docs/pictures/accuracy/pareto_milliseconds.svg"


def of(time):
    """A line a kind of scene: (time, error, profile and time) of each row whose time is known."""
    found = {}
    for row in rates.rows("kinds"):
        if row[time][0].isdigit():
            found.setdefault(row["what"], []).append(
                (float(row[time]), gather.error(float(row["dB"])),
                 f"{row['profile'].strip('`')} {row[time]}"))
    return list(found.items())


def series():
    """In milliseconds if every core is routed, else in clocks; and which of both."""
    routed = of("ms a frame")
    if sum(len(dots) for _, dots in routed) == len(points.KINDS) * len(points.PROFILES):
        return routed, "ms a frame"
    return of("cycles a pixel"), "clocks a pixel"


def main(folder):
    lines, unit = series()
    plots.draw(PICTURE, folder, f"What accuracy costs in time: frames of {points.PICTURE}, each on "
               "its scene's own core (down: truer)", f"{unit} (log)", lines, True)
