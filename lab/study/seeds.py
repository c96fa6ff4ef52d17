#!/usr/bin/env python3
# seeds.py - the clocks of cores that were placed with several seeds
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.study.seeds CORE FOLDER...
Each folder, SPEED-SEED by name, has the placed.json of synth/place.sh. Writes rows of the core into
the table docs/results/data/accuracy.seeds.tsv: per speed grade the seeds, and the least, the median
and the greatest clock of them. Rows of other cores stay."""
import json
import statistics
import sys
from pathlib import Path

from .. import intact
from ..pages import data, measured

COLUMNS = ["core", "speed grade", "after", "seeds", "least, MHz", "median", "greatest"]


def rows(core, folders):
    clocks = {}
    for folder in folders:
        speed, seed = Path(folder).name.split("-")
        with open(f"{folder}/placed.json", encoding="utf-8") as f:
            placed = json.load(f)
        after = "routing" if placed["routed"] else "placement"
        clocks.setdefault((-int(speed), after), {})[int(seed)] = placed["fmax"]
    return [[f"`{core}`", str(-speed), after, str(len(seeds)), f"{min(seeds.values()):.1f}",
             f"{statistics.median(seeds.values()):.1f}", f"{max(seeds.values()):.1f}"]
            for (speed, after), seeds in sorted(clocks.items())]


def main(core, folders):
    others = [row for row in data.read("accuracy.seeds")[1] if row[0] != f"`{core}`"]
    table = [COLUMNS] + sorted(others + rows(core, folders), key=lambda row: row[0])
    intact.write(data.FOLDER / "accuracy.seeds.tsv", data.of_rows(table))
    measured.stamp("docs/results/accuracy.md", "make study-seeds", ["seeds"], rest=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
