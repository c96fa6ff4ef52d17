# plots.py - what accuracy costs, as plots of docs/results/accuracy.md, drawn by gnuplot as SVG
# SPDX-License-Identifier: Apache-2.0
"""A line for each family of cores; the four profiles have names, all others only a colour."""
import os
import subprocess
from pathlib import Path

from .. import intact
from . import gather, points
from .gather import core_of

PLOT = """set terminal svg noenhanced size 900,520 font "sans,13" background "white"
set output "{out}"
set title "{title}"
set xlabel "{xlabel}"
set ylabel "error: rms of a channel, of 255 (log)"
set logscale y
set ytics ({ticks})
set format y "%g"
set grid lt 1 lc rgb "#dddddd"
set xrange [{left}:{right}]
set yrange [{low}:{high}]
{more}
plot {parts}
"""
COLOURS = ["#4477aa", "#cc6677", "#228833", "#ddaa33", "#aa4499", "#66ccee", "#999933", "#882255"]
LINE = ('"{data}" index {i} using 1:2 with linespoints pt {shape} ps {size} lw 2 '
        'lc rgb "{colour}" title "{title}"')
TICKS = ", ".join(f"{step}e{e}" for e in range(-4, 3) for step in (1, 2, 5))
NAMES = ('"{data}" index {i} using 1:2:3 with labels {side},{up} tc rgb "{colour}" '
         'font "sans,12" notitle')


def heads(series):
    """Of a plot whose lines stand side by side: each family's name above its line."""
    lines = ["set logscale x", "unset key"]
    for i, (name, some) in enumerate(series):
        middle = sorted(d[0] for d in some)[len(some) // 2]
        lines.append(f'set label "{name}" at first {middle:.9g}, graph 0.95 center '
                     f'tc rgb "{COLOURS[i]}" font "sans,13"')
    return "\n".join(lines)


def draw(out, folder, title, xlabel, series, log=False):
    """series: list of (title, dots (x, y, name)), a line each, named dots with their names. True if
    any dot was drawn."""
    series = [(name, dots) for name, dots in series if dots]
    dots = [d for _, some in series for d in some]
    if not dots:
        return False
    data = os.path.join(folder, os.path.basename(out) + ".txt")
    blocks = ["\n".join(f'{x:.9g} {y:.6g} "{n}"' for x, y, n in s) for _, s in series]
    Path(data).write_text("\n\n\n".join(blocks) + "\n", encoding="utf-8")
    parts = []
    for i, (name, some) in enumerate(series):
        first = log and i == 0  # it has no other line at its left
        words = dict(data=data, i=i, colour=COLOURS[i % len(COLOURS)], title=name,
                     shape=[7, 5, 9, 11, 13][i % 5], size=1.3 if some[0][2] else 0.8, up=0.2,
                     side="right offset -1.2" if first else "left offset 1.2")
        parts += [LINE.format(**words)] + ([NAMES.format(**words)] if some[0][2] else [])
    xs, ys = [d[0] for d in dots], [d[1] for d in dots]
    left, right = (min(xs) / 6, max(xs) * 4) if log else (0, max(xs) * 1.2)
    with intact.beside(out) as new:
        script = PLOT.format(out=new, title=title, xlabel=xlabel, ticks=TICKS,
                             parts=", \\\n  ".join(parts), left=left, right=right,
                             low=min(ys) / 1.6, high=max(ys) * (4 if log else 2),
                             more=heads(series) if log else "set key bottom left")
        subprocess.run(["gnuplot"], input=script.encode(), check=True)
    return True


def dots_of(study, cores, value, name=None):
    """(value, error, name) of each core of which both are known."""
    found = []
    for core in cores:
        db, x = gather.mean_psnr(study, core["profile"]), value(core)
        if db is not None and x is not None:
            found.append((x, gather.error(db), name(core, x) if name else ""))
    return found


def named(core, x):
    del x
    return core["profile"]


def cells(study, kind):
    """The profiles, and around standard a line for each knob of which cores were made."""
    def value(core):
        return (study.cells(core) or {}).get(kind)
    lines = [("profiles", dots_of(study, [core_of(p) for p in points.PROFILES], value, named))]
    for knob, widths in points.KNOBS.items():
        some = dots_of(study, [core_of(p) for p in widths], value)
        if len(some) > 1:
            lines.append((knob.upper(), sorted(some)))
    for words in points.RATES:
        some = dots_of(study, [core_of("standard"), dict(core_of("standard"), **words)], value)
        if words and len(some) > 1:
            lines.append((", ".join(f"{k} {v}" for k, v in words.items()), some))
    return lines


def everything(study, pictures, folder):
    """All plots; the names of those that were drawn."""
    wanted = {
        "multipliers": ("What accuracy costs in multipliers", "MULT18X18D",
                        cells(study, "mult")),
        "luts": ("What accuracy costs in logic", "LUT4eq", cells(study, "lut4eq")),
    }
    return [n for n, (heading, xlabel, series) in wanted.items()
            if draw(os.path.join(pictures, f"pareto_{n}.svg"), folder, heading, xlabel, series)]
