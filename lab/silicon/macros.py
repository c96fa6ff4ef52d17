# macros.py - memories as macros: what a table says of their area, energy and time
# SPDX-License-Identifier: Apache-2.0
"""read(path, library) gives Macros of a table such as macros.tsv, scaled to a library if that is
not the one that the table is for. What is wrong in it raises Bad, with file and line."""
from dataclasses import dataclass
from pathlib import Path

from .liberty import Bad

DEFAULT = "lab/silicon/macros.tsv"
HEAD = "kind um2 um2_bit pj_bit pj_bit_word ns ns_word pin_pf".split()
KINDS = "ram", "file"
FANOUT = 4          # of the gate whose transition tells how fast a library is
NEAR = 0.02         # a library whose NAND2 is that near is the one that the table is for


@dataclass
class Macros:
    """Of a memory, in the units that macros.tsv names. scaled: factors of area, energy, time."""
    path: str
    rows: dict
    scaled: tuple

    def of(self, memory, what, per):
        return self.rows[memory.kind][what] + self.rows[memory.kind][f"{what}_{per}"] * (
            memory.bits if per == "bit" else memory.size)

    def area(self, memory):
        """um2"""
        return self.of(memory, "um2", "bit") * self.scaled[0]

    def energy(self, memory):
        """pJ of an access by a port."""
        row = self.rows[memory.kind]
        return memory.width * (row["pj_bit"] + row["pj_bit_word"] * memory.size) * self.scaled[1]

    def time(self, memory):
        """ns"""
        return self.of(memory, "ns", "word") * self.scaled[2]

    def pin(self, memory):
        """pF"""
        return self.rows[memory.kind]["pin_pf"] * self.scaled[1]


def gauge(library):
    """um2, pJ and ns of the library's NAND2."""
    cell = library.nand2
    if not cell:
        raise Bad(f"{library.path}: no cell is !(A B): gates cannot be counted in it")
    pin = cell.inputs[0]
    slews = [table.at(load=FANOUT * pin.capacitance, slew=0) for table in cell.outputs[0].slews]
    return (cell.area, pin.capacitance * library.voltage ** 2,
            sum(slews) / len(slews) if slews else 0.0)


def numbers(path, line, words):
    try:
        return [float(word) for word in words]
    except ValueError as error:
        raise Bad(f"{path}:{line}: {error}") from None


def read(path, library):
    try:
        lines = Path(path).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise Bad(f"{path}: {error}") from error
    rows, reference, head = {}, None, None
    for line, text in enumerate(lines, 1):
        words = text.split()
        if not words or text.startswith("#"):
            continue
        if words[0] == "reference":
            reference = numbers(path, line, words[1:])
            if len(reference) != 3 or min(reference) <= 0:
                raise Bad(f"{path}:{line}: reference is um2, pJ and ns of a NAND2, above 0")
        elif words[0] == "kind":
            head = words
            if head != HEAD:
                raise Bad(f"{path}:{line}: columns are not {' '.join(HEAD)}")
        elif words[0] not in KINDS:
            raise Bad(f"{path}:{line}: {words[0]!r} is none of {', '.join(KINDS)}")
        elif len(words) != len(HEAD):
            raise Bad(f"{path}:{line}: {len(words)} columns, not {len(HEAD)}")
        else:
            rows[words[0]] = dict(zip(HEAD[1:], numbers(path, line, words[1:])))
    missing = [kind for kind in KINDS if kind not in rows] + ["reference"] * (not reference)
    if missing:
        raise Bad(f"{path}: there is no line {missing[0]}")
    own = gauge(library)
    scaled = tuple(a / b if a else 1.0 for a, b in zip(own, reference))
    if all(abs(factor - 1) < NEAR for factor in scaled):
        scaled = 1.0, 1.0, 1.0
    return Macros(str(path), rows, scaled)
