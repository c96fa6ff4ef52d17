# releases.py - cells of the cores that several releases of Yosys have mapped
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `releases` into PAGE: of each core in BUILD/synth and BUILD/synth-VERSION that two
releases have mapped, as `make synth` and `make synth YOSYS=...` leave them."""
from collections import defaultdict
from pathlib import Path

from ..pages.place import place
from . import results

TARGET = "ecp5"


def rows(build):
    found = defaultdict(list)
    for stat in sorted(Path(build).glob(f"synth*/*-{TARGET}-*/stat.json")):
        if (stat.parent / "depth").exists():
            run = results.read(stat.parent)
            found[run["key"]].append((run["yosys"].split()[1], run["core"]))
    names = [(name, head) for name, head in results.columns(TARGET) if name in
             ("mult", "lut4", "carry", "lut4eq", "dpr", "places", "ff", "bram")]
    yield ["core", "Yosys", *(head for _, head in names)]
    for key, runs in sorted(found.items()):
        for version, core in runs if len(runs) > 1 else ():
            yield [f"`{key}`", version, *(str(core[name]) for name, _ in names)]


def main(build, page):
    place(page, "make releases", {"releases": list(rows(build))})
