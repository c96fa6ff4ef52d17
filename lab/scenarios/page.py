# page.py - puts the tables of docs/results/trees.md in their places
# SPDX-License-Identifier: Apache-2.0
"""FOLDER is what measure.py left. Without the RTL's runs the tables that have cycles stay as they
are."""
import os
import sys

from . import measure
from ..pages import limits, whole
from ..pages.place import place
from ..runner import core_name
from ..synth import report

# Table 4.2 of the thesis, scenario by scenario with MAX_PRIMS 1 and 8.
THESIS = {
    "internal nodes": [4095, 511, 4861, 816, 4316, 774],
    "leaves": [4096, 512, 4107, 812, 3780, 763],
    "primitives of a leaf, least": [1, 8, 0, 0, 0, 1],
    "primitives, mean": [1.00, 8.00, 1.00, 5.04, 1.08, 5.37],
    "primitives, most": [1, 8, 1, 8, 2, 8],
    "depth of a leaf, least": [13, 10, 5, 5, 10, 9],
    "depth, mean": [13.00, 10.00, 15.30, 12.09, 14.96, 11.94],
    "depth, most": [13, 10, 19, 16, 21, 16],
    "leaves of 0, %": [0, 0, 0.27, 1.11, 0.11, 0.13],
    "of 1": [100, 0, 99.73, 5.05, 91.43, 2.49],
    "of 2": [0, 0, 0, 8.87, 8.47, 6.03],
    "of 3": [0, 0, 0, 10.10, 0, 12.71],
    "of 4": [0, 0, 0, 12.93, 0, 17.04],
    "of more": [0, 100, 0, 61.95, 0, 61.60],
    "optimized nodes": [0, 0, 755, 5, 537, 12],
}
CASES = [(s, p) for s in (1, 2, 3) for p in (1, 8)]


def load(folder, name):
    return whole.load(os.path.join(folder, name + ".json"))


def number(value):
    return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else str(value)


def column(result):
    """The rows of Table 4.2 of one machine."""
    b = result["build"]["build"]["bih"]
    bars = [100 * n / b["leaves"] for n in b["leaves_by_prims"]]
    return [b["inner"], b["leaves"], b["prims_min"], b["prims_mean"], b["prims_max"],
            b["depth_min"], b["depth_mean"], b["depth_max"], *bars, b["optimized"]]


def statistics(folder):
    ours = [column(load(folder, f"table-{s}-bih{p}")) for s, p in CASES]
    rows = [[name] + [f"{number(ours[i][j])} ({number(is_)})"
                              for i, is_ in enumerate(values)]
            for j, (name, values) in enumerate(THESIS.items())]
    return report.table(["ours (thesis)"] + [f"S{s}, {p}" for s, p in CASES], rows)


def listing(folder):
    rows = []
    for s, p in CASES:
        full, plain = (column(load(folder, f"table-{s}-{how}{p}")) for how in ("bih", "listing"))
        rows.append([f"S{s}, {p}"] + [f"{number(full[i])} / {number(plain[i])}"
                                      for i in (0, 1, 8, 14, 6, 7)])
    return report.table(["full / listing", "internal nodes", "leaves", "empty, %", "optimized",
                         "mean depth", "most"], rows)


def memory(folder):
    rows = []
    for s in 1, 2, 3:
        for n in measure.MANY:
            all_ = [load(folder, f"memory-{s}-{n}-{p}")["build"]["build"]["bih"]
                    for p in measure.PRIMS]
            cells = [b["bytes"] for b in all_]
            rows.append([f"S{s}, {n}", *cells, f"{100 * (1 - cells[-1] / cells[0]):.1f} %",
                         all_[0]["node_bytes"], all_[-1]["node_bytes"], all_[0]["record_bytes"]])
    return report.table(["bytes"] + [f"BIH {p}" for p in measure.PRIMS]
                        + ["16 saves", "lines of BIH 1", "of BIH 16", "leaf records"], rows)


def per_ray(result):
    c = result["render"]["counters"]
    rays = sum(c[k] for k in c if k.startswith("rays_"))
    return {k: c[k] / rays for k in c}


def core(folder, name, pipes=1):
    """The pass with warm caches; None if this RTL has not run."""
    run = whole.load(os.path.join(folder, core_name(name, pipes)), *whole.RTL)
    if run is None:
        return None
    if run["mismatches"] or run["warm"]["errors"]:
        sys.exit(f"page: {name}: model and RTL differ")
    return run["warm"]


def cycles(folder, name, pipes=1):
    """Cycles a pixel with warm caches."""
    run = core(folder, name, pipes)
    return run and run["cycles_per_pixel"]


def shown(value):
    return "-" if value is None else f"{value:.2f}"


def speed(folder, field, more=()):
    """Figure 4.4: brute force over each MAX_PRIMS, as `field` says; more: of other trees too."""
    ways = [f"bih{p}" for p in measure.PRIMS] + list(more)
    rows = [[f"S{s}, {n}"] + [field(folder, s, n, way) for way in ways]
            for s in (1, 2, 3) for n in measure.FEW]
    return report.table(["scenario, spheres"] + [f"BIH {p}" for p in measure.PRIMS] + list(more),
                        rows)


def time_ratio(folder, s, n, way):
    brute, tree = (min(load(folder, f"speed-{s}-{n}-{w}")["render_times"])
                   for w in ("brute", way))
    return f"{brute / tree:.1f}"


def work(folder, s, n, way):
    """Visits and tests a ray, and brute force's tests over both."""
    brute, tree = (per_ray(load(folder, f"speed-{s}-{n}-{w}")) for w in ("brute", way))
    v, t = tree["node_visits"], tree["leaf_tests"]
    return f"{v:.2f} + {t:.2f}: {brute['leaf_tests'] / (v + t):.1f}"


def cycle_ratio(folder, s, n, way):
    brute, tree = (cycles(folder, f"rtl-{s}-{n}-{w}") for w in ("brute", way))
    return "-" if brute is None or tree is None else f"{tree:.2f}: {brute / tree:.1f}"


def limit(folder, name):
    """The units that the run says the frame waits for, with their parts of it."""
    run = core(folder, name)
    return "-" if run is None else limits.parts(run)


def speed_limit(folder, s, n, way):
    return limit(folder, f"rtl-{s}-{n}-{way}")


def full(folder):
    """The thesis's frame in the RTL, each process with the rows that it drew."""
    rows = [[f"S{s}, {n}", way, str(pipes), shown(cycles(folder, f"speed-{s}-{n}-{way}", pipes))]
            for s, n, way, pipes in measure.FULL_RTL]
    return report.table(["scenario, spheres", "tree", "pipes", "cycles a pixel"], rows, 2)


def trees(folder):
    rows = []
    for scene in measure.SCENES:
        for way in measure.ACCELS:
            name = f"trees-{scene}-{way}"
            r = load(folder, name)
            c, b = per_ray(r), r["build"]["build"]
            bytes_ = (b["bih"]["node_bytes"] + b["bih"]["record_bytes"] if "bih" in b
                      else r["build"]["machine"]["tree_bytes"])
            rows.append([scene, way, f"{c['node_visits']:.1f}", f"{c['child_tests']:.1f}",
                         f"{c['leaf_tests']:.2f}", f"{c['facet_tests']:.2f}", bytes_])
    return report.table(["scene", "tree", "visits", "tests of children", "of spheres",
                         "of facets", "bytes"], rows, 2)


def tree_cycles(folder):
    """Cycles a pixel of the RTL, and what limits them."""
    return report.table(["scene", "tree", "cycles a pixel", "what binds"], [
        [scene, way, *(f(folder, f"trees-{scene}-{way}") for f in (lambda *run: shown(cycles(*run)),
                                                                  limit))]
        for scene in measure.SCENES_RTL for way in measure.ACCELS_RTL])


def main(page, folder):
    place(page, "make scenarios", {
        "bih_statistics": lambda: statistics(folder), "bih_listing": lambda: listing(folder),
        "bih_memory": lambda: memory(folder), "bih_time": lambda: speed(folder, time_ratio),
        "bih_work": lambda: speed(folder, work), "bih_cycles": lambda: speed(folder, cycle_ratio),
        "bih_limits": lambda: speed(folder, speed_limit, ["brute"]),
        "bih_full": lambda: full(folder), "bih_trees": lambda: trees(folder),
        "bih_tree_cycles": lambda: tree_cycles(folder)})
