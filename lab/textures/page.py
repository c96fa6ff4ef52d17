# page.py - puts the tables of docs/results/texture_results.md in their places, and draws its
# plot
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has what runs.py says. The table `textures` stands in ACCURACY."""
import os
import re
from functools import partial

from ..pages import whole
from ..pages.place import place
from ..report.units import LINE
from ..synth import report
from .angles import angles, plot, slants

SLOW = "robot"    # simulated with slow memory as well
STALLED = "robot", "hall", "kitchen"  # and with memory that is not ready in STALLS percent
STALLS = 0, 50, 90
TILES, LINES = 1, 4  # of `orders` and of a `missed`: tiles of 4 x 2, 128 lines of 4 ways, the core
WAYS = {"nearest": "nearest texel, MIP off", "off": "bilinear, MIP off",
        "level": "bilinear, nearest level", "between": "trilinear"}
# Park et al. 2011, Table I: shares of levels 0 to 3, hit rates, frames a second, off and on
PAPER = {"kitchen": ((13, 30, 9, 48), (74.5, 93.7), (3.4, 3.7)),
         "robot": ((2, 1, 2, 95), (73.9, 98.6), (5.1, 6.3)),
         "museum": ((0, 58, 26, 16), (79.6, 97.2), (6.1, 6.4))}
KINDS = ["triangle", "plane", "sphere"]
OPERATIONS = ["add", "mul", "div", "sqrt", "log"]
DECISIONS = {"bmrt": "BMRT's estimate", "bmrt_alone": "the same, edges too",
             "kept": "path length, P_b kept", "anew": "path length, P_b at the hit",
             "anew_alone": "the same, edges and normal too"}
BITS = range(9)


class Data:
    """Results of a folder; None where one is missing."""

    def __init__(self, folder, size, rtl, names):
        self.folder, self.size, self.rtl, self.names = folder, size, rtl, names

    def read(self, name):
        return whole.load(os.path.join(self.folder, name))

    def rms(self, name):
        """(RMS, PSNR) as oiiotool tells them."""
        text = whole.text(os.path.join(self.folder, name + ".rms"))
        return text and tuple(float(re.search(what + r" = ([0-9.]+)", text)[1])
                     for what in ("RMS error", "Peak SNR"))


def show(value, form="{}"):
    return "-" if value is None else form.format(value)


def area(size):
    width, height = size.split("x")
    return int(width) * int(height)


def mean(values):
    values = list(values)
    return None if None in values else sum(values) / len(values)


def hits(texels):
    """Percent, of the model's cache with the core's shape."""
    return texels and 100 - 100 * texels["orders"][TILES]["missed"][LINES] / texels["texels"]


def levels(data):
    """Shares of hits on each level, nearest ones: four texels each."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}-level.json")
        row = [name, "the paper's", "-"] + [f"{p}" for p in PAPER[name][0]]
        rows.append(row)
        if run:
            count = run["levels"]
            share = [100 * c / run["texels"] for c in count[:3] + [sum(count[3:])]]
            rows.append(["", "ours", run["texels"] // 4] + [f"{s:.1f}" for s in share])
    return report.table(["scene", "", "hits", "level 0, %", "1", "2", "3 and more"], rows, left=2)


def decisions(data):
    """Operations of one decision, by kind of primitive; the same for every hit of a kind."""
    total = {}
    for name in data.names:
        run = data.read(f"{name}.levels.json")
        for kind in KINDS if run else []:
            entry = total.setdefault(kind, {"hits": 0})
            work = run["level_work"][kind]
            entry["hits"] += work["hits"]
            for way in DECISIONS:
                for op in OPERATIONS:
                    entry.setdefault(way, dict.fromkeys(OPERATIONS, 0))[op] += work[way][op]
    rows = []
    for way, title in DECISIONS.items():
        row = [title]
        for kind in KINDS:
            entry = total.get(kind)
            row.append("-" if not entry or not entry["hits"] else ", ".join(
                f"{entry[way][op] / entry['hits']:g}" for op in OPERATIONS))
        rows.append(row)
    return report.table(["way"] + KINDS, rows)


def totals(data):
    """Operations of all decisions of a frame."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}.levels.json")
        if not run:
            rows.append([name] + ["-"] * 8)
            continue
        work = run["level_work"]
        count = sum(work[k]["hits"] for k in KINDS)
        for way in ("bmrt", "kept", "anew"):
            ops = [sum(work[k][way][op] for k in KINDS) for op in OPERATIONS]
            rows.append([name if way == "bmrt" else "", DECISIONS[way],
                         count if way == "bmrt" else ""] + ops + [f"{sum(ops) / count:.1f}"])
    return report.table(["scene", "way", "hits"] + OPERATIONS + ["all, a hit"], rows, left=2)


def bases(data):
    """P_b before the frame, and for each frame of the robot's walk."""
    rows = []
    for name in data.names:
        run = data.read(f"{name}.levels.json")
        frames = [("the only frame", run and run["build"]["bases"])]
        walk = data.read(f"{name}-walk.json")
        if walk:
            frames = [(f"frame {f['at']}", f["bases"]) for f in walk["frames"][:3]]
        for i, (title, b) in enumerate(frames):
            rows.append([name if i == 0 else "", title]
                        + [show(b and b[k]) for k in ["computed", "kept"] + OPERATIONS])
    return report.table(["scene", "", "P_b made", "kept"] + OPERATIONS, rows, left=2)


def caches(data):
    rows = []
    for name in data.names:
        paper = PAPER[name][1]
        for way in ("off", "level", "between"):
            run, small = data.read(f"{name}-{way}.json"), data.read(f"{name}-{way}-rtl.json")
            core = data.read(f"{name}-{way}.core.json")
            count = core and core["cold"]["counters"]
            rtl = count and 100 - 100 * count["texel_misses"] / count["texels"]
            rows.append([name if way == "off" else "", WAYS[way], show(run and run["texels"]),
                         show(hits(run), "{:.1f}"), show(hits(small), "{:.1f}"),
                         show(rtl, "{:.1f}"), f"{paper[way != 'off']}"])
    return report.table(["scene", "filter", f"texels, {data.size}", f"model, {data.size}",
                         f"model, {data.rtl}", f"core, {data.rtl}", "the paper's"], rows, left=2)


def cycles_of(data, name):
    run = data.read(name + ".core.json")
    return run and run["cold"]["counters"]["cycles"]


def speed(data):
    rows = []
    for name in data.names:
        for way in ("off", "level", "between"):
            cycles = cycles_of(data, f"{name}-{way}")
            pixel = cycles and cycles / area(data.rtl)
            rows.append([name if way == "off" else "", WAYS[way], show(cycles),
                         show(pixel, "{:.1f}"), f"{PAPER[name][2][way != 'off']}"])
    return report.table(["scene", "filter", "cycles", "a pixel", "the paper's"], rows, left=2)


def slow(data):
    """Cycles with memory at its usual latency, and at ten times that."""
    rows = []
    for way in ("off", "level", "between"):
        both = [cycles_of(data, f"{SLOW}-{way}{end}") for end in ("", "-slow")]
        more = None if None in both else 100 * (both[1] / both[0] - 1)
        rows.append([WAYS[way]] + [show(c) for c in both] + [show(more, "{:+.1f} %")])
    return report.table([f"{SLOW}, {data.rtl}", "latency 20", "latency 200", ""], rows)


def stalls(data):
    """Cycles where memory is held back, and what MIP-mapping gains in frames a second."""
    rows = []
    for name in STALLED:
        runs = {way: [cycles_of(data, f"{name}-small-{way}-{stall}") for stall in STALLS]
                for way in ("off", "level", "between")}
        for way, cycles in runs.items():
            gains = ["" if way == "off" else show(
                None if None in (off, now) else 100 * (off / now - 1), "{:+.0f} %")
                     for off, now in zip(runs["off"], cycles)]
            rows.append([name, WAYS[way]] + [show(c) for c in cycles] + gains)
    return report.table(["80x45", "filter"] + [f"STALL={s}" for s in STALLS]
                        + [f"gain, {s}" for s in STALLS], rows, left=2)


# first what the others are compared with
MEMORIES = {"ideal_84": "8 bytes a clock", "ddr3x16_84": "DDR3 x16", "sdram16_84": "SDRAM x16",
            "sdram16_672": "an eighth of it"}
GROUPS = 1, 2, 4  # lines of 32 bytes that are fetched together


def limit(run):
    """Clocks a pixel of memory's pins, and the unit that is busiest, with its share of the clocks,
    in brackets unless the run says that it binds."""
    pins = run["cold"]["memory"]["lines"] * LINE / run["memory"]["peak_bytes_per_clock"]
    said = run["cold"]["limit"]
    name = f"{said['unit']}, {100 * said['busy']:.0f} %"
    return [f"{pins / run['pixels']:.1f}", name if said["binds"] else f"({name})"]


def less(runs, way):
    """Percent by which the frame is shorter with another filter or memory."""
    if not runs.get(way[0]) or not runs.get(way[1]):
        return None
    clocks = [runs[w]["cold"]["cycles_per_pixel"] for w in way]
    return round(100 * (clocks[0] / clocks[1] - 1))


def memory(data):
    """Bytes, open rows, clocks and what MIP-mapping gains, under named parts."""
    rows, best = [], list(MEMORIES)[0]
    for name in STALLED:
        runs = {(part, way): data.read(f"{name}-fine-{way}-{part}.core.json")
                for part in MEMORIES for way in ("off", "level", "between")}
        for part, title in MEMORIES.items():
            for way in ("off", "level", "between"):
                run = runs[part, way]
                if not run:
                    rows.append([name, title, WAYS[way]] + ["-"] * 7)
                    continue
                cold = run["cold"]
                lost = less(runs, ((part, way), (best, way)))
                gain = less(runs, ((part, "off"), (part, way)))
                rows.append([name, title, WAYS[way], f"{cold['memory']['bytes_per_pixel']:.1f}",
                             show(cold["memory"].get("row_hit_share"), "{:.0%}"),
                             f"{cold['cycles_per_pixel']:.1f}",
                             "" if part == best else show(lost, "{:d} %"),
                             "" if way == "off" else show(gain, "{:+d} %")]
                            + limit(run))
    return report.table(["scene", "memory", "filter", "bytes a pixel", "rows open",
                         "clocks a pixel", "lost", "gain", "pins", "busiest, its clocks"], rows,
                        left=3)


def longer(data):
    """Hits of a cache of the core's size with longer lines, at the paper's pixels."""
    rows = []
    for name in STALLED:
        for way in ("off", "level", "between"):
            run = data.read(f"{name}-fine-{way}.json")
            row = [name, WAYS[way]]
            for group in GROUPS:
                found = [s for s in run["shapes"] if s["together"] == group and s["ways"] == 4] \
                    if run else []
                missed = found[0]["missed"][LINES] if found else None
                row.append(show(missed is not None and 100 - 100 * missed / run["texels"] or None,
                                "{:.1f}"))
            theirs = PAPER.get(name)
            rows.append(row + [theirs[1][way != "off"] if theirs else ""])
    return report.table(["scene", "filter"] + [f"lines of {LINE * g} bytes" for g in GROUPS]
                        + ["the paper's"], rows, left=2)


def errors(data):
    rows = []
    for name in data.names:
        for way in ("off", "level", "between"):
            e = data.rms(f"{name}-{way}")
            rows.append([name if way == "off" else "", WAYS[way], show(e and e[0], "{:.4f}"),
                         show(e and e[1], "{:.2f}")])
    return report.table(["scene", "filter", "RMS error, 1 is white", "PSNR, dB"], rows, left=2)


def price(data, files, title):
    """Error, texels and cycles, means of the scenes."""
    rms = [data.rms(f) for f in files]
    errors_of = mean(r and r[0] for r in rms)
    return [title, show(errors_of, "{:.4f}"), show(mean(r and r[1] for r in rms), "{:.2f}")]


def prices(data):
    """For docs/results/accuracy.md: kinds of filter, bits of the level."""
    rows = []
    for way, title in WAYS.items():
        texels = [data.read(f"{n}-{way}.json") for n in data.names]
        cycles = mean(cycles_of(data, f"{n}-{way}") for n in data.names)
        rows.append(price(data, [f"{n}-{way}" for n in data.names], title)
                    + [show(mean(t and t["texels"] / area(data.size) for t in texels), "{:.2f}"),
                       show(cycles, "{:.0f}")])
    for bits in BITS:
        rows.append(price(data, [f"{n}-lod{bits}" for n in data.names],
                          f"trilinear, LF {bits}") + ["", ""])
    return report.table(["filter", "RMS error", "PSNR", "texels a pixel", "cycles a frame"], rows)


def main(page, accuracy, folder, pictures, size, rtl, *names):
    data = Data(folder, size, rtl, names)
    tables_of = {"levels": levels, "decisions": decisions, "totals": totals, "bases": bases,
                 "caches": caches, "speed": speed, "slow": slow, "stall": stalls, "memory": memory,
                 "longer": longer, "errors": errors}
    put = place(page, "make textures", {"angles": lambda: angles(slants(folder))} | {
        name: partial(table, data) for name, table in tables_of.items()})
    if "angles" in put:
        plot(slants(folder), folder, os.path.join(pictures, "angles.svg"))
    place(accuracy, "make textures", {"textures": lambda: prices(data)})
