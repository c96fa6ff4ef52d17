# swarm.py - a swarm whose tree rt_top builds, and whose the host builds or refits: `make swarm`
# SPDX-License-Identifier: Apache-2.0
"""Each row is a run of `make sim TOP=1`, whose frames equal the golden model's; figures are means
of the frames behind the first. A host's tree is part of what it uploads, one that rt_top builds is
not. Both go on while the frame before is drawn."""
import json
from pathlib import Path

from .pages.place import place
from .runner import said

SCENE, SIZE, FRAMES, WHOLE = "swarm:4096", (160, 90), "0..2", 1280 * 720
ROWS = [("host", "reinserted", "built", ["TREE=reinserted"]),
        ("host", "reinserted", "refitted", ["TREE=reinserted", "BUILD_MORE=--refit on"]),
        ("host", "hw", "built", ["TREE=hw"]),
        ("rt_top", "hw", "built", ["BUILD=hw"]),
        ("rt_top", "hw1", "built", ["BUILD=hw", "TREE=hw1"])]


def run(build, words):
    """The frames of a run behind the first."""
    text = said("make", "-s", "--no-print-directory", "sim", "TOP=1", f"SCENE={SCENE}",
                f"SIZE={SIZE[0]}x{SIZE[1]}", "PROFILE=standard", "DEPTH=0", "LATENCY=100",
                f"FRAMES={FRAMES}", f"B={build}", *words)
    folder = text.rpartition("report in ")[2].strip()
    return json.loads(Path(folder, "report.json").read_text("utf-8"))["frames"][1:]


def row(build, who, tree, how, words):
    frames = run(build, words)

    def mean(name):
        return sum(f[name] for f in frames) / len(frames)
    chip = "build_cycles" in frames[0]
    draw = mean("image_cycles") / SIZE[0] / SIZE[1]
    clocks = mean("build_cycles") if chip else 0
    return [who, tree, how, "-" if chip else f"{1e3 * mean('cpu_seconds'):.1f}",
            f"{mean('upload_bytes' if chip else 'memory_bytes'):.0f}",
            f"{mean('upload_cycles'):.0f}", f"{clocks:.0f}" if chip else "-", f"{draw:.2f}",
            f"{100 * clocks / draw / WHOLE:.2f}" if chip else "-"]


def main(build, page):
    place(page, "make swarm", {"swarm": lambda: [
        ["who", "tree", "how", "host, ms", "bytes", "upload, clocks", "build, clocks",
         "clocks a pixel", "building, % of a frame"], *(row(build, *r) for r in ROWS)]})
