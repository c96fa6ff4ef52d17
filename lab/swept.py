# swept.py - what the papers fix without trying it: `make swept`
# SPDX-License-Identifier: Apache-2.0
"""The thesis's factor 1.3, by which a box of a BIH may be longer than what is in it; Borodavka's
rule of the largest sphere; nodes that larger leaves save; background by objects instead of by the
root. Counts of the model; what must not change a picture is held against the first one's."""
import math
import os
import re

from .pages import data, whole
from .pages.place import place
from .runner import Runner as Runs
from .trees import NO_ID, ids

SIZE = "160x90"
WIDTH, HEIGHT = 160, 90
MADE = {"random:256": 256, "random:4096": 4096, "sphereflake:3": 3, "sphereflake:4": 4,
        "scenario1:512": 512, "scenario2:512": 512, "scenario3:512": 512}
FACTORS = ["1.1", "1.2", "1.3", "1.5", "2", "infinity"]
FITTED = ["paper100", "facets/room", "random:4096", "sphereflake:3", "scenario1:512",
          "scenario2:512", "scenario3:512"]
GROWN = ["paper5", "sphereflake2", "paper100", "random:256", "random:4096", "sphereflake:4"]
SEPARATED = ["views/centred", "views/off_axis", "paper5", "oblique", "paper100", "sphereflake2",
             "random:256"]
WAYS = ["rect", "spans", "exact level 0", "exact level 1", "exact level 2"]
TILES = [16, 8, 4]


class Runner(Runs):
    def scene(self, name):
        if name not in MADE:
            return f"scenes/{name}.nff"
        made = self.path(name.replace(":", "-") + ".nff")
        if not os.path.exists(made):
            self.run("gen", name, "-o", made)
        return made

    def counted(self, name, *how, good=(0,)):
        """The report of a frame; None if it is refused."""
        key = "-".join([re.sub("[:/]", "_", name), *how]).replace("--", "")
        to = self.path(key + ".json")
        if not self.fresh(key + ".json"):
            self.run("render", self.scene(name), "--size", SIZE, "--profile", "reference", *how,
                     "--json", to, "--frame", self.path(key + ".frame"), good=good)
        return whole.load(to) if self.fresh(key + ".json") else None


def mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def fits(run):
    """max(visits, 2 tests), which is what a BIH waits for: a visit a clock, a test two."""
    rows, ratios = [["scene", *(factor.replace("infinity", "none") for factor in FACTORS)]], []
    for name in FITTED:
        costs, pictures = [], set()
        for factor in FACTORS:
            found = run.counted(name, "--accel", "bih", "--bih-fit", factor)
            c = found["counters"]
            costs.append(max(c["node_visits"], 2 * (c["leaf_tests"] + c["facet_tests"])))
            pictures.add(found["frame"]["picture_hash"])
        if len(pictures) != 1:
            raise ValueError(f"{name}: a factor changes the picture")
        rows.append([f"`{name}`", *(f"{cost / 1000:.0f}" for cost in costs)])
        ratios.append([cost / costs[FACTORS.index("1.3")] for cost in costs])
    rows.append(["by that of 1.3, mean", *(f"{mean(column):.3f}" for column in zip(*ratios))])
    return rows


def grown(run):
    """The paper's tree with and without the rule that no node is larger than the whole."""
    rows = [["scene", "visits, with the rule", "without", "more"]]
    for name in GROWN:
        rule, free = (run.counted(name, "--tree", tree, good=(0, 1)) for tree in
                      ("paper", "paper-grown"))
        visits = rule["counters"]["node_visits"]
        said = ["a radius passes 14 bits", "-"]
        if free:
            more = free["counters"]["node_visits"]
            said = [str(more), f"{100 * more / visits - 100:.1f} %"]
        rows.append([f"`{name}`", str(visits), *said])
    return rows


def saved():
    """Nodes of MAX_PRIMS 8 by those of 1, of Table 4.2: ours and the thesis's."""
    head, rows = data.read("trees.bih_statistics")
    count = {row[0]: [tuple(map(int, re.findall(r"\d+", cell))) for cell in row[1:]]
             for row in rows if row[0] in ("internal nodes", "leaves")}
    found = [["nodes that leaves of 8 save", "ours", "the thesis's"]]
    for i in range(0, len(head) - 1, 2):
        every, few = ([sum(count[kind][i + k][who] for kind in count) for who in (0, 1)]
                      for k in (0, 1))
        found.append([head[1 + i].split(",")[0],
                      *(f"{100 - 100 * few[who] / every[who]:.1f} %" for who in (0, 1))])
    return found


def separated(run):
    """Percent of the pixels that are traced: by each way of the machine, by the first and the last
    pixel of a row that sees anything, and by tiles of which a pixel does."""
    rows = [["scene", *WAYS, "rows of objects", *(f"tiles of {n}" for n in TILES), "see something"]]
    for name in SEPARATED:
        key = "separated-" + re.sub("[:/]", "_", name)
        if not run.fresh(key + ".json"):
            run.run("background", run.scene(name), "--size", SIZE, "--json",
                    run.path(key + ".json"), good=(0, 1))
        ways = {way["way"]: way["rays"] for way in whole.load(run.path(key + ".json"))["ways"]}
        run.counted(name, "--depth", "0")
        hits = ids(run.path("-".join([re.sub("[:/]", "_", name), "depth", "0"]) + ".frame"))
        at = [(i % WIDTH, i // WIDTH) for i, hit in enumerate(hits) if hit != NO_ID]
        traced = [ways[way] for way in WAYS]
        row = {}
        for x, y in at:
            low, high = row.get(y, (x, x))
            row[y] = min(low, x), max(high, x)
        traced.append(sum(high - low + 1 for low, high in row.values()))
        for n in TILES:
            traced.append(sum(min(n, WIDTH - n * x) * min(n, HEIGHT - n * y)
                              for x, y in {(x // n, y // n) for x, y in at}))
        traced.append(len(at))
        rows.append([f"`{name}`", *(f"{100 * n / (WIDTH * HEIGHT):.1f}" for n in traced)])
    return rows


def main(tool, folder, page):
    run = Runner(tool, folder)
    place(page, "make swept", {"fits": lambda: fits(run), "grown": lambda: grown(run),
                               "saved": saved, "separated": lambda: separated(run)})
