# units.py - how busy each unit of the core was, from the counters of a run
# SPDX-License-Identifier: Apache-2.0
"""The clocks that a unit needs for its work follow from its interval, which is a parameter of
rt_core or stands on its page in docs/blocks; what else it waits for is not counted, so each share
is a lower bound. The frame cannot take fewer clocks than its busiest unit."""
from collections import namedtuple
from math import ceil
from pathlib import Path

from ..pages import verilog

Unit = namedtuple("Unit", "name clocks what")  # of an engine, or of the one memory port

GLOSS = 24      # docs/blocks/shading_unit.md: clocks a highlight
BEATS = 4       # of a line
LINE = 32       # its bytes
RECORD = 1      # docs/blocks/leaf_unit.md: clocks a request of a record


def parameters(key):
    """Parameters of the core: defaults of rt_core.v, and what the run was given."""
    found, _ = verilog.header(Path("rtl/core/rt_core.v"), {})
    values = {p.name: int(p.default) for p in found if p.default.isdigit()}
    values.update((name, int(key[name])) for name in ("ENGINES", "ROOT_STEP", "QUOTIENT_STEP")
                  if key.get(name))
    return values


def lines_of(count, core):
    """Lines that caches asked for."""
    return count["node_misses"] + count["leaf_misses"] \
        + count["texel_misses"] * core["TEXTURE_GROUP"]


def units(count, machine, core):
    """Units that had work, the busiest first. count: counters of the core by name; machine: of
    build.json; core: parameters()."""
    engines, width = core["ENGINES"], machine["widths"]
    root = ceil((width["PR"] or width["W"] + width["WD"]) / core["ROOT_STEP"]) + 1
    quotient = ceil(width["PQ"] / core["QUOTIENT_STEP"]) + 2
    division = ceil((width["W"] + width["WD"] + 1) / core["DIVISION_STEP"]) + 1
    hits = count["quotients"]
    vectors = count["rays_primary"] + count["rays_reflected"] + count["rays_refracted"] \
        + hits * (1 + machine["lights"])
    lines = lines_of(count, core)
    each = [
        ("nodes", count["node_visits"] + count["pop_bubbles"], "a visit a clock"),
        ("spheres, exact", count["leaf_tests"] * core["LEAF_INTERVAL"] + hits * RECORD,
         f"a test every {core['LEAF_INTERVAL']} clocks, and records of what is seen"),
        ("facets, exact", count["facet_tests"] * core["FACET_INTERVAL"],
         f"a test every {core['FACET_INTERVAL']} clocks"),
        ("keys of facets", count["divisions"] * division / core["DIVISIONS"],
         f"{core['DIVISIONS']} dividers of {division} clocks"),
        ("roots", count["roots"] * root / core["ROOTS"],
         f"{core['ROOTS']} units of {root} clocks"),
        ("set-up of rays", vectors * core["UNIT_INTERVAL"] / core["UNITS"],
         f"{core['UNITS']} units of {core['UNIT_INTERVAL']} clocks: rays, normals, lights"),
        ("quotients", hits * quotient / core["QUOTIENTS"],
         f"{core['QUOTIENTS']} units of {quotient} clocks or more"),
        ("points, normals", hits * core["HIT_INTERVAL"], f"one every {core['HIT_INTERVAL']}"),
        ("mirror rays", count["rays_reflected"] * core["BOUNCE_INTERVAL"],
         f"one every {core['BOUNCE_INTERVAL']}"),
        ("highlights", count["powers"] * GLOSS, f"one every {GLOSS}"),
    ]
    found = [Unit(name, clocks / engines, what) for name, clocks, what in each if clocks]
    if lines:
        found.append(Unit("memory port", lines * BEATS, f"{lines} lines of {BEATS} beats"))
    return sorted(found, key=lambda unit: -unit.clocks)
