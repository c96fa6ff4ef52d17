#!/usr/bin/env python3
# bart.py - puts the tables of docs/results/bart.md in their places
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.bart PAGE FOLDER SIZE MHZ -- NAME:MIDDLE:FRAME,FRAME... ...
FOLDER has what make/bart.mk says; what is not there is a dash, and a mean is that of the frames
that are there. MHZ: the paper's clock."""
import subprocess
import sys
from functools import lru_cache

from .pages import data as tables
from .pages.place import place
from .report.units import LINE, parameters
from .synth import report
from .textures.page import DECISIONS, LINES, OPERATIONS, PAPER, WAYS, Data, area, levels, show

KINDS = "primary", "shadow", "reflected"
MIP = "off", "level", "between"
BEAT = 8              # bytes of an upload in a clock: `make sim TOP=1`
THEIRS = 0.88 * 207360  # LUTs of the paper's Virtex-5 LX330 that it fills


class Frames(Data):
    """Results of scenes at several times of their animations."""

    def __init__(self, folder, size, mhz, scenes):
        super().__init__(folder, size, None, [s.split(":")[0] for s in scenes])
        self.mhz = float(mhz)
        self.middle = {s.split(":")[0]: s.split(":")[1] for s in scenes}
        self.at = {s.split(":")[0]: s.split(":")[2].split(",") for s in scenes}
        self.pixels = area(size)

    def all(self, name, end):
        """{frame: result} of those that are there."""
        found = {at: self.read(f"{name}-{at}{end}") for at in self.at[name]}
        return {at: run for at, run in found.items() if run}

    def profile(self, name):
        """That of all frames of a scene: of the first that is there, or standard."""
        for run in self.all(name, ".json").values():
            return run["machine"]["profile"].split(":")[0]
        return "standard"

    def read(self, name):
        if name in (f"{scene}-level.json" for scene in self.names):
            return self.texels(name.removesuffix("-level.json"), "level")
        return super().read(name)

    def texels(self, name, way):
        """The sums of all times as one result."""
        runs = list(self.all(name, f"-{way}.json").values())
        if not runs:
            return None
        return {"texels": sum(r["texels"] for r in runs), "frames": len(runs),
                "levels": [sum(c) for c in zip(*(r["levels"] for r in runs))],
                "missed": sum(r["orders"][1]["missed"][LINES] for r in runs)}


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else None


@lru_cache
def facet(profile):
    """Clocks of the facet unit for a test, in a core of the profile."""
    pace = subprocess.run(["sh", "sim/profile.sh", profile], check=True,
                          stdout=subprocess.PIPE, text=True).stdout.split()
    given = dict(size.split("=") for size in pace)
    return int(given.get("FACET_INTERVAL", parameters({}, "all")["FACET_INTERVAL"]))


def least(count, profile):
    """Clocks that one engine takes at least: a visit a clock, the facet unit's for each test."""
    return max(count["node_visits"], facet(profile) * count["facet_tests"])


def frames(data):
    """What the frames are, and what their rays ask of tree and triangles: means."""
    rows = []
    for name in data.names:
        runs = list(data.all(name, ".json").values())
        if not runs:
            rows.append([name] + ["-"] * 9)
            continue
        machine = runs[0]["machine"]

        def each(what, runs=runs):
            return mean(r["counters"][what] / data.pixels for r in runs)
        rows.append([name, len(runs), round(mean(r["machine"]["triangles"] for r in runs)),
                     machine["lights"], machine["profile"]]
                    + [f"{each('rays_' + kind):.2f}" for kind in KINDS]
                    + [f"{each(what):.1f}" for what in ("node_visits", "facet_tests")])
    return report.table(["scene", "times", "triangles", "lights", "profile"]
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
    """Of all decisions of a mean frame: those of a triangle's hit times the textured hits."""
    rows = []
    for name in data.names:
        run, work = data.texels(name, "level"), decision(data, name)
        for way in ("bmrt", "kept", "anew"):
            first = way == "bmrt"
            row = [name if first else "", DECISIONS[way]]
            if not run or not work:
                rows.append(row + ["-"] * 7)
                continue
            n = round(run["texels"] / 4 / run["frames"])
            each = [work[way][op] / work["hits"] for op in OPERATIONS]
            rows.append(row + [n if first else ""] + [f"{n * e:.0f}" for e in each]
                        + [f"{sum(each):.3g}"])
    return report.table(["scene", "way", "hits"] + OPERATIONS + ["all, a hit"], rows, left=2)


def caches(data):
    rows = []
    for name in data.names:
        for way in MIP:
            run = data.texels(name, way)
            rows.append([name if way == "off" else "", WAYS[way],
                         show(run and run["texels"] / run["frames"], "{:.0f}"),
                         show(run and 100 - 100 * run["missed"] / run["texels"], "{:.1f}"),
                         f"{PAPER[name][1][way != 'off']}"])
    return report.table(["scene", "filter", "texels", "hits, %", "the paper's"], rows, left=2)


def slower(run, profile):
    """How often the least clocks the RTL took, of the pixels that it drew."""
    return run["cold"]["counters"]["cycles"] / least(run["cold"]["counters"], profile)


def engines(data):
    """Engines as large as the paper's machine."""
    run = data.read("area.json")
    if not run:
        return None
    core = run["runs"][0]
    return THEIRS // core["core"]["lut"]


def clocks(data):
    """Clocks a pixel: the least by the model's counters, and what the RTL's tiles make of it."""
    rows, clock, many = [], tables.routed(), engines(data)
    for name in data.names:
        drawn = data.all(name, ".json")
        profile = data.profile(name)
        bound = {at: least(run["counters"], profile) / data.pixels for at, run in drawn.items()}
        tiles = data.all(name, "-between.core.json")
        ratio = mean(slower(run, profile) for run in tiles.values())
        took = mean(bound.values()) * (ratio or 1) if bound else None

        def rate(mhz, took=took):
            return show(took and mhz * 1e6 / took / data.pixels, "{:.2f}")
        at84 = took and data.mhz * 1e6 / took / data.pixels
        rows.append([name] + [show(mean(run["counters"][what] / data.pixels * by
                                        for run in drawn.values()), "{:.0f}")
                              for what, by in (("node_visits", 1), ("facet_tests", facet(profile)))]
                    + [show(max(bound.values(), default=None), "{:.0f}"), show(ratio, "{:.2f}"),
                       show(took, "{:.0f}"), rate(data.mhz), rate(clock),
                       show(at84 and many and at84 * many, "{:.2f}"), f"{PAPER[name][2][1]}"])
    return report.table(["scene", "walk, clocks a pixel", "facet unit, clocks a pixel",
                         "worst time", "RTL over least", "clocks a pixel",
                         f"frames/s at {data.mhz:.0f} MHz", f"at {clock:g} MHz",
                         f"{show(many and int(many))} engines, {data.mhz:.0f} MHz",
                         "the paper's"], rows)


def memory(data):
    """MIP off and on in the RTL's tile of the middle frame."""
    rows = []
    for name in data.names:
        runs = {way: data.read(f"{name}-{data.middle[name]}-{way}.core.json") for way in MIP}
        off, on = PAPER[name][2]
        for way, run in runs.items():
            cold = run and run["cold"]
            gain = way != "off" and run and runs["off"] and \
                100 * (runs["off"]["cold"]["cycles_per_pixel"] / cold["cycles_per_pixel"] - 1)
            pins = run and cold["memory"]["lines"] * LINE / run["memory"]["peak_bytes_per_clock"]
            rows.append([name if way == "off" else "", WAYS[way],
                         show(run and cold["memory"]["bytes_per_pixel"], "{:.0f}"),
                         show(run and cold["memory"]["row_hit_share"], "{:.0%}"),
                         show(run and pins / run["pixels"], "{:.0f}"),
                         show(run and cold["cycles_per_pixel"], "{:.0f}"),
                         "" if way == "off" else show(gain or None, "{:+.1f} %"),
                         "" if way == "off" else f"{100 * (on / off - 1):+.0f} %"])
    return report.table(["scene", "filter", "bytes a pixel", "rows open", "pins, clocks a pixel",
                         "clocks a pixel", "gain", "the paper's"], rows, left=2)


def sequence(data):
    """P_b, and the time of each frame in a row."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}.sequence.json")
        profile = data.profile(name)
        ratio = mean(slower(r, profile) for r in data.all(name, "-between.core.json").values())
        for frame in run["frames"] if run else []:
            def ms(clock):
                return f"{clock / data.mhz / 1000:.0f}"
            rows.append([name, frame["at"], frame["bases"]["computed"], frame["bases"]["kept"],
                         f"{1000 * frame['cpu_seconds']:.0f}", ms(frame["memory_bytes"] / BEAT),
                         show(ratio and least(frame["counters"], profile) * ratio / data.mhz / 1000,
                              "{:.0f}")])
    return report.table(["scene", "frame", "P_b made", "kept", "build, ms", "upload, ms",
                         "draw, ms"], rows)


def main():
    page, folder, size, mhz, dashes, *scenes = sys.argv[1:]
    if dashes != "--" or not scenes:
        sys.exit(__doc__)
    data = Frames(folder, size, mhz, scenes)
    place(page, {"frames": frames(data), "levels": levels(data), "operations": operations(data),
                 "caches": caches(data), "clocks": clocks(data), "memory": memory(data),
                 "sequence": sequence(data)})


if __name__ == "__main__":
    main()
