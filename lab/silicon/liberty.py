# liberty.py - what a standard-cell library says of its cells
# SPDX-License-Identifier: Apache-2.0
"""read(path) gives a Library. What is wrong in the file raises Bad, which names file and line.
Groups that nobody here asks for are read past, whatever they hold; those of cells are held to what
they promise: a table has as many values as its axes, a function names pins of its cell."""
import bisect
import re
from dataclasses import dataclass
from functools import cached_property
from typing import Optional

from .function import Function
from .liberty_text import Bad, Reader

__all__ = ["Bad", "read"]


@dataclass
class Table:
    """Values over up to two axes; between their points straight, beyond them as at their ends."""
    axes: list          # of (what, points): what is load (pF), slew (ns), or another word
    values: list

    def at(self, **where):
        """At load and slew; of an axis that is not given the first point."""
        parts = [(0, 1.0)]
        for what, points in self.axes:
            x = min(max(where.get(what, points[0]), points[0]), points[-1])
            low = max(0, min(bisect.bisect_right(points, x) - 1, len(points) - 2))
            share = (x - points[low]) / (points[low + 1] - points[low]) if len(points) > 1 else 0.0
            parts = [(index * len(points) + low + step, weight * part)
                     for index, weight in parts
                     for step, part in ((0, 1 - share), (1, share)) if part]
        return sum(self.values[index] * weight for index, weight in parts)


@dataclass
class Power:
    """internal_power: pJ of an edge of the pin, up and down."""
    related: str
    rise: Table
    fall: Table

    def energy(self, load, slew):
        """pJ, mean of both edges."""
        return (self.rise.at(load=load, slew=slew) + self.fall.at(load=load, slew=slew)) / 2


@dataclass
class Pin:
    name: str
    direction: str
    capacitance: float                  # pF
    function: Optional[Function]
    three_state: bool
    clock: bool
    power: list                         # of Power
    slews: list                         # of Table: transition times of an output, ns

    @property
    def tables(self):
        """Of all its power, both edges."""
        return [table for power in self.power for table in (power.rise, power.fall)]


@dataclass
class Register:
    """The ff of a cell: its state and that inverted, by the names that functions have."""
    state: str
    inverted: str
    next_state: Function
    clock: Function
    asynchronous: list                  # functions that set or clear it whatever the clock does


@dataclass
class Cell:
    name: str
    area: float                         # um2
    leakage: float                      # nW
    pins: dict
    register: Optional[Register]
    other: str                          # latch, statetable: what has no model here; or empty
    gates_clock: str                    # clock_gating_integrated_cell, such as latch_posedge

    @property
    def inputs(self):
        return [pin for pin in self.pins.values() if pin.direction == "input"]

    @property
    def outputs(self):
        return [pin for pin in self.pins.values() if pin.direction == "output"]

    @cached_property
    def truth(self):
        """Of a function of two pins, its value for 00, 01, 10, 11; of another cell nothing."""
        out = self.outputs
        if self.register or self.other or len(out) != 1 or not out[0].function \
                or len(out[0].function.pins) != 2:
            return ()
        of = out[0].function
        return tuple(of.value(dict(zip(of.pins, (a, b)))) for a in (0, 1) for b in (0, 1))


@dataclass
class Library:
    path: str
    name: str
    voltage: float                      # V
    cells: dict

    @cached_property
    def has_power(self):
        return any(pin.power for cell in self.cells.values() for pin in cell.pins.values())

    @cached_property
    def nand2(self):
        """The smallest cell that is !(A B): what gate equivalents are counted in; None: none."""
        found = [cell for cell in self.cells.values() if cell.area and cell.truth == (1, 1, 1, 0)]
        return min(found, key=lambda cell: cell.area, default=None)


SI = {"f": 1e-15, "p": 1e-12, "n": 1e-9, "u": 1e-6, "m": 1e-3, "": 1.0}
AXES = {"total_output_net_capacitance": "load", "input_net_transition": "slew",
        "input_transition_time": "slew"}


class Meaning:
    """From groups to a Library: units, templates, checks."""

    def __init__(self, reader):
        self.reader, self.group = reader, reader.library()
        self.pf = self.capacity() / 1e-12
        self.ns = self.unit("time_unit", "s", 1e-9) / 1e-9
        self.nw = self.unit("leakage_power_unit", "W", 1e-9) / 1e-9
        self.volt = self.unit("voltage_unit", "V", 1.0)
        self.pj = self.pf * self.volt ** 2          # as the format defines it
        self.templates = {group.name: group for group in
                          self.group.all("lu_table_template", "power_lut_template")}

    def bad(self, line, why):
        return self.reader.bad(line, why)

    def number(self, group, name, default=None):
        if name not in group.values:
            if default is None:
                raise self.bad(group.line, f"{group.kind} {group.name} has no {name}")
            return default
        words, line = group.values[name]
        try:
            return float(words[0])
        except ValueError:
            raise self.bad(line, f"{name} is {words[0]!r}, no number") from None

    def unit(self, name, letter, otherwise):
        if name not in self.group.values:
            return otherwise
        words, line = self.group.values[name]
        match = re.fullmatch(rf"([\d.]+)\s*([fpnum]?){letter}", "".join(words), re.I)
        if not match:
            raise self.bad(line, f"{name} is {''.join(words)!r}, not such as 1n{letter}")
        return float(match[1]) * SI[match[2].lower()]

    def capacity(self):
        name = "capacitive_load_unit"
        if name not in self.group.values:
            return 1e-12
        words, line = self.group.values[name]
        try:
            return float(words[0]) * SI[words[1].lower().removesuffix("f")]
        except (ValueError, KeyError, IndexError):
            raise self.bad(line, f"{name} is ({', '.join(words)}), not such as (1, pf)") from None

    def floats(self, words, name, line):
        text = " ".join(words).replace(",", " ").replace("\\", " ")
        try:
            return [float(word) for word in text.split()]
        except ValueError as error:
            raise self.bad(line, f"{name}: {str(error).rsplit(':', maxsplit=1)[-1].strip()} is no "
                           "number") from None

    def table(self, group, scale):
        """Of a group with values; its axes are its own, or those of its template."""
        template = self.templates.get(group.name)
        if not template and group.name != "scalar":
            raise self.bad(group.line, f"{group.kind}: there is no template {group.name!r}")
        axes = []
        for number in "12" if template else "":
            if f"variable_{number}" not in template.values:
                break
            what = template.values[f"variable_{number}"][0][0]
            words, line = group.values.get(f"index_{number}") or \
                template.values.get(f"index_{number}") or (None, group.line)
            if words is None:
                raise self.bad(line, f"{group.kind} has no index_{number}")
            points = self.floats(words, f"index_{number}", line)
            if not points or any(b <= a for a, b in zip(points, points[1:])):
                raise self.bad(line, f"index_{number} does not rise")
            unit = {"load": self.pf, "slew": self.ns}.get(AXES.get(what), 1.0)
            axes.append((AXES.get(what, what), [point * unit for point in points]))
        if "values" not in group.values:
            raise self.bad(group.line, f"{group.kind} has no values")
        words, line = group.values["values"]
        values = self.floats(words, "values", line)
        want = 1
        for _, points in axes:
            want *= len(points)
        if len(values) != want:
            raise self.bad(line, f"{len(values)} values, the axes of {group.kind} have {want}")
        return Table(axes, [value * scale for value in values])

    def power(self, group):
        tables = {part.kind: self.table(part, self.pj)
                  for part in group.all("rise_power", "fall_power", "power")}
        if not tables:
            return None
        some = next(iter(tables.values()))
        none = Table([], [0.0])
        both = tables.get("power")
        related = group.values.get("related_pin", ([""], 0))[0][0]
        return Power(related, both or tables.get("rise_power", none if "fall_power" in tables
                                                 else some),
                     both or tables.get("fall_power", none))

    def function(self, group, name, known):
        if name not in group.values:
            return None
        words, line = group.values[name]
        try:
            found = Function(" ".join(words))
        except ValueError as error:
            raise self.bad(line, f"{name} {' '.join(words)!r}: {error}") from None
        for pin in found.pins:
            if pin not in known:
                raise self.bad(line, f"{name} {found.text!r}: the cell has no pin {pin}")
        return found

    def pin(self, group, known):
        name = group.name
        if "direction" not in group.values:
            raise self.bad(group.line, f"pin {name} has no direction")
        slews = [self.table(part, self.ns) for timing in group.all("timing")
                 for part in timing.all("rise_transition", "fall_transition")]
        power = [self.power(part) for part in group.all("internal_power")]
        direction = group.values["direction"][0][0]
        clock = group.values.get("clock", (["false"], 0))[0][0] == "true"
        return Pin(name, direction, self.number(group, "capacitance", 0.0) * self.pf,
                   self.function(group, "function", known) if direction == "output" else None,
                   "three_state" in group.values, clock, [part for part in power if part], slews)

    def cell(self, group):
        pins = group.all("pin")
        flops = group.all("ff")
        names = {pin.name for pin in pins} | {word for flop in flops for word in flop.words}
        other = group.all("latch", "statetable", "ff_bank", "latch_bank")
        names |= {word for part in other for word in part.words}
        register = None
        if len(flops) == 1 and not other:
            flop = flops[0]
            if len(flop.words) != 2:
                raise self.bad(flop.line, "ff names no two states")
            of = {name: self.function(flop, name, names)
                  for name in ("next_state", "clocked_on", "clear", "preset")}
            for name in ("next_state", "clocked_on"):
                if not of[name]:
                    raise self.bad(flop.line, f"ff has no {name}")
            register = Register(*flop.words, of["next_state"], of["clocked_on"],
                                [of[name] for name in ("clear", "preset") if of[name]])
        kinds = [part.kind for part in other] + (["two ff"] if len(flops) > 1 else [])
        return Cell(group.name, self.number(group, "area", 0.0),
                    self.number(group, "cell_leakage_power", 0.0) * self.nw,
                    {pin.name: self.pin(pin, names) for pin in pins}, register,
                    kinds[0] if kinds else "",
                    group.values.get("clock_gating_integrated_cell", ([""], 0))[0][0])

    def library(self):
        cells = {}
        for group in self.group.all("cell"):
            if not group.name:
                raise self.bad(group.line, "a cell without a name")
            if group.name in cells:
                raise self.bad(group.line, f"there is a second cell {group.name}")
            cells[group.name] = self.cell(group)
        if not cells:
            raise self.bad(self.group.line, f"library {self.group.name} has no cell")
        voltage = self.number(self.group, "nom_voltage", 0.0) * self.volt
        if voltage <= 0 and any(pin.power for cell in cells.values()
                                for pin in cell.pins.values()):
            raise self.bad(self.group.line, "library has no nom_voltage, which energy needs")
        return Library(str(self.reader.path), self.group.name, voltage, cells)


def read(path):
    return Meaning(Reader(path)).library()
