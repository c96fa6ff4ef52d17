#!/usr/bin/env python3
# bart.py - puts the tables of docs/results/bart.md in their places
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.bart PAGE FOLDER SIZE -- NAME...
FOLDER has what make/bart.mk says; what is not there is a dash."""
import sys

from .pages.place import place
from .report.units import parameters
from .synth import report
from .textures.page import DECISIONS, OPERATIONS, PAPER, WAYS, Data, area, hits, levels, show

PAPER_MHZ = 84
KINDS = "primary", "shadow", "reflected"


def frames(data):
    """What the frame is, and what its rays ask of tree and triangles."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}.json")
        if not run:
            rows.append([name] + ["-"] * 8)
            continue
        pixels, count, machine = area(data.size), run["counters"], run["machine"]
        rows.append([name, machine["triangles"], machine["lights"], machine["profile"]]
                    + [f"{count['rays_' + kind] / pixels:.2f}" for kind in KINDS]
                    + [f"{count[what] / pixels:.1f}" for what in ("node_visits", "facet_tests")])
    return report.table(["scene", "triangles", "lights", "profile"]
                        + [f"{kind} rays a pixel" for kind in KINDS]
                        + ["node visits a pixel", "facet tests a pixel"], rows)


def decision(data, own):
    """Work of the decisions for triangles in a small frame: its own, or the first there is."""
    for name in [own] + data.names:
        work = (data.read(f"{name}.levels.json") or {}).get("level_work", {}).get("triangle")
        if work and work["hits"]:
            return work
    return None


def operations(data):
    """Of all decisions of a frame: those of a triangle's hit times the textured hits."""
    rows = []
    for name in data.names:
        run, work = data.read(f"{name}-level.json"), decision(data, name)
        for way in ("bmrt", "kept", "anew"):
            first = way == "bmrt"
            row = [name if first else "", DECISIONS[way]]
            if not run or not work:
                rows.append(row + ["-"] * 7)
                continue
            n = run["texels"] // 4
            each = [work[way][op] / work["hits"] for op in OPERATIONS]
            rows.append(row + [n if first else ""] + [f"{n * e:.0f}" for e in each]
                        + [f"{sum(each):.3g}"])
    return report.table(["scene", "way", "hits"] + OPERATIONS + ["all, a hit"], rows, left=2)


def caches(data):
    rows = []
    for name in data.names:
        for way in ("off", "level", "between"):
            run = data.read(f"{name}-{way}.json")
            rows.append([name if way == "off" else "", WAYS[way], show(run and run["texels"]),
                         show(hits(run), "{:.1f}"), f"{PAPER[name][1][way != 'off']}"])
    return report.table(["scene", "filter", "texels", "hits, %", "the paper's"], rows, left=2)


def clocks(data):
    """The least that one engine takes: a visit a clock, and the facet unit's clocks."""
    rows, facet = [], parameters({})["FACET_INTERVAL"]
    for name in data.names:
        run = data.read(f"{name}.json")
        count = run and run["counters"]
        walk, facets = (count["node_visits"], facet * count["facet_tests"]) if run else (None,) * 2
        least = run and max(walk, facets)
        rows.append([name] + [show(v and v / area(data.size), "{:.0f}")
                              for v in (walk, facets, least)]
                    + [show(least and PAPER_MHZ * 1e6 / least, "{:.2f}"), f"{PAPER[name][2][1]}"])
    return report.table(["scene", "walk, clocks a pixel", "facet unit, clocks a pixel",
                         "the greater", f"frames/s at {PAPER_MHZ} MHz", "the paper's"], rows)


def main():
    page, folder, size = sys.argv[1:4]
    data = Data(folder, size, None, sys.argv[5:])
    place(page, {"frames": frames(data), "levels": levels(data), "operations": operations(data),
                 "caches": caches(data), "clocks": clocks(data)})


if __name__ == "__main__":
    main()
