# energy.py - what a toggle of each net, a clock and an access of each memory take
# SPDX-License-Identifier: Apache-2.0
"""characterise(netlist, layout, library, macros) gives a table that no netlist is needed for any
more: of each net the energy of a toggle, of each instance that of its clock pins, areas.

  switching   C V^2 / 2 of a toggle, C the input pins at the net; no wires
  internal    internal_power of the output that drives it, at its load, mean of its arcs, and of the
              input pins at it that have tables of their own; transitions go from gate to gate, each
              output's from the mean of its gate's inputs
  clock       of a clock: pins of flip-flops, both edges, the same two parts; behind a gate only in
              clocks that get through; the gate is a latch and an AND of the library
  ram         accesses times the table of macros
"""
from collections import defaultdict
from dataclasses import dataclass

from .liberty import Bad, Table

EDGE = 0.1          # ns: transitions of ports, and of a library without tables of them


def mean(tables):
    """One table of several that have the same axes; else a list of them."""
    if not tables or any(table.axes != tables[0].axes for table in tables):
        return tables
    return [Table(tables[0].axes, [sum(values) / len(tables) for values in
                                   zip(*(table.values for table in tables))])]


def at(tables, **where):
    return sum(table.at(**where) for table in tables) / len(tables) if tables else 0.0


class Tables:
    """Of a cell's pins, each asked for once."""

    def __init__(self):
        self.slews, self.powers = {}, {}

    def slew(self, cell, pin, load, slew):
        key = cell.name, pin
        if key not in self.slews:
            self.slews[key] = mean(cell.pins[pin].slews)
        return at(self.slews[key], load=load, slew=slew) or EDGE

    def power(self, cell, pin, load, slew):
        key = cell.name, pin
        if key not in self.powers:
            self.powers[key] = mean(cell.pins[pin].tables)
        return at(self.powers[key], load=load, slew=slew)


@dataclass
class Gate:
    """Of the clock: um2, nW, pF of its enable; pJ of a clock, and besides of one that it lets
    through."""
    name: str
    area: float
    leakage: float
    pin: float
    always: float
    through: float


def clock_gate(library):
    """The library's own, or its latch and its AND; without a latch the size of a flip-flop."""
    cells = library.cells.values()
    own = [cell for cell in cells if cell.gates_clock.startswith("latch_posedge")]
    latches = [cell for cell in cells if cell.other == "latch" and len(cell.inputs) == 2]
    flops = [cell for cell in cells if cell.register]
    ands = [cell for cell in cells if cell.truth == (0, 0, 0, 1)]
    parts = [min(found, key=lambda cell: cell.area) for found in
             ([own] if own else [latches or flops, ands]) if found]
    if not own and len(parts) < 2:
        raise Bad(f"{library.path}: no cell gates a clock, and none is a latch or an AND")
    area = sum(part.area for part in parts)
    if not parts[0].area:
        area += min(cell.area for cell in flops)
    def is_clock(pin):
        return pin.clock or len(parts) == 2 and pin is parts[1].inputs[0]
    pins = [pin for part in parts for pin in part.inputs]
    volts = library.voltage ** 2
    clocks = [pin for pin in pins if is_clock(pin)]
    always = sum(pin.capacitance * volts + 2 * at(mean(pin.tables), load=0.0, slew=EDGE)
                 for pin in clocks)
    return Gate("+".join(part.name for part in parts), area, sum(part.leakage for part in parts),
                next((pin.capacitance for pin in pins if not is_clock(pin)), 0.0), always,
                2 * at(mean(parts[-1].outputs[0].tables), load=0.0, slew=EDGE))


def loads(netlist, macros, enable):
    """pF of each net; enable: of a gate of the clock."""
    found = defaultdict(float)
    for _, cell, nets, _ in netlist.placed:
        for pin in cell.inputs:
            found[nets.get(pin.name, 0)] += pin.capacitance
    for memory in netlist.memories:
        for port in memory.reads + memory.writes:
            pins = port.address + (port.data + port.enable if port in memory.writes
                                   else [port.enable])
            for net in pins:
                found[net] += macros.pin(memory)
    for gate in netlist.gates_of_clock:
        found[gate.enable] += enable
    return found


def characterise(netlist, layout, library, macros):
    gate = clock_gate(library)
    load, tables = loads(netlist, macros, gate.pin), Tables()
    slews, internal = defaultdict(lambda: EDGE), defaultdict(float)
    drives = {}
    for flop in netlist.flops:
        for pin in flop.cell.outputs:
            inverts = pin.function and pin.function.code == flop.cell.register.inverted
            net = flop.inverted if inverts else flop.state
            drives[net] = flop.owner
            slews[net] = tables.slew(flop.cell, pin.name, load[net], EDGE)
            internal[net] += tables.power(flop.cell, pin.name, load[net], EDGE)
    for part in netlist.gates:
        slew = sum(slews[net] for net in part.inputs) / (len(part.inputs) or 1)
        net = part.output
        drives[net] = part.owner
        slews[net] = tables.slew(part.cell, part.pin, load[net], slew)
        internal[net] += tables.power(part.cell, part.pin, load[net], slew)
    for memory in netlist.memories:
        for read in memory.reads:
            drives.update((net, memory.owner) for net in read.data)
    modules = sorted({*netlist.modules.values(), netlist.top})
    number = {module: at for at, module in enumerate(modules)}
    clock, areas, leakage, gated = (defaultdict(float) for _ in range(4))
    for _, cell, nets, owner in netlist.placed:
        module = netlist.owner_module(owner)
        areas[module] += cell.area
        leakage[module] += cell.leakage
        for pin in cell.inputs:
            net = nets.get(pin.name, 0)
            own = tables.power(cell, pin.name, 0.0, slews[net])
            if net == netlist.clock:
                clock[module] += pin.capacitance * library.voltage ** 2 + 2 * own
            elif cell.register and pin.name == cell.register.clock.code:
                gated[net] += pin.capacitance * library.voltage ** 2 + 2 * own
            else:
                internal[net] += own
    through = []
    for at_gate, one in enumerate(netlist.gates_of_clock):
        module = netlist.owner_module(one.owner)
        areas[module] += gate.area
        leakage[module] += gate.leakage
        clock[module] += gate.always
        through.append((gated[netlist.gated_clock(at_gate)] + gate.through, number[module]))
    half = library.voltage ** 2 / 2
    rows = [(0.0, 0.0, -1)] * layout.count
    for net, place in layout.place.items():
        if net in drives:
            rows[place] = (load[net] * half, internal[net],
                           number[netlist.owner_module(drives[net])])
    ports = [(macros.energy(memory), number[netlist.user_module(memory)])
             for memory, _ in layout.reads + layout.writes]
    kinds = {kind: [memory for memory in netlist.memories if memory.kind == kind]
             for kind in ("ram", "file")}
    return {
        "library": library.name, "liberty": library.path, "voltage": library.voltage,
        "power": library.has_power, "nand2": library.nand2.area, "modules": modules,
        "cells": dict(netlist.cells), "areas": areas, "flip_flops": len(netlist.flops),
        "clock": clock, "clock_gates": through, "gate": gate.name, "leakage_nw": leakage,
        "memories": {kind: {"macros": len(found), "bits": sum(m.bits for m in found),
                            "um2": sum(macros.area(m) for m in found)}
                     for kind, found in kinds.items()},
        "macros": macros.path, "scaled": macros.scaled,
        "nets": [[round(a, 7), round(b, 7), c] for a, b, c in rows], "accesses": ports}
