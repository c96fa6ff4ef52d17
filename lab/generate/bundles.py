# bundles.py - bundles.def as a Verilog header and a C++ header
# SPDX-License-Identifier: Apache-2.0
import re

from .lines import Lines, c_head, told, verilog_head

FROM = "bundles.def"


class Width:
    """A sum of widths: numbers and equal terms are added up."""

    def __init__(self):
        self.number, self.terms = 0, {}

    def add(self, width):
        if width.isdecimal():
            self.number += int(width)
        else:
            self.terms[width] = self.terms.get(width, 0) + 1

    def __str__(self):
        def product(count, word):
            return word if count == 1 else f"{count}*({word})" if "+" in word else f"{count}*{word}"
        terms = [product(count, word) for word, count in self.terms.items()]
        return "+".join(terms + [str(self.number)] * bool(self.number or not terms))


class Bundles:
    """fields: {bundle: {FIELD: width as it stands}}; events: {bundle: [(FIELD, bits, COUNTER,
    parameter with which it is counted, or "")]}."""

    def __init__(self, machine):
        self.counters = {words[1]: int(words[0]) for kind, words in machine.rows
                         if kind == "counter"}
        self.registers = {words[1] for kind, words in machine.rows if kind == "reg"}
        self.held = {}      # {bundle: [(FIELD, register, how many, parameter or "1")]}
        self.fields, self.events, self.lines = {}, {}, Lines("rtl/engine/bundles.def")
        self.lines.each(self.take)

    def take(self, kind, words, _):
        if kind not in ("bundle", "field"):
            self.lines.fail(f"neither bundle nor field: {kind}")
        if kind == "field" and not self.fields:
            self.lines.fail("a field before its bundle")
        if words[0] in (self.fields if kind == "bundle" else next(reversed(self.fields.values()))):
            self.lines.fail(f"twice: {words[0]}")
        if kind == "bundle":
            self.fields[words[0]], self.events[words[0]] = {}, []
        else:
            self.field(next(reversed(self.fields)), words)

    def field(self, bundle, words):
        name, width, *more = words
        if width not in self.fields and not re.fullmatch("[0-9A-Z_+*()]+", width):
            self.lines.fail(f"no width: {width}")
        self.fields[bundle][name] = width
        held = re.match(r"register (\w+)(?: x (\d+))?(?: if (\w+))?\b", " ".join(more))
        if held:
            if held[1] not in self.registers:
                self.lines.fail(f"no register of machine.def: {held[1]}")
            self.held.setdefault(bundle, []).append((name, held[1], held[2] or 1, held[3] or 1))
        if more[:1] == ["counter"]:    # NAME [if PARAMETER]
            counter, *when = [word.removesuffix(":") for word in more[1:4]]
            if counter not in self.counters:
                self.lines.fail(f"no counter of machine.def: {counter}")
            self.events[bundle].append(
                (name, int(width), counter, when[1] if when[:1] == ["if"] else ""))

    def expression(self, width, lang):
        """Of a width; a bundle's name stands for its bits."""
        if width in self.fields:
            return ("`" if lang == "v" else "") + f"RT_{width.upper()}_BITS"
        width = re.sub("([A-Z]+_BITS)", r"`RT_\1" if lang == "v" else r"SPH_\1", width)
        return width.replace("SLOTW", "$clog2(SLOTS)") if lang == "v" else width

    def registers_of(self, bundle):
        """Lines that hold its registers and make its fields of them; those of a parameter that is 0
        are 0."""
        names, whens, reads, drives = [], [], [], []
        for field, register, count, when in self.held[bundle]:
            name, width = field.lower() + "_q", self.fields[bundle][field]
            count, bits = int(count), self.expression(width, "v")
            one = str(int(width) // count) if width.isdecimal() else bits.removeprefix(f"{count}*")
            names.append(f"    reg  [{self.top(bits)}:0] {name};")
            for i in range(count):
                at = f"`RT_REG_{register}" + f" + 7'd{i}" * bool(i)
                into = f"{name}[{i}*{one} +: {one}]" if count > 1 else name
                reads.append(f"            if (addr_i == {at}) {into} <= "
                             f"data_i[{self.top(one)}:0];")
            value = name if when == 1 else f"{when} != 0 ? {name} : {{{bits}{{1'b0}}}}"
            drives.append(f"    assign {bundle}_o[`RT_{bundle.upper()}_{field}] = {value};")
        return [*names, "    always @(posedge clk)", "        if (valid_i) begin", *reads,
                "        end", *drives]

    def top(self, bits):
        """The number of the highest one."""
        return str(int(bits) - 1) if bits.isdecimal() else f"{bits}-1"

    def filled(self, text):
        """The text of a module, anew between the lines that begin and end its registers."""
        return re.sub(r"(?<=\n)(    // registers of bundle (\w+): made by make layout\n).*?"
                      r"(?=    // end of those\n)",
                      lambda found: told([found[1][:-1], *self.registers_of(found[2])]), text,
                      flags=re.S)

    def adds(self, bundle):
        """Statements that add its events, as rt_core sums up."""
        for field, bits, counter, when in self.events[bundle]:
            at = f"add_e[8*`RT_COUNT_{counter} +: 8]"
            yield (f" \\\n    {f'if ({when} != 0) ' if when else ''}{at} = {at} + {{{8 - bits}'d0, "
                   f"{bundle.partition('_')[0]}[`RT_{bundle.upper()}_{field}]}};")

    def counters_used(self):
        """How many counters, from 0 on, a core has: up to the last one that it counts."""
        only = {self.counters[name]: when for events in self.events.values()
                for _, _, name, when in events}
        always = max(n for n in self.counters.values() if not only.get(n)) + 1
        text = str(always)
        for n in range(always, max(self.counters.values()) + 1):
            if only[n] != only.get(n + 1):
                text = f"{only[n]} != 0 ? {n + 1} : {text}"
        return f"({text})"

    def defines(self, lang):
        """(name, value)"""
        for bundle, fields in self.fields.items():
            width = Width()
            for field, own in fields.items():
                own = self.expression(own, lang)
                yield f"{bundle.upper()}_{field}", \
                    f"{width} +: {own}" if lang == "v" else f"({width}), ({own})"
                width.add(own)
            yield f"{bundle.upper()}_BITS", f"({width})"
            if lang == "c" and bundle in self.held:
                yield f"{bundle.upper()}_EACH(X)", "".join(
                    f" \\\n    X({', '.join(map(str, row))})" for row in self.held[bundle])
            if lang == "v" and self.events[bundle]:
                yield f"{bundle.upper()}_ADDS", "".join(self.adds(bundle))
        if lang == "v":
            yield "COUNTERS_USED", self.counters_used()

    def text(self, lang):
        if lang == "v":
            head = verilog_head(
                "rt_bundles.vh", FROM,
                "bus[`RT_RAY_ORG] is field ORG of a bus of `RT_RAY_BITS bits, a bundle ray")
            head += ["`ifndef RT_BUNDLES_VH", "`define RT_BUNDLES_VH", '`include "rt_layout.vh"']
        else:
            head = c_head("bundles.h", FROM, "The arguments low bit, bits of bench::put() and "
                          "bench::get() for each field;",
                          "X(field, register, how many, with what they are built) of registers.")
            head += ["#ifndef SPH_BUNDLES_H", "#define SPH_BUNDLES_H",
                     '#include "machine/layout.h"']
        mark = "`" if lang == "v" else "#"
        return told([*head, *(f"{mark}define RT_{name} {value}"
                              for name, value in self.defines(lang)), mark + "endif"])
