# page.py - puts the tables of docs/results/papers.md in their places
# SPDX-License-Identifier: Apache-2.0
"""FOLDER is what measure.py left, SYNTH the folder of synthesised cores."""
import math
import os
import sys
from pathlib import Path

from . import measure
from ..pages import data, limits, whole
from ..pages.place import place
from ..synth import report, results

PIXELS = 160 * 90
RAYS = ["primary", "reflected", "shadow"]
# of the sizes that `sphaera texels` has, 8 lines and twice as many each time
CACHES = [1, 3, 5]
# what a Virtex-5 LX330 has, by its data sheet; LUTs have six inputs, blocks of RAM 36 kbit
LX330 = {"lut": 207360, "ff": 207360, "bram": 288, "dsp": 192}


def load(folder, name):
    return whole.load(os.path.join(folder, name + ".json"))


def core(folder, name):
    """The pass with cold caches."""
    run = whole.load(os.path.join(folder, name + ".core.json"), *whole.RTL)
    if run["mismatches"] or run["cold"]["errors"]:
        sys.exit(f"page: {name}: model and RTL differ")
    return run["cold"]


def cycles(folder, name):
    return core(folder, name)["cycles_per_pixel"]


def limit(folder, name):
    """What the run says that its frame waits for."""
    return limits.parts(core(folder, name))


def levels(n):
    return math.ceil(math.log2(n) / 2)


def searched(folder):
    """{scene: (spheres, levels of the tree, spheres that a primary ray tests)}."""
    found = {}
    for name in measure.SEARCHED:
        run = load(folder, "search-" + name)
        counters, n = run["counters"], run["machine"]["spheres"]
        # the root sphere, which the core does not test, is one of the paper's
        tests = 1 + counters["child_tests"] / counters["rays_primary"]
        found[name] = n, run["build"]["depth"] + 1, tests     # spheres are a level of the paper's
    return dict(sorted(found.items(), key=lambda item: (item[0].startswith("column"), item[1][0])))


def search(folder):
    rows = [[f"`{name}`", n, depth, levels(n) + 1, f"{tests:.1f}", levels(n) + 4, 4 * levels(n) + 1]
            for name, (n, depth, tests) in searched(folder).items()]
    return report.table(["scene", "spheres", "levels", "claimed", "tests a ray", "at best, claimed",
                         "at worst, claimed"], rows)


def mean(flops, n):
    return [f"{flops[k] / n:.3g}" for k in ("mul", "add", "div", "root")]


def operations(folder):
    rows = []
    for scene, cases in (("paper5", ["miss", "hit"]), ("inside", ["behind"])):
        run = load(folder, "operations-" + scene)
        for name, is_ in run["predicates"].items():
            if scene == "paper5":
                rows.append([name, "each ray", *mean(is_["ray"], run["rays"])])
            for case in cases:
                rows.append([name, case, *mean(is_[case], run["tests"][case])])
    order = list(load(folder, "operations-paper5")["predicates"])
    rows.sort(key=lambda row: order.index(row[0]))
    return report.table(["predicate", "case", "multiplications", "additions", "divisions", "roots"],
                        rows, 2)


def moved(folder):
    """dB of pictures whose view meets a corner, and of those whose view meets the middle."""
    rows = [["scene", "view through a corner, dB", "through the middle, dB"]]
    for name in measure.MOVED:
        oblique, straight = (whole.text(os.path.join(folder, f"{kind}-{name}.psnr")).strip()
                             for kind in ("moved", "straight"))
        rows.append([f"`{name}`", f"{float(oblique):.1f}", f"{float(straight):.1f}"])
    core(folder, "moved-oblique")  # the RTL's frame is the model's
    return rows


def shapes(folder):
    rows = []
    names = {"sphere": "spheres", "box": "boxes around them", "1": "80 triangles each",
             "2": "320", "3": "1280"}
    for scene in measure.REPLACED:
        for shape, name in names.items():
            run = load(folder, f"shape-{scene}-{shape}")
            with open(os.path.join(folder, f"shape-{scene}-{shape}.psnr"), encoding="utf-8") as f:
                decibels = float(f.read())
            c = run["counters"]
            rows.append([f"`{scene}`", name, run["machine"]["memory_bytes"], f"{decibels:.1f}",
                         f"{c['node_visits'] / PIXELS:.1f}",
                         f"{(c['leaf_tests'] + c['facet_tests']) / PIXELS:.1f}",
                         f"{cycles(folder, f'shape-{scene}-{shape}'):.1f}",
                         limit(folder, f"shape-{scene}-{shape}")])
    return report.table(["scene", "drawn as", "bytes", "dB", "visits a pixel", "exact tests",
                         "cycles a pixel", "what binds"], rows, 2)


def leaves(folder):
    head = ["", *map(str, measure.LEAVES), "brute"]
    prims = [f"{cycles(folder, f'leaves-prims{n}'):.1f}" for n in measure.LEAVES]
    limit = [f"{cycles(folder, f'leaves-levels{n}'):.1f}" for n in measure.LEVELS]
    return report.table(head, [["MAX_PRIMS", *prims, f"{cycles(folder, 'leaves-brute'):.1f}"],
                               ["MAX_TREE_DEPTH 1 to 7", *limit, ""]])


def bound(folder):
    """What the runs of the RTL name as their limits, for rows of claims.py."""
    names = {"parts_0": "parts-paper100-0", "parts_2": "parts-paper100-2",
             "paper5": "parts-paper5-2", "one_leaf": "leaves-prims64", "brute": "leaves-brute",
             "kitchen_10": "bounces-kitchen-10", "mirrors_10": "bounces-mirrors-10"}
    names.update((f"prims{n}", f"leaves-prims{n}") for n in measure.LEAVES)
    names.update((f"{scene}_{shape}", f"shape-{scene}-{shape}") for scene in measure.REPLACED
                 for shape in ("sphere", "3"))
    return {"bound_" + name: limit(folder, run) for name, run in names.items()}


def reasons(folder):
    """What why.py found."""
    return load(folder, "why")


def bases(folder):
    """Hits that need P_b, and how many of them fetch a line, of P_b alone and of mapping records,
    by lines of the cache."""
    rows = []
    for name in [*measure.MAPPED, "field"]:
        run = load(folder, "bases-" + name)["records"]
        rows.append([f"`{name}`", run["lookups"], *(run[kind][size] for kind in
                                                    ("base_missed", "map_missed")
                                                    for size in CACHES)])
    return report.table(["scene", "hits", *(f"{kind}, {8 << size}" for kind in
                                            ("P_b alone", "records") for size in CACHES)], rows)


def synthesised(synth, effects, target):
    """The cells of a core; None if it was not synthesised since the RTL changed."""
    found = Path(synth) / results.key("standard", effects, target)
    return results.read(found)["core"] if whole.there(found / "stat.json", "rtl/**/*.v*") else None


def shaped(synth):
    """Cells of the cores that draw spheres, and what others draw instead."""
    v = {}
    for shape, effects in measure.SHAPES_CORE.items():
        core = synthesised(synth, effects, "ecp5")
        v["cells_" + shape] = f"{core['lut4eq']:,}".replace(",", " ")
    return v


def park(synth):
    """Cells of the core for the texture paper's scenes, and percent of its FPGA."""
    core = synthesised(synth, measure.PARK_CORE, "xc7")
    cells = {"lut": core["lut"] + core["lutram"], "ff": core["ff"], "dsp": core["mult"],
             "bram": core["ramb36"] + core["ramb18"] / 2}
    v = {"park_" + name: f"{n:,g}".replace(",", " ") for name, n in cells.items()}
    v.update({f"park_{name}_of": f"{100 * n / LX330[name]:.0f}" for name, n in cells.items()})
    return v


def profiles(folder):
    """Shares of the model's instructions, by Valgrind."""
    return {"profile_" + name: whole.text(os.path.join(folder, name + ".profile")).strip()
            for name in measure.PROFILED}


def values(folder):
    """What the rows of claims.py name, and more of the same."""
    found, v = searched(folder), {}
    v["search_scenes"] = len(found)
    v["worst_4096"] = 4 * levels(4096) + 1
    for name, (_, _, tests) in found.items():
        v["tests_" + name] = f"{tests:.0f}" if tests > 20 else f"{tests:.1f}"
    run, inside = load(folder, "operations-paper5"), load(folder, "operations-inside")
    for name, is_ in run["predicates"].items():
        v[name + "_mul"], v[name + "_add"] = mean(is_["hit"], run["tests"]["hit"])[:2]
    v["behind_mul"] = mean(inside["predicates"]["paper"]["behind"], inside["tests"]["behind"])[0]
    v["wrong"] = inside["predicates"]["paper"]["wrong"]
    v["tests"] = sum(inside["tests"].values())
    for scene in "hidden", "paper100":
        for way in "first", "mended":
            v[f"{scene}_{way}"] = load(folder, f"differ-{scene}-{way}")["difference"]["pixels"]
    for depth in measure.DEPTHS:
        v[f"parts_{depth}"] = f"{cycles(folder, f'parts-paper100-{depth}'):.1f}"
    for scene in measure.PARTS:
        v["hd_" + scene] = f"{cycles(folder, f'parts-{scene}-2'):.1f}"
    for scene in measure.BOUNCED:
        for depth in measure.BOUNCES:
            name = f"bounces-{scene}-{depth}"
            v[f"{scene}_{depth}"] = f"{cycles(folder, name):.0f}"
            counters = load(folder, name + ".core")["cold"]["counters"]
            v[f"{scene}_{depth}_rays"] = "{:.2f}".format(
                sum(counters["rays_" + kind] for kind in RAYS) / counters["rays_primary"])
    counters = load(folder, "parts-paper100-2.core")["warm"]["counters"]
    v["busy"] = f"{100 * counters['node_visits'] / counters['cycles']:.0f}"
    v["leaf_64"] = f"{cycles(folder, 'leaves-prims64'):.1f}"
    v["leaf_brute"] = f"{cycles(folder, 'leaves-brute'):.1f}"
    for way in measure.WAYS:
        with open(os.path.join(folder, f"levels-{way}.rms"), encoding="utf-8") as f:
            v["levels_" + way] = f"{float(f.read()):.3f}"
    for name in [*measure.MAPPED, "field"]:
        run = load(folder, "bases-" + name)["records"]
        v["hits_" + name], v["alone_" + name] = run["lookups"], run["base_missed"][CACHES[0]]
        v["alone_of_" + name] = f"{100 * v['alone_' + name] / v['hits_' + name]:.0f}"
    counters = load(folder, "parts-paper100-2.core")["cold"]["counters"]
    for name in "node_visits", "node_misses", "leaf_tests", "leaf_misses":
        v["cold_" + name] = counters[name]
    return v


def main(page, folder, synth):
    def values_of(found, *arguments):
        return lambda: report.table(["name", "value"],
                                    [[k, v] for k, v in found(*arguments).items()])
    place(page, "make papers", {
        "values": values_of(values, folder), "profiles": values_of(profiles, folder),
        "shaped": values_of(shaped, synth), "park": values_of(park, synth),
        "bound": values_of(bound, folder), "why": values_of(reasons, folder),
        "search": lambda: search(folder), "operations": lambda: operations(folder),
        "shapes": lambda: shapes(folder), "moved": lambda: moved(folder),
        "bases": lambda: bases(folder),
        "leaves": lambda: leaves(folder)})
