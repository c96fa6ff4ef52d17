# regions.py - what each region of a page is made from
# SPDX-License-Identifier: Apache-2.0
"""The name of a region is a word of MAKERS and its arguments."""
from ..effects import asks
from .. import clocks, summary
from ..papers import claims
from . import blocks, board, cores, data, definitions, measured, rates, schema, state


class Unknown(Exception):
    """A region that nothing makes."""


def count(kind, *words):
    """How many lines of machine.def a kind has, those with all the words."""
    return str(sum(set(words) <= set(row) for row in definitions.rows(kind)))


def const(name):
    return definitions.constants()[name]


MAKERS = {
    "parameters": blocks.parameters, "ports": blocks.ports, "interface": blocks.interface,
    "bundles": definitions.bundles, "registers": definitions.registers, "top_registers":
    definitions.top_registers, "effects": definitions.effects, "counters": definitions.counters,
    "errors": definitions.errors, "file_header": definitions.file_header, "file_number":
    definitions.file_number, "profiles": definitions.profiles, "widths": definitions.widths,
    "count": count, "const": const, "measured": measured.region, "rows": data.rows, "cell":
    data.cell, "core": cores.core, "cores": cores.cores, "inside": cores.inside, "yosys":
    cores.yosys, "budget": cores.budget, "asks": asks.table, "modes": definitions.modes,
    "core_runs": cores.runs, "schema": schema.members, "claims": claims.table, "verdicts":
    claims.verdicts, "board": board.board, "clock": clocks.mhz, "clocks": rates.routed, "rates":
    rates.table, "state": state.table, "stages": state.counts, "frames": rates.frames,
    "milliseconds": rates.milliseconds, "against": rates.against, "nearest": rates.nearest,
    "misses": summary.misses,
}


def make(name):
    """The text of a region."""
    maker, *arguments = name.split()
    if maker not in MAKERS:
        raise Unknown(f"no region is called `{name}`; there are {', '.join(sorted(MAKERS))}")
    try:
        return MAKERS[maker](*arguments)
    except (TypeError, KeyError, OSError, cores.Unmeasured) as fault:
        raise Unknown(f"region `{name}`: {fault}") from fault
