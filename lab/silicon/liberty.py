# liberty.py - reads what a standard-cell library says of its cells: the Liberty format
# SPDX-License-Identifier: Apache-2.0
"""read(path) gives a Library. What is wrong in a file raises Bad, which names file and line. Groups
that nobody here asks for are read past, whatever they hold; those of cells are held to what they
promise: a table has as many values as its axes, a function names pins of its cell."""
import bisect
import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Optional


class Bad(Exception):
    """A library that cannot be read: file, line, why."""


# ---- text ----
TOKEN = re.compile(r"""
    (?P<space> (?: \s | \\\s*\n | /\*.*?\*/ | //[^\n]* )+ )
  | "(?P<text> [^"]* )"
  | (?P<mark> [(){}:;,] )
  | (?P<word> [^\s(){}:;,"\\]+ )
""", re.X | re.S)


@dataclass
class Group:
    """kind (words) { values and groups }. A value is a list of words: those behind a colon, or
    between parentheses."""
    kind: str
    words: list
    line: int
    values: dict = field(default_factory=dict)      # {name: (words, line)}, the last of each name
    groups: list = field(default_factory=list)

    @property
    def name(self):
        return self.words[0] if self.words else ""

    def all(self, *kinds):
        return [group for group in self.groups if group.kind in kinds]


class Reader:
    """The groups of a file."""

    def __init__(self, path):
        self.path = path
        try:
            self.source = Path(path).read_text(encoding="utf-8", errors="replace")
        except OSError as error:
            raise Bad(f"{path}: {error.strerror}") from error
        self.at, self.line = 0, 1
        self.token, self.is_text, self.token_line = "", False, 1
        self.take()

    def bad(self, line, why):
        return Bad(f"{self.path}:{line}: {why}")

    def take(self):
        """The token that was ahead; "" at the end of the file."""
        taken = self.token
        while True:
            self.token_line = self.line
            if self.at >= len(self.source):
                self.token, self.is_text = "", False
                return taken
            match = TOKEN.match(self.source, self.at)
            if not match:
                raise self.bad(self.line, "a text without its second quote"
                               if self.source[self.at] == '"' else
                               f"{self.source[self.at]!r} is of no use here")
            self.at = match.end()
            self.line += match[0].count("\n")
            if match.lastgroup != "space":
                self.token, self.is_text = match[match.lastgroup], match.lastgroup == "text"
                return taken

    def is_mark(self, mark):
        return self.token == mark and not self.is_text

    def need(self, mark, behind):
        if not self.is_mark(mark):
            raise self.bad(self.token_line, f"{mark!r} is missing behind {behind}"
                           + (f", there is {self.token!r}" if self.token else
                              ": the file ends here"))
        self.take()

    def words(self, name):
        """Between parentheses."""
        found = []
        while not self.is_mark(")"):
            if not self.token and not self.is_text:
                raise self.bad(self.token_line, f"{name} ( has no ')': the file ends here")
            if self.token in ("{", "}", ";") and not self.is_text:
                raise self.bad(self.token_line, f"{name} ( has no ')'")
            word = self.take()
            if word != ",":
                found.append(word)
        self.take()
        return found

    def value(self, name):
        """Behind a colon, to the end of its line or a semicolon."""
        found, line = [], self.token_line
        while self.token_line == line and (self.token or self.is_text) \
                and not (self.token in ("}", ";") and not self.is_text):
            found.append(self.take())
        if not found:
            raise self.bad(line, f"{name} has no value")
        return found

    def group(self, kind, words, line):
        """What is between braces; the first is taken already."""
        found = Group(kind, words, line)
        while not self.is_mark("}"):
            if self.is_mark(";"):
                self.take()
                continue
            name, at = self.token, self.token_line
            if not name:
                raise self.bad(at, f"the file ends inside of {kind} "
                               f"{found.name or ''}".rstrip() + f", which began in line {line}")
            if self.is_text or name in "(){}:,":
                raise self.bad(at, f"{name!r} stands where a name should")
            self.take()
            if self.is_mark(":"):
                self.take()
                found.values[name] = self.value(name), at
                continue
            self.need("(", name)
            inside = self.words(name)
            if self.is_mark("{"):
                self.take()
                found.groups.append(self.group(name, inside, at))
            else:
                found.values[name] = inside, at
        self.take()
        return found

    def library(self):
        if self.token != "library":
            raise self.bad(self.token_line, "a library is expected, there is "
                           f"{self.token!r}" if self.token else "the file has no library")
        line = self.token_line
        self.take()
        self.need("(", "library")
        words = self.words("library")
        self.need("{", f"library ({' '.join(words)})")
        return self.group("library", words, line)


# ---- functions ----
SYMBOL = re.compile(r"\s*([A-Za-z_]\w*(?:\[\d+\])?|[01]|[!'^*&+|()])")


class Function:
    """A Boolean function of pins: ! and ' invert, * & or nothing between is and, + | is or, ^ is
    exclusive or. code: C and Python alike, of bits with 1 and 0."""

    def __init__(self, text):
        self.text, self.pins = text, []
        self.symbols, at = [], 0
        while text[at:].strip():
            match = SYMBOL.match(text, at)
            if not match:
                raise ValueError(f"{text[at:].strip()[0]!r} in a function")
            self.symbols.append(match[1])
            at = match.end()
        self.symbols.append("")
        self.code = self.either()
        if self.symbols[0]:
            raise ValueError(f"{self.symbols[0]!r} is too much")

    def either(self):
        code = self.both()
        while self.symbols[0] in ("+", "|"):
            self.symbols.pop(0)
            code = f"({code} | {self.both()})"
        return code

    def both(self):
        code = self.differ()
        while self.symbols[0] in ("*", "&") or self.symbols[0] and self.symbols[0] not in "+|)^'":
            if self.symbols[0] in ("*", "&"):
                self.symbols.pop(0)
            code = f"({code} & {self.differ()})"
        return code

    def differ(self):
        code = self.single()
        while self.symbols[0] == "^":
            self.symbols.pop(0)
            code = f"({code} ^ {self.single()})"
        return code

    def single(self):
        symbol = self.symbols.pop(0)
        if symbol == "!":
            return f"({self.single()} ^ 1)"
        if symbol == "(":
            code = self.either()
            if self.symbols.pop(0) != ")":
                raise ValueError("')' is missing")
        elif symbol and (symbol[0].isalpha() or symbol[0] in "_01"):
            code = symbol
            if symbol not in "01" and symbol not in self.pins:
                self.pins.append(symbol)
        else:
            raise ValueError(f"a pin is missing before {symbol!r}" if symbol else
                             "it ends where a pin should be")
        while self.symbols[0] == "'":
            self.symbols.pop(0)
            code = f"({code} ^ 1)"
        return code

    @cached_property
    def compiled(self):
        return compile(self.code, self.text, "eval")

    def value(self, bits):
        """Of {pin: 0 or 1}."""
        return eval(self.compiled, {"__builtins__": {}}, bits)    # pylint: disable=eval-used


# ---- what is asked of a library ----
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
    power: list                         # of Power
    slews: list                         # of Table: transition times of an output, ns


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

    @property
    def inputs(self):
        return [pin for pin in self.pins.values() if pin.direction == "input"]

    @property
    def outputs(self):
        return [pin for pin in self.pins.values() if pin.direction == "output"]


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
        found = [cell for cell in self.cells.values()
                 if cell.area and is_nand2(cell)]
        return min(found, key=lambda cell: cell.area, default=None)


def is_nand2(cell):
    if cell.register or cell.other or len(cell.outputs) != 1 or not cell.outputs[0].function:
        return False
    of = cell.outputs[0].function
    return len(of.pins) == 2 and [of.value(dict(zip(of.pins, bits))) for bits in
                                  ((0, 0), (0, 1), (1, 0), (1, 1))] == [1, 1, 1, 0]


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
        return Pin(name, direction, self.number(group, "capacitance", 0.0) * self.pf,
                   self.function(group, "function", known) if direction == "output" else None,
                   "three_state" in group.values, [part for part in power if part], slews)

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
                    kinds[0] if kinds else "")

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
