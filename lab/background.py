# background.py - puts the tables of docs/results/background.md in their places
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has NAME.json of `sphaera background` and NAME-WAY.core.json of the RTL's runs; SYNTH/KEY
is what synth/core.sh left: the plain core first, then one with each way."""
import os
import sys

from .pages import whole
from .pages.place import place
from .synth import report, results

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


def main(page, folder, synth, keys, *names):
    def views():
        return {name: whole.load(os.path.join(folder, name + ".json")) for name in names}
    place(page, "make background", {
        "saved": lambda: saved(views()), "literal": lambda: literal(views()),
        "setup": lambda: setup(views()[SHOWN]), "walk": lambda: walk(views()[SHOWN]),
        "series": lambda: series(views()[SHOWN]),
        "visits": lambda: counted(names, folder, "node_visits"),
        "cycles": lambda: counted(names, folder, "cycles"),
        "cells": lambda: cells(synth, keys.split())})
