# angles.py - levels against the angle at which a texture is seen: table and plot
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess

from .. import intact
from ..pages import whole
from ..synth import report

SLANTS = 89, 75, 60, 45, 30, 16, 5, "ball"  # views: lab/textures/runs.py
VIAS = {"direct": "directly", "flat": "in a flat mirror", "curved": "in a ball"}


def slants(folder):
    """{via: [{degrees, pixels, within_one, path, bmrt, low, top}]}: views put together."""
    found = {via: {} for via in VIAS}
    for view in SLANTS:
        run = whole.load(os.path.join(folder, f"slant-{view}.json"))
        for via, bins in run["levels"]["slant"].items() if run else ():
            if (view == "ball") != (via == "curved"):
                continue
            for b in bins:
                n = b["pixels"]
                t = found[via].setdefault(b["degrees"], {"pixels": 0, "within_one": 0, "path": 0,
                                                         "bmrt": 0, "low": 99, "top": -99})
                for key in "path", "bmrt":
                    t[key] += n * b[key]
                t["pixels"] += n
                t["within_one"] += b["within_one"]
                if n:
                    t["low"], t["top"] = min(t["low"], b["path_low"]), max(t["top"], b["path_top"])
    for bins in found.values():
        for t in bins.values():
            for key in "path", "bmrt":
                t[key] = t[key] / t["pixels"] if t["pixels"] else None
    return found


def angles(found):
    rows = []
    for degrees in sorted({d for bins in found.values() for d in bins}):
        row = [f"{degrees} to {degrees + 5}"]
        for via in VIAS:
            t = found[via].get(degrees)
            seen = t and t["pixels"]
            row += [t["pixels"], f"{t['path']:+.2f}", f"{t['low']:+.2f} .. {t['top']:+.2f}",
                    f"{t['bmrt']:+.2f}", f"{100 * t['within_one'] / t['pixels']:.0f} %"] \
                if seen else ["-"] * 5
        rows.append(row)
    head = ["degrees"]
    for title in VIAS.values():
        head += [title + ": pixels", "path", "from, to", "BMRT", "within 1"]
    return report.table(head, rows)


PLOT = """set terminal svg noenhanced size 860,420 font "sans,12" background "white"
set output "{out}"
set xlabel "angle between ray and normal, degrees"
set ylabel "level by path length less that of ray differentials"
set grid lc rgb "#cccccc"
set key bottom left
set xrange [0:90]
set yrange [-6:1]
set xtics 10
log2(x) = log(x) / log(2)
plot 0 lc rgb "#888888" notitle, \\
     log2(cos(x * pi / 180)) with lines dt 2 lc rgb "#888888" title "log2 of the cosine", \\
     {parts}
"""
COLOURS = {"direct": "#4477aa", "flat": "#ccaa33", "curved": "#cc6677"}


def plot(found, folder, out):
    blocks, parts = [], []
    for via, title in VIAS.items():
        dots = [(d + 2.5, t["path"]) for d, t in sorted(found[via].items()) if t["pixels"] > 9]
        if dots:
            parts.append(f'"{folder}/angles.txt" index {len(blocks)} with linespoints pt 7 ps 0.6 '
                         f'lc rgb "{COLOURS[via]}" title "floor seen {title}"')
            blocks.append("\n".join(f"{x} {y:.4f}" for x, y in dots))
    if not blocks:
        return
    intact.write(os.path.join(folder, "angles.txt"), "\n\n\n".join(blocks) + "\n")
    with intact.beside(out) as new:
        script = PLOT.format(out=new, parts=", \\\n     ".join(parts))
        subprocess.run(["gnuplot"], input=script.encode(), check=True)
