# page.py - puts the tables of docs/results/speed_and_area.md in their places
# SPDX-License-Identifier: Apache-2.0
"""A table stands between `<!-- NAME -->` and `<!-- end -->`; NAME is a target, effects, modules or
profiles."""
import os
import sys

from ..pages import whole
from ..pages.place import place
from . import report, results


def profiles(runs):
    """Blocks with what is inside them: LUT4eq, then multipliers, for each profile on ecp5."""
    names = [name for name, m in sorted(runs[-1]["modules"].items(),
                                        key=lambda m: (-m[1]["total"]["lut4eq"], m[0]))
             if m["total"]["lut4eq"] >= 400 or m["total"]["mult"] > 1]
    rows = [[name] + [r["modules"][name]["total"][column] if name in r["modules"] else "-"
                      for column in ("lut4eq", "mult") for r in runs] for name in names]
    return report.table(["module"] + [r["profile"] for r in runs]
                        + [r["profile"] + " MULT" for r in runs], rows)


def main(page, folder, *keys):
    runs = [results.read(os.path.join(folder, key)) for key in keys
            if whole.there(os.path.join(folder, key, "stat.json"))]
    if whole.LACKING:
        sys.exit(f"page: {page} stays as it is: {', '.join(whole.LACKING)}")
    everything = [r for r in runs if r["list"] == "all" and not r["flat"]]
    ecp5 = [r for r in everything if r["target"] == "ecp5"]
    standard = [r for r in runs if r["profile"] == "standard" and r["target"] == "ecp5"]
    tables = {target: report.cores(everything, target)
              for target in results.COLUMNS if any(r["target"] == target for r in everything)}
    tables["effects"] = report.cores(standard, "ecp5")
    tables["modules"] = report.modules(next(r for r in ecp5 if r["profile"] == "standard"))
    tables["profiles"] = profiles(ecp5)
    place(page, "make area", tables, runs[0]["yosys"])
