# units.py - how busy each unit of the core was
# SPDX-License-Identifier: Apache-2.0
"""In Verilator the bench counts the clocks in which each unit works, and says what limits a pass
(docs/guide/simulation.md): counted(). Of other runs the counters of the core alone tell something:
least() has the clocks that some units need at their intervals, parameters of rt_core. That is a
lower bound, of units whose work has a counter, and does not tell what limits the frame."""
import subprocess
from collections import namedtuple
from math import ceil
from pathlib import Path

from ..pages import verilog

Unit = namedtuple("Unit", "name clocks what")  # of an engine, or of the one memory port

GLOSS = 24      # docs/design/shading.md: clocks a highlight
BEATS = 4       # of a line
LINE = 32       # its bytes
RECORD = 1      # docs/design/primitives.md: clocks a request of a record


def said(*script):
    """What a script of sim/ prints."""
    return subprocess.run(["sh", *script], check=True, capture_output=True, text=True).stdout


def parameters(key, built, profile="standard"):
    """Parameters of the core: defaults of rt_core.v, the pace of its profile, and what the run was
    given. built: the list of sim/parameters.sh that it has."""
    found, _ = verilog.header(Path("rtl/core/rt_core.v"), {})
    values = {p.name: int(p.default) for p in found if p.default.isdigit()}
    sizes = said("sim/profile.sh", profile) + said("sim/sizes.sh", key.get("SIZES", ""))
    values.update((name, int(value)) for name, value in
                  (size.split("=") for size in sizes.split()))
    values.update((name, int(key[name])) for name in
                  ("ENGINES", "PIPES", "LEAF_UNITS", "SHADES", "ROOT_STEP", "QUOTIENT_STEP")
                  if key.get(name))
    has = said("sim/parameters.sh", built).split()
    interpenetrate = "INTERPENETRATE=1" in has                   # as the rules of rt_core.v
    pipes = values["PIPES"]
    values["SHADES"] = values["SHADES"] or (1 if interpenetrate else [1, 2, 2, 4][pipes - 1])
    values["BOXES"] = int("BOXES=1" in has)
    values["LEAF_UNITS"] = values["LEAF_UNITS"] or (
        values["SHADES"] if values["BOXES"] else 2 if pipes > 2 and values["SHADES"] > 1 else 1)
    values["SETUPS"] = values["SETUPS"] or (2 if pipes == 4 and values["LEAF_UNITS"] > 1 else 1)
    values["WALKS"] = values["WALKS"] or (1 if pipes == 1 else 2)
    values["ROOTS"] = values["ROOTS"] or (3 if pipes == 1 else 6)
    values["DIVISIONS"] = values["DIVISIONS"] or (3 if values["BOXES"] else 1)
    return values


def facet(core, width):
    """Clocks a test of a facet, as the rule of rt_core.v. width: W."""
    return core["FACET_INTERVAL"] or (2 if core["BOXES"] or width < 18 else 4)


def lines_of(count, core):
    """Lines that caches asked for."""
    return count["node_misses"] + count["leaf_misses"] \
        + count["texel_misses"] * core["TEXTURE_GROUP"]


def counted(last):
    """Every unit that the core has, the busiest first, of a pass of report.json; none if nobody
    counted them."""
    found, cycles = [], last["counters"]["cycles"]
    for row in last.get("units", []):
        many = row["units"]
        said = f"{row['taken']} results"
        if row["taken"]:
            said += f", {row['clocks'] / row['taken']:.1f} clocks each"
        if cycles and row["turned_away"]:
            said += f", an operand waits in {row['turned_away'] / many / cycles:.1%}"
        found.append(Unit(row["name"], row["clocks"] / many,
                          said + (f"; {many} of them" if many > 1 else "")))
    return found


def units(last, machine, core):
    """counted(), or else least()."""
    return counted(last) or least(last["counters"], machine, core)


def least(count, machine, core):
    """Some units that had work, the busiest first, by what the counters tell. count: counters of
    the core by name; machine: of build.json; core: parameters()."""
    engines, width = core["ENGINES"], machine["widths"]
    root = ceil((width["PR"] or width["W"] + width["WD"]) / core["ROOT_STEP"]) + 1
    quotient = ceil(width["PQ"] / core["QUOTIENT_STEP"]) + 2
    division = ceil((width["W"] + width["WD"] + 1) / core["DIVISION_STEP"]) + 1
    hits = count["quotients"]
    vectors = count["rays_primary"] + count["rays_reflected"] + count["rays_refracted"] \
        + hits * (1 + machine["lights"])
    lines = lines_of(count, core)
    pipes, leaves, shades = core["PIPES"], core["LEAF_UNITS"], core["SHADES"]
    each = [  # name, of how many an engine has, clocks of all together
        ("nodes", pipes, count["node_visits"] + count["pop_bubbles"], "a visit a clock"),
        ("spheres, exact", leaves, count["leaf_tests"] * core["LEAF_INTERVAL"] + hits * RECORD,
         f"a test every {core['LEAF_INTERVAL']} clocks, and records of what is seen"),
        ("facets, exact", leaves, count["facet_tests"] * facet(core, width["W"]),
         f"a test every {facet(core, width['W'])} clocks"),
        ("keys of facets", leaves, count["divisions"] * division / core["DIVISIONS"],
         f"{core['DIVISIONS']} units of {division} clocks"),
        ("roots", leaves, count["roots"] * root / core["ROOTS"],
         f"{core['ROOTS']} units of {root} clocks"),
        ("set-up of rays", core["SETUPS"], vectors * core["UNIT_INTERVAL"] / core["UNITS"],
         f"{core['UNITS']} units of {core['UNIT_INTERVAL']} clocks: rays, normals, lights"),
        ("quotients", shades, hits * quotient / core["QUOTIENTS"],
         f"{core['QUOTIENTS']} units of {quotient} clocks or more"),
        ("points, normals", shades, hits * core["HIT_INTERVAL"],
         f"one every {core['HIT_INTERVAL']}"),
        ("mirror rays", shades, count["rays_reflected"] * core["BOUNCE_INTERVAL"],
         f"one every {core['BOUNCE_INTERVAL']}"),
        ("highlights", shades, count["powers"] * GLOSS, f"one every {GLOSS}"),
    ]
    found = [Unit(name, clocks / engines / many, what + (f", {many} an engine" if many > 1 else ""))
             for name, many, clocks, what in each if clocks]
    if lines:
        found.append(Unit("memory port", lines * BEATS, f"{lines} lines of {BEATS} beats"))
    return sorted(found, key=lambda unit: -unit.clocks)
