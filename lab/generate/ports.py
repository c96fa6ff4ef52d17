# ports.py - what modules show and hold of bundles: fields beside ports, behind //:, and registers
# SPDX-License-Identifier: Apache-2.0
"""As in a concatenation: the highest bits first, behind a name its bits if they are more than one.
A bundle's fields stand once in a list of ports, below the first ports that have it. Registers that
it holds stand between two comments."""
import glob
import itertools
import re

PORT = re.compile(r"    (?:input|output) .*`RT_([A-Z_]+)_BITS")
BEGINS = re.compile(r"module .*[^#] ?\($|\) \($")


class Fields:
    """Of each bundle, NAME: the lines that stand below its port."""

    def __init__(self, machine, bundles):
        self.constants = machine.constants
        self.lines = {name.upper(): self.lines_of(fields)
                      for name, fields in bundles.fields.items()}

    def word(self, name, width):
        found = re.search("[A-Z]+_BITS", width)
        if found and found[0] in self.constants:
            width = width.replace(found[0], str(self.constants[found[0]]), 1)
        product = re.fullmatch(r"([0-9]+)\*([0-9]+)", width)
        width = str(int(product[1]) * int(product[2])) if product else width
        return name if width == "1" else f"{name}[{width}]"

    def lines_of(self, fields):
        words = [self.word(*row) for row in reversed(fields.items())]
        line, lines = "    //: {", []
        for i, word in enumerate(words, 1):
            word += "}" if i == len(words) else ","
            if len(line + word) > 99:
                lines.append(line)
                line = "    //: "
            line += ("" if line[-1] in "{ " else " ") + word
        return lines + [line]

    def anew(self, text):
        made, in_ports, there, waits = [], False, set(), None
        for line in text.split("\n"):
            if re.match(" *//: ", line):
                continue
            port = in_ports and PORT.match(line)
            bundle = port[1] if port and port[1] in self.lines else None
            if waits != bundle:
                made += self.lines.get(waits, ())
                waits = None
            if BEGINS.match(line):
                in_ports, there = True, set()
            elif line.startswith(");"):
                in_ports = False
            if bundle and bundle not in there:
                waits = bundle
                there.add(bundle)
            made.append(line)
        return "\n".join(made)


def modules(machine, bundles):
    """(file, its text, the text as it has to be) of those with such ports."""
    fields = Fields(machine, bundles)
    for name in sorted(glob.glob("rtl/*/*.v")):
        with open(name, encoding="utf-8") as f:
            text = f.read()
        if any(map(PORT.match, text.split("\n"))):
            yield name, text, fields.anew(bundles.filled(text))


def anew(machine, bundles):
    """(file, its text)"""
    return ((name, made) for name, _, made in modules(machine, bundles))


def wrong(machine, bundles):
    """FILE:LINE of the first line that is not so, of each file."""
    for name, text, made in modules(machine, bundles):
        pairs = itertools.zip_longest(text.split("\n"), made.split("\n"), fillvalue="nothing")
        for number, (is_there, wanted) in enumerate(pairs, 1):
            if is_there != wanted:
                yield f"{name}:{number}: not as make layout has it: {wanted}"
                break
