# background.py - the ways of background separation compared, into docs/results/effects.md
# SPDX-License-Identifier: Apache-2.0
"""BUILD/background holds, for each scene, NAME.json of `sphaera background`, and for each way
NAME-WAY.sph and NAME-WAY.core.json, the report of the RTL's run. Every way runs on one core, the
plain one with what that way needs; make/area.mk keeps its cells in BUILD/synth."""
import glob
import os
import sys

from .pages import whole
from .pages.place import place
from .synth import report, results
from .tasks import Task, core, tool

SCENES = {os.path.basename(path)[:-4]: path for path in (
    *sorted(glob.glob("scenes/views/*.nff")), "scenes/interpenetrating.nff", "scenes/paper5.nff")}
PLAIN, SIZE = "shadow+reflect2+lights1", "160x90"
# way: options of build, what its core has besides
WAYS = {"none": ("none", ""), "rect": ("rect", "+rect"), "spans": ("spans", "+spans"),
        "exact0": ("exact --bg-levels 0", "+cones1"), "exact1": ("exact --bg-levels 1", "+cones4"),
        "exact2": ("exact --bg-levels 2", "+cones16")}
# picture of the page: view, what `sphaera background` calls it
PICTURES = ["centred-points", "centred-rows", "centred-outline", "centred-square",
            "off_axis-way_rect_literal", "off_axis-way_rect", "centred-way_spans",
            "wide-way_exact0", "wide-way_exact1"]
DRAWN = "docs/pictures/background"
BUILT = {"none": "none", "rect": "rect", "spans": "spans", "exact0": "exact level 0",
         "exact1": "exact level 1", "exact2": "exact level 2"}
LITERAL = ["rect literal", "spans 16x16, no border", "spans 16x16"]
# the view whose operations and series are shown
SHOWN = "centred"


def way(view, name):
    return next(w for w in view["ways"] if w["way"] == name)


def percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def saved(views):
    """Background found by each way of the machine, and wrong pixels of them all."""
    rows = []
    for name, view in views.items():
        ways = [way(view, w) for w in BUILT.values()]
        wrong = sum(w["wrong"] for w in ways)
        rows.append([name, percent(view["background"], view["width"] * view["height"])]
                    + [percent(w["found"], view["background"]) for w in ways[1:]] + [wrong])
    return report.table(["view", "background"] + list(BUILT.values())[1:] + ["wrong pixels"], rows)


def literal(views):
    """Wrong pixels of the paper's methods at their word."""
    rows = [[name] + ["no answer" if way(view, w)["no_answer"] else way(view, w)["wrong"]
                      for w in LITERAL] for name, view in views.items()]
    return report.table(["view"] + LITERAL, rows)


def setup(view):
    """Operations before the frame: of the method, and of the proof that it is safe."""
    names = ["rect literal", "rect", "spans 16x16", "spans"] + list(BUILT.values())[3:]
    rows = []
    for name in names:
        w = way(view, name)
        rows.append([name] + [w["setup"][k] for k in ("add", "mul", "div", "trig", "compare")]
                    + [sum(w["check"].values())])
    return report.table(["way", "additions", "multiplications", "divisions", "sin and cos",
                         "comparisons", "proof, all"], rows)


def walk(view):
    """Operations of the hardware for each pixel of the frame."""
    n = view["width"] * view["height"]
    rows = [[name] + [f"{way(view, name)['walk_' + k] / n:.3g}" for k in ("add", "compare",
                                                                          "words")]
            for name in BUILT.values()]
    return report.table(["way", "additions", "comparisons", "32-bit words read"], rows)


def series(view):
    rows = [[f"{s['points']} x {s['points']}", *s["missed"], *s["wrong"], s["border"]]
            for s in view["series"]]
    return report.table(["points", "missed", "missed, border", "wrong", "wrong, border",
                         "rays for the border"], rows)


def counted(names, folder, counter):
    """A counter of the RTL without separation, and what each way leaves of it."""
    rows = []
    for name in names:
        row = [name]
        for built in BUILT:
            run = whole.load(os.path.join(folder, f"{name}-{built}.core.json"))
            if run["mismatches"] or run["cold"]["errors"]:
                sys.exit(f"background: {name} {built}: model and RTL differ")
            count = run["cold"]["counters"][counter]
            if built == "none":
                base = count
            row.append(count if built == "none" else f"{100 * count / base:.0f} %")
        rows.append(row)
    head = ["view", "none, " + counter.replace("_", " ")] + list(BUILT.values())[1:]
    return report.table(head, rows)


def cells(synth, keys):
    """Cells of the plain core, and what each way adds."""
    runs = [whole.there(os.path.join(synth, key, "stat.json")) and
            results.read(os.path.join(synth, key)) for key in keys]
    columns = ["lut4eq", "ff", "dpr", "bram", "mult"]
    total = [run["modules"]["rt_core"]["total"] for run in runs]
    rows = [["plain core"] + [total[0][c] for c in columns]]
    for run, t in zip(runs[1:], total[1:]):
        name = run["key"].split("lights1+")[1].split("-")[0]
        rows.append(["+" + name] + [f"{t[c] - total[0][c]:+d}" for c in columns])
    return report.table(["core", "LUT4eq", "FF", "DPR16X4", "DP16KD", "MULT18X18D"], rows)


def tasks(build):
    at, found = f"{build}/background", []
    for name, scene in SCENES.items():
        found.append(tool(build, f"{at}/{name}.json", [scene], "background", scene, "--profile",
                          "standard", "--size", SIZE, "--json", f"{at}/{name}.json",
                          say=f"WAYS {name}"))
        for way_of, (options, more) in WAYS.items():
            stem = f"{at}/{name}-{way_of}"
            found.append(tool(build, f"{stem}.sph", [scene], "build", scene, "--profile",
                              "standard", "--size", SIZE, "--background", *options.split(), "-o",
                              f"{stem}.sph"))
            found.append(core(build, f"{stem}.core.json", f"{stem}.sph",
                              EFFECTS=f"{PLAIN}+inside{more}", say=f"SIM {name} {way_of}"))
    for view in sorted({name.partition("-")[0] for name in PICTURES}):
        scene, folder = f"scenes/views/{view}.nff", f"{at}/drawn-{view}"
        found.append(tool(build, f"{folder}/log", [scene], "background", scene, "--profile",
                          "standard", "--size", "80x45", "--pictures", folder, prints=True))
    for name in PICTURES:
        view, _, what = name.partition("-")
        folder = f"{at}/drawn-{view}"
        found.append(Task(f"{DRAWN}/{name}.png", [f"{folder}/log"],
                          ["cp", f"{folder}/{what}.png", f"{DRAWN}/{name}.png"]))
    return found


def synthesised(build):
    results.synthesise(build, [PLAIN + more for _, more in WAYS.values()])


def main(page, build):
    folder, synth, names = f"{build}/background", f"{build}/synth", list(SCENES)
    keys = [results.key("standard", PLAIN + more) for _, more in WAYS.values()]

    def views():
        return {name: whole.load(os.path.join(folder, name + ".json")) for name in names}
    place(page, "make background", {
        "background_saved": lambda: saved(views()), "background_literal": lambda: literal(views()),
        "background_setup": lambda: setup(views()[SHOWN]),
        "background_walk": lambda: walk(views()[SHOWN]),
        "background_series": lambda: series(views()[SHOWN]),
        "background_visits": lambda: counted(names, folder, "node_visits"),
        "background_cycles": lambda: counted(names, folder, "cycles"),
        "background_cells": lambda: cells(synth, keys)})
