# known.py - cells and clocks of cores that pages have, for the tool: cmodel/trial/known_table.h
# SPDX-License-Identifier: Apache-2.0
"""Writes FILE: a line a core of one engine for an ECP5, its cells from docs/results/data
(accuracy.kinds, else accuracy.costs, whose profiles were synthesised together, else effects.costs,
else effects.left_out) and its clock from clocks.tsv. Then a line a word that cores have, and what
it adds: the median over pairs of cores of a table that differ in it, and in what is known before,
alone; of words that no pair tells, what the whole core loses without (effects.prices). Then what
events take in standard cells, of the tables of silicon.md."""
import itertools
import re
import statistics
from functools import lru_cache

from . import clocks, intact
from .pages import data
from .silicon import fit
from .study.points import CORE, PROFILES

HEAD = """/* known_table.h - generated from docs/results/data by `python3 -m lab known`; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
"""
TABLE = """/* profile, effects, pipes, LUT4eq, MULT18X18D, DP16KD, worst, median, best MHz, seeds */
#define SPH_KNOWN_CORES \\
"""
WORDS = """/* word, what it adds to a core of profile standard: LUT4eq, MULT, DP16KD; points */
#define SPH_KNOWN_WORDS \\
"""
EVENTS = """/* counter, nJ of an event in profile standard; what it is of; the tree of its cores */
#define SPH_KNOWN_EVENTS \\
"""
SCALES = """/* profile, what its events take of that; nJ a clock and LUT4eq; with triangles */
#define SPH_KNOWN_PROFILE_ENERGIES \\
"""
ENERGY = """/* words of the cores whose energies these are */
#define SPH_KNOWN_ENERGY_WORDS \\
"""
POINTS = {"reflect", "lights", "interpenetrate", "texture", "refract"}  # need hit points
KEY = re.compile(r"(?P<profile>[a-z]+)-ecp5-(?P<effects>[a-z0-9+]+)-engines1"
                 r"(-pipes(?P<pipes>\d))?$")


@lru_cache(maxsize=None)
def cells(tables=("effects.left_out", "effects.costs", "accuracy.costs", "accuracy.kinds")):
    """{(profile, effects, pipes): LUT4eq, MULT, DP16KD}"""
    found = {}
    for table in tables:
        head, rows = data.read(table)
        for row in rows:
            cell = dict(zip(head, (word.strip("`") for word in row)))
            key = (cell.get("profile", "standard"), cell.get("core", CORE))
            if key[0] in PROFILES and not key[1].startswith("all") and cell["LUT4eq"] != "-":
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


def parts(core):
    """The words of a core, whatever their counts; "points" if there is one of POINTS."""
    found = {word.rstrip("0123456789") for word in core.split("+")} - {"none"}
    return found | ({"points"} if found & POINTS else set())


def priced():
    """{word: what the core with everything loses without it}"""
    head, rows = data.read("effects.prices")
    cells_of = [dict(zip(head, row)) for row in rows]
    return {cell["core"].removeprefix("without "): [
        -int(cell[what]) for what in ("LUT4eq", "MULT18X18D", "DP16KD")]
        for cell in cells_of if re.fullmatch("without [a-z]+", cell["core"])}


def pairs():
    """(words, counts) of two cores that were synthesised together, in one profile."""
    for table in ("effects.costs", "effects.left_out", "accuracy.kinds"):
        found = cells((table,))
        for profile in sorted({of for of, _, _ in found}):
            cores = [(parts(core), list(map(int, counts)))
                     for (of, core, _), counts in found.items() if of == profile]
            yield from itertools.permutations(cores, 2)


def told(known):
    """{how many words differ: {word: counts of each pair}} of words that are not known."""
    found = {}
    for (more, larger), (less, smaller) in pairs():
        differ = more ^ less
        new = differ - known.keys()
        if len(new) != 1 or not new <= more:
            continue
        word = new.pop()
        rest = [sum(known[other][i] * (1 if other in more else -1)
                    for other in differ - {word}) for i in range(3)]
        found.setdefault(len(differ), {}).setdefault(word, []).append(
            [a - b - c for a, b, c in zip(larger, smaller, rest)])
    return found


def words():
    """{word: LUT4eq, MULT, DP16KD that it adds}"""
    known = {}
    while True:
        found = told(known)
        if not found:
            return priced() | known
        for word, counts in found[min(found)].items():
            known[word] = [round(statistics.median(each)) for each in zip(*counts)]


def main(file):
    area, clock = cells(), routed()
    lines = [f'    {{"{profile}", "{effects}", {pipes}, '
             + ", ".join(area.get((profile, effects, pipes), ["0"] * 3)
                         + clock.get((profile, effects, pipes), ["0"] * 4)) + ", 0, 0}"
             for profile, effects, pipes in sorted(area.keys() | clock.keys())]
    costs = [f'    {{"{word}", {", ".join(map(str, counts))}, {int(word in POINTS)}}}'
             for word, counts in sorted(words().items())]
    of = fit.model()
    events = [f'    {{SPH_COUNT_{counter.upper()}, {weight:.4f}, "{name}", "{tree or ""}"}}'
              for (name, (counter, tree)), weight in zip(fit.EVENTS.items(), of.weights) if weight]
    energies = ['    {' + ", ".join([f'"{profile}"', f"{scale:.3f}", *[
        f"{clock:.4g}" for clock in of.clocks[profile]]]) + "}"
                for profile, scale in sorted(of.scales.items())]
    measured = [f'    "{word}"' for word in sorted(of.words)]
    parts = ((TABLE, lines), (WORDS, costs), (EVENTS, events), (SCALES, energies),
             (ENERGY, measured))
    intact.write(file, HEAD + "".join(head + ", \\\n".join(rows) + "\n" for head, rows in parts))
