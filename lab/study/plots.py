# plots.py - Pareto plots of docs/results/accuracy.md, drawn by gnuplot as SVG
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess
from pathlib import Path

from . import gather, points
from .gather import core_of

PLOT = """set terminal svg noenhanced size 860,520 font "sans,12" background "white"
set output "{out}"
set title "{title}"
set xlabel "{xlabel}"
set ylabel "error: rms of a channel, of 255 (log)"
set logscale y
set format y "%g"
set grid lc rgb "#cccccc"
set key top left
set xrange [{left}:{right}]
set yrange [{low}:{high}]
plot {parts}
"""
PARTS = {
    "front": '"{data}" index {i} using 1:2 with lines lc rgb "#bbbbbb" lw 2 title "best so far"',
    "own": '"{data}" index {i} using 1:2 with points pt 7 ps 1 lc rgb "#4477aa" title "{title}", '
           '"" index {i} using 1:2:3 with labels left rotate by 25 offset 0.5,0.5 notitle',
    "other": '"{data}" index {i} using 1:2 with points pt 6 ps 1 lc rgb "#cc6677" '
             'title "{title}", '
             '"" index {i} using 1:2:3 with labels left rotate by 25 offset 0.5,0.5 notitle',
}


def front(dots):
    """The dots that no other one beats in both, left to right, as stairs."""
    best, kept = None, []
    for x, y, _ in sorted(dots):
        if best is None or y < best:
            if kept:
                kept.append((x, best, ""))
            kept.append((x, y, ""))
            best = y
    return kept


def draw(out, folder, title, xlabel, series):
    """series: list of (kind of PARTS, title, dots (x, y, name)). True if any dot was drawn."""
    dots = [d for _, _, s in series for d in s]
    if not dots:
        return False
    series = [("front", "", front(dots))] + [s for s in series if s[2]]
    data = os.path.join(folder, os.path.basename(out) + ".txt")
    blocks = ["\n".join(f'{x:.9g} {y:.6g} "{n}"' for x, y, n in s) for _, _, s in series]
    Path(data).write_text("\n\n\n".join(blocks) + "\n", encoding="utf-8")
    parts = ", \\\n     ".join(PARTS[kind].format(data=data, i=i, title=name)
                               for i, (kind, name, _) in enumerate(series))
    xs, ys = [d[0] for d in dots], [d[1] for d in dots]
    span = max(xs) - min(xs) or max(xs)
    script = PLOT.format(out=out + ".tmp", title=title, xlabel=xlabel, parts=parts,
                         left=min(xs) - span / 20, right=max(xs) + span / 3,
                         low=min(ys) / 2, high=max(ys) * 6)
    subprocess.run(["gnuplot"], input=script.encode(), check=True)
    os.replace(out + ".tmp", out)
    return True


def errors(study, value):
    """Dots of all cores: value(core) against the error, None left out."""
    dots = []
    for core in points.cores():
        db, x = gather.mean_psnr(study, core["profile"]), value(core)
        if db is None or x is None:
            continue
        rate = [f"{k} {core[k]}" for k in ("root", "quotient", "engines") if k in core]
        label = core["profile"].removeprefix("standard:") if ":" in core["profile"] \
            else core["profile"]
        dots.append((x, gather.error(db), " ".join([label] + rate)))
    return dots


def everything(study, pictures, folder):
    """Both Pareto plots; the names of those that were drawn."""
    standard = study.fmax(core_of("standard"))
    clock = standard and standard["fmax"]
    own = errors(study, lambda c: gather.milliseconds(study, c))
    same = errors(study, lambda c: gather.milliseconds(study, c, clock)
                  if clock and not study.fmax(c) else None)
    cells = errors(study, lambda c: (study.cells(c) or {}).get("mult"))
    luts = errors(study, lambda c: (study.cells(c) or {}).get("lut4eq"))
    title = f"frame of {points.FRAME}, mean of {len(gather.COMMON)} scenes"
    wanted = {
        "milliseconds": ("Error against time: " + title, "ms a frame",
                         [("own", "at the clock of its own placement", own),
                          ("other", "not placed: at the clock of standard", same)]),
        "multipliers": ("Error against multipliers", "MULT18X18D", [("own", "cores", cells)]),
        "luts": ("Error against logic", "LUT4eq", [("own", "cores", luts)]),
    }
    return [n for n, (heading, xlabel, series) in wanted.items()
            if draw(os.path.join(pictures, f"pareto_{n}.svg"), folder, heading, xlabel, series)]
