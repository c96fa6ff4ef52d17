# top.py - VERSION, machine.def and top.def as what knows the registers of rt_top
# SPDX-License-Identifier: Apache-2.0
import re
from collections import namedtuple

from .lines import Lines, c_head, told, verilog_head

FROM = "top.def and machine.def"
WORD = (1 << 32) - 1
ONLY = ("LAYERS", "ADDR", "BUILD")       # parameters that registers may depend on
ACCESS = ("ro", "rw", "wo", "w1c")

# offset, reset: as C and SystemRDL have them, 0x...; reset may be "built"
Register = namedtuple("Register", "offset name access reset about fields")
Field = namedtuple("Field", "lsb width name about")


def mask(field):
    return ((1 << field.width) - 1) << field.lsb


def bits(field, at=0):
    """As Verilog has them."""
    return f"{at + field.lsb + field.width - 1}:{at + field.lsb}"


def listed(values):
    return "{" + ", ".join(values) + "}"


class Registers:
    """registers of rt_top in the order of their offsets; machine: {number: name} of those of the
    core, of_machine: the Registers, those of each light among them; counters: {number: (name, what
    it counts)}; place: {MACHINE or COUNTERS: offset}; only: {register: parameter with which alone
    it is there}."""

    def __init__(self, machine, version="VERSION"):
        rows = machine.rows
        self.machine = {int(words[0]): words[1] for kind, words in rows if kind == "reg"}
        self.trees = {name: value for name, value in machine.constants.items()
                      if name.startswith("TREE_")}
        self.errors = [(words[1], " ".join(words[2:])) for kind, words in rows if kind == "error"]
        self.counters = {int(words[0]): (words[1], " ".join(words[3:])) for kind, words in rows
                         if kind == "counter"}
        with open(version, encoding="utf-8") as f:
            major, minor, _ = f.read().strip().split(".")
        self.release = f"0x{int(major):04x}{int(minor):04x}"
        self.registers, self.place, self.only = [], {}, {}
        self.lines = Lines("cmodel/machine/top.def")
        self.lines.each(self.take)
        self.registers_of_machine = max(self.machine) + 1
        self.of_machine = list(self.machine_registers(machine))
        self.counts = max(self.counters) + 1

    def take(self, kind, words, text):
        about = re.sub("^[^:]*: *", "", text)
        if kind == "top":
            self.register(words, about)
        elif kind == "bits":
            self.field(int(words[0]), int(words[1]), words[2], about)
        elif kind == "only":
            if words[0] not in ONLY:
                self.lines.fail(f"only {' or '.join(ONLY)}")
            self.only[self.registers[-1].name] = words[0]
        elif kind == "place":
            self.place[words[1]] = words[0]
        elif kind == "count":
            self.counters[int(words[0])] = words[1], " ".join(words[2:])
        else:
            self.lines.fail(f"none of top, bits, only, place and count: {kind}")

    def number(self, text):
        if not re.fullmatch("0x[0-9a-f]+", text):
            self.lines.fail(f"no number: {text}")
        return int(text, 16)

    def register(self, words, about):
        offset, name, access, reset = words[:4]
        if access not in ACCESS:
            self.lines.fail("access is ro, rw, wo or w1c")
        before = self.number(self.registers[-1].offset) if self.registers else -1
        if self.number(offset) % 4 or self.number(offset) <= before:
            self.lines.fail(f"offset {offset}")
        reset = self.release if reset == "release" else reset
        self.registers.append(Register(offset, name, access, reset, about, []))
        if name == "ERRORS":
            for bit, (error, what) in enumerate(self.errors):
                self.field(bit, 1, error, what)

    def field(self, lsb, width, name, about):
        register = self.registers[-1]
        free = sum(register.fields[-1][:2]) if register.fields else 0
        if lsb + width > 32 or lsb < free:
            self.lines.fail(f"bits of {register.name} overlap")
        register.fields.append(Field(lsb, width, name, about))

    def machine_registers(self, machine):
        """Each keeps all 32 bits; a register without a meaning has that of the one above it."""
        fields, about, name, told_of = {}, {}, None, None
        for kind, words in machine.rows:
            if kind == "reg":
                name, what = words[1], " ".join(words[2:])
                about[name] = what or f"as {told_of}"
                told_of = name if what else told_of
            elif kind == "bits":
                fields.setdefault(name, []).append(
                    Field(int(words[0]), int(words[1]), words[2], " ".join(words[4:])))
        fields["EFFECTS"] = [Field(e.bit, 1, e.name.upper(), e.about) for e in sorted(
            (e for e in machine.effects.values() if e.bit is not None), key=lambda e: e.bit)]
        fields["PROFILE"] = [
            Field(int(lsb), int(width), key.upper(), " ".join(why[why.index(":") + 1:]))
            for kind, (key, lsb, width, *why) in
            (row for row in machine.rows if row[0] == "width")]
        for number, name in sorted(self.machine.items()):
            own = sorted(fields.get(name, [Field(0, 32, "VALUE", about[name])]))
            end = sum(own[-1][:2])
            if end < 32:
                own.append(Field(end, 32 - end, "UNUSED", "kept, without a meaning"))
            lights = machine.constants["MAX_LIGHTS"] if name.startswith("LIGHT0_") else 1
            for light in range(lights):
                at = self.number(self.place["MACHINE"]) + \
                    4 * (number + light * machine.constants["LIGHT_STRIDE"])
                yield Register(f"0x{at:03x}", name.replace("LIGHT0", f"LIGHT{light}"), "rw",
                               "0x00000000", about[name], own)

    # ---- rt_top.vh ----
    def verilog(self):
        lines = [*verilog_head("rt_top.vh", FROM), "`ifndef RT_TOP_VH", "`define RT_TOP_VH"]

        def define(name, value):
            lines.append(f"`define RT_TOP_{name} {value}")
        for r in self.registers:
            define(r.name, f"12'h{r.offset[2:]}")
            if r.reset != "built":
                define(f"{r.name}_RESET", f"32'h{r.reset[2:]}")
            for f in r.fields:
                define(f"{r.name}_{f.name}", f.lsb if f.width == 1 else bits(f))
        settings = [r for r in self.registers if r.access == "rw"]
        for i, r in enumerate(settings):
            define(f"SET_{r.name}", f"{32 * i + 31}:{32 * i}")
            for f in r.fields:
                define(f"SET_{r.name}_{f.name}", bits(f, 32 * i))
        others = [r for r in self.registers if r.access != "rw"]
        settings.reverse()      # from the highest down, as in a concatenation
        others.reverse()
        define("SETTINGS", len(settings))
        define("SETTINGS_RESET", listed(f"32'h{r.reset[2:]}" for r in settings))
        for parameter in ONLY:     # from the highest down, too
            for kind, these in ("SETTINGS", settings), ("OTHERS", others):
                there = "".join(str(int(self.only.get(r.name) == parameter)) for r in these)
                if kind == "SETTINGS" or "1" in there:
                    define(f"{kind}_OF_{parameter}", f"{len(these)}'b{there}")
        define("OTHERS", len(others))
        define("OTHERS_AT", listed(f"12'h{r.offset[2:]}" for r in others))
        define("SETTINGS_KEPT", listed(
            f"32'h{sum(map(mask, r.fields)) if r.fields else WORD:08x}" for r in settings))
        define("SETTINGS_AT", listed(f"12'h{r.offset[2:]}" for r in settings))
        for name in ("MACHINE", "COUNTERS"):
            define(name, f"12'h{self.place[name][2:]}")
        for number, (name, _) in self.counters_of_top():
            define(f"COUNT_{name}", number)
        define("COUNTS", self.counts)
        return told([*lines, "`endif"])

    def counters_of_top(self):
        return [row for row in sorted(self.counters.items()) if row[0] >= 32]

    # ---- sphaera_regs.h ----
    def c(self):
        lines = [*c_head("sphaera_regs.h", FROM), "#ifndef SPHAERA_REGS_H",
                 "#define SPHAERA_REGS_H", ""]

        def define(name, value):
            lines.append(f"#define SPHAERA_{name} {value}")
        for r in self.registers:
            define(r.name, f"{r.offset}u /* {r.access}: {r.about} */")
            if r.reset != "built":
                define(f"{r.name}_RESET", f"{r.reset}u")
            for f in r.fields:
                define(f"{r.name}_{f.name}_LSB", f"{f.lsb}u")
                define(f"{r.name}_{f.name}", f"0x{mask(f):08x}u /* {f.about} */")
        lines.append("")
        define("MACHINE", f"{self.place['MACHINE']}u")
        define("MACHINE_REGISTERS", f"{self.registers_of_machine}u")
        define("COUNTERS", f"{self.place['COUNTERS']}u")
        define("COUNTS", f"{self.counts}u")
        lines.append("")
        for number, name in sorted(self.machine.items()):
            define(f"REG_{name}", f"{number}u")
        lines.append("")
        for name, value in self.trees.items():
            define(name, f"{value}u")
        lines.append("")
        for number, (name, _) in sorted(self.counters.items()):
            define(f"COUNT_{name}", f"{number}u")
        each = "".join(f' \\\n    X(SPHAERA_ERRORS_{f.name}, "{f.about}")'
                       for r in self.registers if r.name == "ERRORS" for f in r.fields)
        return told([*lines, "", "/* X(bit of ERRORS, what it says) */",
                     f"#define SPHAERA_EACH_ERROR(X){each}", "", "#endif"])

    # ---- SystemRDL ----
    def rows(self):
        """(name, offset, access, what it is, [(Field, value after reset or None)]) of all that the
        bus sees, by offset."""
        for r in self.registers:
            value = None if r.reset == "built" else self.number(r.reset)
            fields = r.fields or [Field(0, 32, "VALUE", r.about)]
            yield r.name, r.offset, r.access, r.about, \
                [(f, None if value is None else (value & mask(f)) >> f.lsb) for f in fields]
        for r in sorted(self.of_machine):
            yield f"M_{r.name}", r.offset, "rw", r.about, [(f, 0) for f in r.fields]
        for number, (name, about) in sorted(self.counters.items()):
            for i, (half, width) in enumerate((("LOW", 32), ("HIGH", 16))):
                at = self.number(self.place["COUNTERS"]) + 8 * number + 4 * i
                yield f"C_{name}_{half}", f"0x{at:03x}", "ro", about, \
                    [(Field(0, width, "VALUE", about), None)]

    def rdl(self):
        lines = [*verilog_head("rt_top.rdl", FROM), "addrmap rt_top {", '    name = "rt_top";',
                 "    default regwidth = 32;", "    default accesswidth = 32;",
                 "    addressing = compact;"]
        for name, offset, access, about, fields in self.rows():
            sw = {"ro": "r", "wo": "w"}.get(access, "rw")
            more = {"w1c": " onwrite = woclr;", "wo": " singlepulse;"}.get(access, "")
            hw = "w" if sw == "r" else "rw" if access == "w1c" else "r"
            lines += ["    reg {", f'        desc = "{about}";']
            for f, value in fields:
                reset = "" if value is None else f" = 0x{value:x}"
                lines.append(f'        field {{ desc = "{f.about}"; sw = {sw}; hw = {hw};{more} }} '
                             f"{f.name}[{bits(f)}]{reset};")
            lines.append(f"    }} {name} @ {offset};")
        return told([*lines, "};"])

    # ---- the table of the page ----
    def table(self):
        lines = ["| offset | register | access | reset | bits | |", "|---|---|---|---|---|---|"]
        for r in self.registers:
            lines.append(f"| {r.offset} | `{r.name}` | {r.access} | {r.reset} | | {r.about} |")
            lines += [f"| | `{f.name}` | | | "
                      f"{f'{f.lsb + f.width - 1}..' if f.width > 1 else ''}{f.lsb} | {f.about} |"
                      for f in r.fields]
        lines += [f"| {self.place['MACHINE']} + 4n | machine register n | rw | 0 | | "
                  f"n = 0..{self.registers_of_machine - 1} of [core.md](core.md#registers) |",
                  f"| {self.place['COUNTERS']} + 8n | counter n, low word | ro | | | of the last "
                  "SNAPSHOT; 0..31: [core.md](core.md#counters) |",
                  "| + 4 | its high 16 bits | ro | | | |"]
        lines += [f"| | counter {number} `{name}` | | | | {about} |"
                  for number, (name, about) in self.counters_of_top()]
        return "\n".join(lines)
