# trees.py - trees beside each other, against a bound, and the paper's walk: `make trees`
# SPDX-License-Identifier: Apache-2.0
"""Renders scenes with each tree and puts the tables into PAGE. What must not change a picture is
held against the nearest hit's.

The bound holds for primary rays, whatever the tree: a ray that hits a primitive must visit every
node above it, and any other ray the root. With w rays that end at each primitive the sum of w times
the nodes above is least in Huffman's tree of four children.
"""
import heapq
import json
import os
import struct
import sys

from .pages import whole
from .pages.place import place
from .runner import PROTEIN
from .runner import Runner as Runs
from .synth import report
from .tree_options import BVH4, OF_FOUR, options

NO_ID, HEAD = 0xFFFFFF, 32  # of a frame file: cmodel/core/frame.h
SIZE, LARGE = "160x90", "96x64"
BALLS = [("`paper100`", "paper100"), ("random:256", "gen random:256"),
         ("sphereflake:3", "gen sphereflake:3"), ("random:1000", "gen random:1000"),
         ("random:4096", "gen random:4096"), ("1TII, a protein", "import " + PROTEIN),
         ("sphereflake:4", "gen sphereflake:4")]
ALL = [("`paper5`", "paper5"), ("`sphereflake2`", "sphereflake2"), *BALLS]
LARGEST = [("random:100000", "gen random:100000"), ("random:1000000", "gen random:1000000")]
BUILT = [tree for tree in BVH4 if tree.startswith("hw")]
FRAMES, DRIFTS = 12, [(1000, .02), (1000, .2), (4096, .02), (4096, .2)]  # spheres, way of a frame
MIXED = [(f"`{name}`", name) for name in ("facets/room", "texture/kitchen", "texture/museum",
                                          "texture/robot", "paper100", "sphereflake2")]
FACETS = [("`facets/plane`", "facets/plane"), ("`facets/triangles`", "facets/triangles"),
          ("icosphere:1", "gen icosphere:1"), ("`facets/room`", "facets/room"),
          ("icosphere:3", "gen icosphere:3")]
WALKED = [("`paper5`", "paper5"), ("`sphereflake2`", "sphereflake2"), ("`paper100`", "paper100"),
          ("random:4096", "gen random:4096")]
# in kinds of trees, and whose times are told as those of another
KINDS = [("`paper100`", "paper100"), ("random:4096", "gen random:4096"),
         ("sphereflake:3", "gen sphereflake:3"), ("`facets/room`", "facets/room"),
         ("`texture/kitchen`", "texture/kitchen")]
BESIDE = {"boxes": "boxes", "kd": "boxes"}
FIRST = ["--tree", "paper", "--traverse", "first", "--interpenetrate"]


def ids(path):
    """Of every pixel of a frame file, the primitive that its primary ray hits."""
    with open(path, "rb") as f:
        data = f.read()
    _, width, height, frames, counters = struct.unpack_from("<5I", data, 8)
    first, size = HEAD + 8 * counters, 4 * frames + 20
    return [struct.unpack_from("<I", data, first + size * i + 4 * frames)[0]
            for i in range(width * height)]


def bound(hits, primitives):
    """Least mean of visits of rays that hit these primitives of so many."""
    weights = {}
    for number in hits:
        weights[number] = weights.get(number, 0) + 1
    total = weights.pop(NO_ID, 0)
    heap = sorted([*weights.values()] + [0] * (primitives - len(weights)))
    heap = [0] * (-(len(heap) - 1) % 3) + heap
    while len(heap) > 1:
        node = sum(heapq.heappop(heap) for _ in range(4))
        total += node
        heapq.heappush(heap, node)
    return total / len(hits)


class Runner(Runs):
    def scene(self, source):
        """The file of a scene: of scenes/, or made by words of the tool."""
        if " " not in source:
            return f"scenes/{source}.nff"
        if source.startswith("import ") and not whole.there(source.split()[1]):
            raise FileNotFoundError(2, "", source.split()[1])
        path = self.path("scene.nff")
        self.run(*source.split(), "-o", path)
        return path

    def drawn(self, scene, *words, size=SIZE, frame="frame"):
        """Report of a frame, which lies in the folder as `frame`."""
        print("  RUN ", os.path.basename(scene), *words, flush=True)
        return json.loads(self.run("render", scene, "--profile", "standard", "--size", size, *words,
                                   "--frame", self.path(frame), "--json", "-"))


def rays(counters):
    return sum(n for name, n in counters.items() if name.startswith("rays_"))


def primitives(drawn):
    return sum(drawn["machine"].get(kind, 0) for kind in ("spheres", "triangles", "planes"))


def each(drawn, *names):
    """Counters of a ray."""
    counters = drawn["counters"]
    return [f"{counters[name] / rays(counters):.2f}" for name in names]


def same(scene, *drawn):
    if len({d["frame"]["picture_hash"] for d in drawn}) != 1:
        sys.exit(f"trees: {scene}: the pictures are not the same")


def work(runner, scenes, tests, what):
    """Visits and tests of a ray in the balanced tree and the paper's, and tests of brute force."""
    rows = []
    for name, source in scenes:
        scene = runner.scene(source)
        balanced, paper = (runner.drawn(scene, *options(tree)) for tree in ("balanced", "paper"))
        brute = runner.drawn(scene, "--brute", "--axes", "camera")  # as the trees have them
        same(scene, balanced, paper, brute)
        rows.append([name, primitives(brute), *each(balanced, "node_visits", "child_tests", tests),
                     *each(paper, "node_visits", "child_tests", tests), *each(brute, tests)])
    return report.table(["scene", "primitives", "balanced: visits", "tests", what, "paper: visits",
                         "tests", what, "brute: " + what], rows)


def bounded(runner):
    """Visits of a ray, of all rays and of the primary ones, and the bound for these."""
    rows = []
    for name, source in BALLS:
        scene, all_rays, primary = runner.scene(source), [], []
        for tree in OF_FOUR:
            all_rays.append(runner.drawn(scene, *options(tree)))
            primary.append(runner.drawn(scene, *options(tree), "--depth", "0", "--shadow", "off"))
        same(scene, *all_rays)
        n = primitives(primary[0])
        rows.append([name, n, *(each(d, "node_visits")[0] for d in all_rays + primary),
                     f"{bound(ids(runner.path('frame')), n):.2f}"])
    return report.table(["scene", "spheres", *OF_FOUR, *(f"primary: {tree}" for tree in OF_FOUR),
                         "bound"], rows)


def hardware(runner):
    """Visits of a ray in the trees that hardware builds and in those of the host; of primary rays,
    against their bound. The paper's tree of a million spheres takes an hour and is left out."""
    rows = []
    for name, source in [("`paper5`", "paper5"), *BALLS, *LARGEST]:
        scene = runner.scene(source)
        trees = [tree for tree in BVH4 if tree != "paper" or source != LARGEST[-1][1]]
        drawn = {tree: runner.drawn(scene, *options(tree)) for tree in trees}
        same(scene, *drawn.values())
        primary = runner.drawn(scene, *options("hw1"), "--depth", "0", "--shadow", "off")
        n = primitives(primary)
        visits = {tree: each(d, "node_visits")[0] for tree, d in drawn.items()}
        rows.append([name, n, *(visits.get(tree, "-") for tree in BVH4),
                     *(f"{float(visits[tree]) / float(visits['reinserted']):.2f}"
                       for tree in BUILT),
                     each(primary, "node_visits")[0], f"{bound(ids(runner.path('frame')), n):.2f}"])
    return report.table(["scene", "spheres", *BVH4, *(f"{tree} / reinserted" for tree in BUILT),
                         "primary: hw1", "bound"], rows)


def moved(runner):
    """Visits of a ray in the last of FRAMES frames: trees that are built in each, and refitted."""
    ways = {"reinserted": options("reinserted"),
            "refitted": [*options("reinserted"), "--refit", "on"],
            **{tree: options(tree) for tree in BUILT}}
    rows = []
    for n, drift in DRIFTS:
        scene, last = runner.path("scene.nff"), []
        runner.run("gen", "random", "-n", n, "--drift", drift, "-o", scene)
        for words in ways.values():
            print("  RUN ", n, drift, *words, flush=True)
            frames = json.loads(runner.run("render", scene, "--profile", "standard", "--size",
                                           LARGE, "--frames", f"0..{FRAMES - 1}", *words,
                                           "--json", "-"))["frames"]
            last.append(frames[-1])
        same(scene, *last)
        rows.append([f"random:{n}", drift, *(each(frame, "node_visits")[0] for frame in last)])
    return report.table(["scene", "a frame", *ways], rows)


def boxes(runner):
    """Visits and exact tests a pixel."""
    ways = {"bvh4": options("bvh4"), "bih": options("bih1"), "box4": options("box4")}
    width, height = map(int, LARGE.split("x"))
    rows = []
    for name, source in MIXED:
        row = []
        for words in ways.values():
            drawn = runner.drawn(runner.scene(source), *words, size=LARGE)
            c = drawn["counters"]
            row.append(" / ".join(f"{n / width / height:.1f}" for n in (
                c["node_visits"], c["leaf_tests"] + c["facet_tests"])))
        rows.append([name, primitives(drawn), *row])
    return report.table(["scene", "primitives", *ways], rows)


def walked(runner):
    """Tests a ray of the paper's walk, and pixels in which it differs from the nearest hit."""
    rows = []
    for name, source in WALKED:
        scene = runner.scene(source)
        row = [name, *each(runner.drawn(scene, "--tree", "paper", frame="nearest"), "child_tests")]
        for how in "off", "on":
            drawn = runner.drawn(scene, *FIRST, how)
            told = json.loads(runner.run("compare", "--ignore-work", runner.path("nearest"),
                                         runner.path("frame"), "--json", "-", good=(0, 1)))
            row += [*each(drawn, "child_tests"), told["difference"]["pixels"]]
        rows.append(row)
    return report.table(["scene", "paper's tree, nearest", "first", "pixels", "first, corrected",
                         "pixels"], rows)


def main(tool, folder, page):
    runner = Runner(tool, folder)
    place(page, "make trees", {
        "work": lambda: work(runner, ALL, "leaf_tests", "leaves"),
        "bound": lambda: bounded(runner), "hardware": lambda: hardware(runner),
        "moved": lambda: moved(runner),
        "boxes": lambda: boxes(runner),
        "facets": lambda: work(runner, FACETS, "facet_tests", "facets"),
        "walk": lambda: walked(runner)})


def of_kinds(runner, name, source):
    """The rows of a scene, a kind of trees each."""
    found = json.loads(runner.run("trees", runner.scene(source), "--profile", "standard", "--size",
                                  "320x180", "--json", "-"))
    trees = {tree["tree"]: tree for tree in found["trees"]}
    for tree in trees.values():
        rays, one = tree["rays"], trees[BESIDE.get(tree["tree"], "bih")]
        build, draw = (report.times(tree[what] / one[what]) for what in ("build_seconds",
                                                                         "draw_seconds"))
        yield [name, tree["tree"], tree["nodes"], tree["node_bytes"], tree["bytes"],
               f"{tree['steps'] / rays:.2f}", f"{tree['tests'] / rays:.2f}", build, draw]


def kinds(tool, folder, page):
    """Kinds of trees beside each other, as `sphaera trees` has them."""
    runner = Runner(tool, folder)
    place(page, "make kinds", {"kinds": report.table(
        ["scene", "tree", "nodes", "bytes a node", "bytes", "steps", "tests", "build", "draw"],
        [row for scene in KINDS for row in of_kinds(runner, *scene)], 2)})
