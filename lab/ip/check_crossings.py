#!/usr/bin/env python3
# check_crossings.py - every crossing of clocks in a netlist is named by each file of constraints
# SPDX-License-Identifier: Apache-2.0
"""usage: check_crossings.py NETLIST.json FILE.xdc|FILE.sdc...

The netlist is Yosys's: read_verilog..., `proc; flatten; opt_clean; write_json NETLIST.json`.
A crossing is a register or memory that takes a bit of one that runs by another clock. It is named
by a set_max_delay whose -from and -to both have it: as a clock, or as cells by their names. What a
constraint has for its end alone must be a synchroniser: it takes its bits through no logic, it and
the register behind it are marked as such in the sources, and in the .xdc by ASYNC_REG. An input
port is read by one clock. Exit code 1 and what is wrong, a line each."""
import re
import sys
from fnmatch import fnmatchcase
from pathlib import Path

try:
    from .netlist import LOGIC, Netlist
except ImportError:                     # in the folder of an IP
    from netlist import LOGIC, Netlist

CELLS = re.compile(r"NAME =~ ([^\s}|]+)|get_cells \{([^}]+)\}")
CLOCK = re.compile(r"get_ports (\w+)|get_clocks (\w+)")


class End:
    """-from or -to of a constraint: a clock, or patterns of cells."""

    def __init__(self, text):
        self.cells = [word for one, more in CELLS.findall(text) for word in (one or more).split()]
        clock = CLOCK.search(text)
        self.clock = (clock[1] or clock[2]) if clock and not self.cells else None

    def has(self, state):
        if self.clock:
            return state.clock == self.clock
        # as registers are called behind synthesis; memories may be of several cells
        return any(fnmatchcase(f"{state.name}_reg", one.replace("[", "[[]")) for one in self.cells)


def constraints(path):
    """[(line, from, to)], patterns of cells that are ASYNC_REG or None if the kind has none."""
    found, marked = [], [] if path.endswith(".xdc") else None
    for number, line in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("set_max_delay"):
            start, to = line.index(" -from "), line.index(" -to ")
            found.append((number, End(line[start:to]), End(line[to:])))
        elif line.startswith("set_property ASYNC_REG"):
            marked.append(End(line))
    return found, marked


def unmarked(netlist, state, marked):
    """What is wrong with a synchroniser's two registers."""
    behind = [s for s in netlist.states.values() if s.takes & state.bits]
    if len(behind) != 1 or behind[0].clock != state.clock or \
            any(netlist.come_from(bit) & LOGIC for bit in behind[0].takes):
        return ["is not followed by one register alone"]
    return [f"{s.name} {why}" for s in (state, behind[0])
            for good, why in ((s.marked, "has no async_reg in the sources"),
                              (marked is None or any(m.has(s) for m in marked), "is no ASYNC_REG"))
            if not good]


def check(netlist, path):
    """What is wrong, a line each, and how many crossings there are."""
    wrong, used = [], set()
    named, marked = constraints(path)
    crossings = netlist.crossings()
    for source, state, through in crossings:
        told = f"{path}: {source.name} ({source.clock}) to {state.name} ({state.clock})"
        fits = [(n, a, b) for n, a, b in named if a.has(source) and b.has(state)]
        used.update(n for n, _, _ in fits)
        if not fits:
            wrong.append(f"{told}: no constraint names this crossing")
        elif not any(a.cells for _, a, _ in fits):
            wrong += [f"{told}: through logic"] * through
            wrong += [f"{told}: {why}" for why in unmarked(netlist, state, marked)]
    wrong += [f"{path}:{n}: there is no such crossing" for n, _, _ in named if n not in used]
    return wrong, len(crossings)


def ports(netlist):
    return [f"port {name} is read by {' and '.join(sorted(clocks))}"
            for name, clocks in netlist.readers().items() if len(clocks) > 1]


def main(path, *files):
    netlist = Netlist(path)
    wrong, number = ports(netlist), 0
    for file in files:
        said, number = check(netlist, file)
        wrong += said
    print("\n".join(wrong) if wrong else
          f"{number} crossings of {len(netlist.clocks)} clocks, each named by "
          f"{' and '.join(Path(f).name for f in files)}")
    return bool(wrong)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
