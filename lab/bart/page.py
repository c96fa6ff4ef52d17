# page.py - puts the tables of docs/results/texture_results.md in their places
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has what runs.py says, a SCENE is NAME:MIDDLE:FRAME,FRAME...."""
from functools import lru_cache, partial

from sim import definition

from ..pages.place import place
from ..report.units import LINE, parameters
from ..synth import report
from ..textures.page import DECISIONS, LINES, OPERATIONS, PAPER, WAYS, Data, area, levels, show

KINDS = "primary", "shadow", "reflected"
MIP = "off", "level", "between"
PIPES = 1, 2, 4       # of cores that are compared
WIDE = 24             # W of profile reference
TEXEL = 13 / 8        # clocks of rt_texel for one of the eight between two levels
BEAT = 8              # bytes of an upload in a clock: `make sim TOP=1`


class Frames(Data):
    """Results of scenes at several times of their animations."""

    def __init__(self, folder, size, scenes):
        super().__init__(folder, size, None, [s.split(":")[0] for s in scenes])
        self.middle = {s.split(":")[0]: s.split(":")[1] for s in scenes}
        self.at = {s.split(":")[0]: s.split(":")[2].split(",") for s in scenes}
        self.pixels = area(size)

    def all(self, name, end):
        """{frame: result} of those that are there."""
        found = {at: self.read(f"{name}-{at}{end}") for at in self.at[name]}
        return {at: run for at, run in found.items() if run}

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
def core(pipes):
    """Sizes of an engine of so many pipes that walks boxes."""
    return parameters({"PIPES": pipes}, "shadow+facets+boxes")


def walk(count, pipes=1):
    """Clocks that one engine takes at least: a visit a pipe a clock."""
    return count["node_visits"] / pipes


def tests(count, pipes=1):
    """The same for tests of triangles in its leaf units."""
    clocks = definition.value(definition.Definition().rates["FACET_CLOCKS"],
                              core(pipes) | {"W": WIDE})
    return count["facet_tests"] * clocks / core(pipes)["LEAF_COUNT"]


def texels(count, pipes=1):
    """The same for texels in its shading units."""
    return count.get("texels", 0) * TEXEL / core(pipes)["SHADE_UNITS"]


def least(count, pipes=1):
    return max(walk(count, pipes), tests(count, pipes), texels(count, pipes))


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


def slower(run, pipes=1):
    """How often the least clocks the RTL took, of the pixels that it drew."""
    return run["cold"]["counters"]["cycles"] / least(run["cold"]["counters"], pipes)


def slower_of(data, name, pipes=1):
    """The same of the frame in the middle."""
    return mean(slower(run, pipes) for run in data.all(name, f"-pipes{pipes}.core.json").values())


def clocks(data):
    """Clocks a pixel: the least by the model's counters, and what the RTL makes of it. The page's
    frames a second follow from them (lab/pages/rates.py)."""
    rows = []
    for name in data.names:
        drawn = [run["counters"] for run in data.all(name, ".json").values()]
        for pipes in PIPES:
            def each(what, pipes=pipes, drawn=drawn):
                return [what(count, pipes) / data.pixels for count in drawn]
            ratio = slower_of(data, name, pipes)
            took = mean(each(least)) * (ratio or 1) if drawn else None
            rows.append([name if pipes == 1 else "", pipes]
                        + [show(mean(each(what)), "{:.0f}") for what in (walk, tests, texels)]
                        + [show(max(each(least), default=None), "{:.0f}"),
                           show(ratio, "{:.2f}"), show(took, "{:.1f}"), f"{PAPER[name][2][1]}"])
    return report.table(["scene", "pipes", "walk, clocks a pixel", "facet unit, clocks a pixel",
                         "texture unit, clocks a pixel", "worst time", "RTL over least",
                         "clocks a pixel", "the paper's"], rows)


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
    """P_b, and the work of each frame in a row."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}.sequence.json")
        for frame in run["frames"] if run else []:
            rows.append([name, frame["at"], frame["bases"]["computed"], frame["bases"]["kept"],
                         f"{1000 * frame['cpu_seconds']:.0f}",
                         f"{frame['memory_bytes'] / BEAT / 1e6:.1f}",
                         f"{least(frame['counters']) / 1e6:.1f}"])
    return report.table(["scene", "frame", "P_b made", "kept", "build, ms",
                         "upload, million clocks", "draw, million clocks"], rows)


def main(page, folder, size, *scenes):
    data = Frames(folder, size, scenes)
    made = {"frames": frames, "levels": levels, "operations": operations, "caches": caches,
            "clocks": clocks, "memory": memory, "sequence": sequence}
    place(page, "make bart", {"bart_" + name: partial(table, data) for name, table in made.items()})
