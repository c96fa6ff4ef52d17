# known.py - cells and clocks of cores that pages have, for the tool: cmodel/trial/known_table.h
# SPDX-License-Identifier: Apache-2.0
"""Writes FILE: a line a core of one engine for an ECP5, its cells from docs/results/data
(accuracy.costs, whose profiles were synthesised together, else effects.costs) and its clock from
clocks.tsv."""
import re

from . import clocks, intact
from .pages import data
from .study.points import CORE, PROFILES

HEAD = """/* known_table.h - generated from docs/results/data by `python3 -m lab known`; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
/* profile, effects, pipes, LUT4eq, MULT18X18D, DP16KD, worst, median, best MHz, seeds */
#define SPH_KNOWN_CORES \\
"""
KEY = re.compile(r"(?P<profile>[a-z]+)-ecp5-(?P<effects>[a-z0-9+]+)-engines1"
                 r"(-pipes(?P<pipes>\d))?$")


def cells():
    """{(profile, effects, pipes): LUT4eq, MULT, DP16KD}"""
    found = {}
    for table, name in (("effects.costs", "core"), ("accuracy.costs", "profile")):
        head, rows = data.read(table)
        for row in rows:
            cell = dict(zip(head, (word.strip("`") for word in row)))
            key = (cell[name], CORE) if name == "profile" else ("standard", cell[name])
            if key[0] in PROFILES:
                found[(*key, 1)] = [cell[what] for what in ("LUT4eq", "MULT", "DP16KD")]
    return found


def routed():
    """{the same: MHz of the worst, median and best seed, and how many}"""
    found = {}
    for row in clocks.rows():
        key = KEY.match(row["core"])
        if key and (row["what"], row["speed grade"], row["after"]) == ("rt_core", clocks.SPEED,
                                                                       "routing"):
            found[(key["profile"], key["effects"], int(key["pipes"] or 1))] = \
                [row[what] for what in ("worst, MHz", "median, MHz", "best, MHz", "seeds")]
    return found


def main(file):
    area, clock = cells(), routed()
    lines = [f'    {{"{profile}", "{effects}", {pipes}, '
             + ", ".join(area.get((profile, effects, pipes), ["0"] * 3)
                         + clock.get((profile, effects, pipes), ["0"] * 4)) + "}"
             for profile, effects, pipes in sorted(area.keys() | clock.keys())]
    intact.write(file, HEAD + ", \\\n".join(lines) + "\n")
