# page.py - puts the tables and the chart of docs/results/effects.md in their places
# SPDX-License-Identifier: Apache-2.0
import json
import os
import subprocess
import sys
from pathlib import Path

from .. import intact
from ..pages import whole
from ..pages.place import place
from ..synth import report, results
from .scenes import PRICED, PROFILE, WHOLE, names

CHART = """set terminal svg noenhanced size 1000,{height} font "sans,12" background "white"
set output "{out}"
set title "Own core of a scene, everything-on core = 100 %"
set style data histogram
set style histogram clustered gap 1
set style fill solid noborder
set yrange [0:105<*]
set ytics format "%g %%"
set grid ytics lc rgb "#cccccc"
set xtics rotate by 45 right nomirror
set lmargin 14
set bmargin 11
set key outside top center horizontal maxrows 1 samplen 2
set datafile missing "-"
plot "{data}" using 2:xtic(1) title "cells (LUT4eq)" lc rgb "#4477aa", \\
     "" using 3 title "flip-flops" lc rgb "#66ccee", \\
     "" using 4 title "processor time of the simulation" lc rgb "#cc6677"
"""


def percent(part, whole):
    return f"{100 * part / whole:.1f} %"


def less(part, whole):
    """-3.1 % of the whole."""
    return f"{100 * (part - whole) / whole:+.1f} %" if part != whole else "0 %"


def show(name):
    return name.replace(".", "/", 1)


def speed(run):
    return run["counters"]["cycles"] / run["cpu"]


def cost_table(scenes, cores):
    """Cells and time of each scene on the core of its list, against the whole core."""
    rows = []
    for name, s in scenes.items():
        everything = cores[s["whole"]]["core"]
        own, whole = s["runs"]["own"], s["runs"]["all"]
        core = cores[s["list"]]["core"]
        cells = [core[c] for c in ("lut4eq", "ff", "bram", "mult")]
        share = [percent(core[c], everything[c]) for c in ("lut4eq", "ff")]
        rows.append([show(name), f"`{s['list']}`", cells[0], share[0], cells[1], share[1],
                     *cells[2:], own["counters"]["cycles"],
                     percent(own["counters"]["cycles"], whole["counters"]["cycles"]),
                     f"{own['bytes'] // 1024} K", percent(own["bytes"], whole["bytes"]),
                     f"{speed(own) / speed(whole):.2f}", percent(own["cpu"], whole["cpu"])])
    return report.table(["scene", "core", "LUT4eq", "LUT4eq of all", "FF", "FF of all", "DP16KD",
                         "MULT", "cycles", "cycles of all", "model", "model of all", "speed",
                         "time"], rows, left=2)


def price_table(cores):
    """What each effect adds to the core that has all the others."""
    columns, rows = ("lut4eq", "ff", "dpr", "bram", "mult"), []

    def block(title, base, without):
        whole = cores[base]["core"]
        rows.append([title] + [whole[c] for c in columns] + ["", ""])
        for name, cores_list in without.items():
            core = cores[cores_list]["core"]
            rows.append([name] + [f"{core[c] - whole[c]:+d}" if core[c] != whole[c] else "0"
                                  for c in columns]
                        + [less(core["lut4eq"], whole["lut4eq"]), less(core["ff"], whole["ff"])])
    block("everything", WHOLE, {f"without {name}": c for name, c in PRICED.items()})
    block("`all`", "all", {f"without {name}": f"all-{name}" for name in names("all")}
          | {"with none of them": "none"})
    return report.table(["core", "LUT4eq", "FF", "DPR16X4", "DP16KD", "MULT18X18D",
                         "LUT4eq, share", "FF, share"], rows)


def ray_table(scenes):
    """Rays by kind, and what the same picture takes with everything forced on."""
    rows = []
    for name, s in scenes.items():
        now, forced = s["model"], s["model_forced"]
        kinds = [now[f"rays_{kind}"] for kind in ("primary", "shadow", "reflected", "refracted")]
        saved = [f"{forced[c] - now[c]:d}" for c in ("rays_shadow", "rays_reflected", "quotients",
                                                     "node_visits")]
        cycles = [s["runs"][which]["counters"]["cycles"] for which in ("own", "forced")]
        rows.append([show(name), *kinds, now["background"], now["node_visits"], *saved,
                     percent(*cycles)])
    return report.table(["scene", "primary", "shadow", "reflected", "refracted", "background",
                         "visits", "shadow saved", "reflected saved", "quotients saved",
                         "visits saved", "cycles"], rows)


def chart(scenes, cores, page, folder):
    """Bars of each scene, in percent of the core with everything."""
    lines = []
    for name, s in scenes.items():
        everything = cores[s["whole"]]["core"]
        core = cores[s["list"]]["core"]
        shares = [f"{100 * core[c] / everything[c]:.2f}" for c in ("lut4eq", "ff")]
        time = 100 * s["runs"]["own"]["cpu"] / s["runs"]["all"]["cpu"]
        lines.append(f"\"{show(name)}\" {shares[0]} {shares[1]} {time:.2f}")
    data = f"{folder}/chart.txt"
    out = os.path.join(os.path.dirname(page), "../pictures/effects.svg")
    Path(data).write_text("\n".join(lines) + "\n", encoding="utf-8")
    with intact.beside(out) as new:
        script = CHART.format(height=480, out=new, data=data)
        subprocess.run(["gnuplot"], input=script.encode(), check=True)


def main(page, folder, synth):
    lists = (whole.text(Path(folder, "lists")) or "").split()
    wanted = [Path(folder, "scenes")] + [Path(synth, results.key(PROFILE, c), "stat.json")
                                         for c in lists]
    if not all([whole.there(path) for path in wanted]):
        sys.exit(f"effects: {page} stays as it is: {', '.join(whole.LACKING)}")
    cores = {c: results.read(f"{synth}/{results.key(PROFILE, c)}") for c in lists}
    scenes = {}
    for name in Path(folder, "scenes").read_text(encoding="utf-8").split():
        # measured before, perhaps; what build says, just now
        scenes[name] = json.loads(Path(folder, name + ".json").read_text(encoding="utf-8"))
        scenes[name].update(json.loads(Path(folder, name + ".build.json").read_text("utf-8")))
    place(page, "make effects", {"costs": cost_table(scenes, cores), "prices": price_table(cores),
                                 "rays": ray_table(scenes)}, cores["all"]["yosys"])
    chart(scenes, cores, page, folder)
    print(f"effects: {page} and ../pictures/effects.svg")
