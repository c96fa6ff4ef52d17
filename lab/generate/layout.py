# layout.py - machine.def as a C header and Verilog headers
# SPDX-License-Identifier: Apache-2.0
"""layout: layout of memory, registers, numbers. What rt_core, what is around it and modules in it
have in common: effects, a parameter for each width and effect; core_parameters, the others too;
effects_pass and core_pass, what is given to parameters of the same name; core_rules, how many units
there are and what is legal."""
from .lines import c_head, told, verilog_head

FROM = "machine.def"


def counted(when):
    """Registers WHEN and COUNT of `COUNT, WHEN=value or WHEN=value:COUNT`, the value's ends."""
    register, equals, value = when.partition("=")
    if not equals:
        return "-1", "0", "0", f"SPH_REG_{register}" if register else "-1"
    value, _, count = value.partition(":")
    least, _, most = value.partition("..")
    return f"SPH_REG_{register}", least, most or least, f"SPH_REG_{count}" if count else "-1"


def entries(machine, effects):
    """X(NAME, word, ...) of SPH_EACH_EFFECT or SPH_EACH_PART."""
    place = {name: 1 << i for i, name in enumerate(machine.effects)}
    for e in effects:
        needs, excludes = (sum(place[word] for word in words) for words in (e.needs, e.excludes))
        when, least, most, count = counted(e.asked)
        bit = -1 if e.bit is None else e.bit
        yield (f" \\\n    X({e.name.upper()}, {e.name}, \"{e.core}\", {bit}, {e.most}, {e.all}, "
               f"SPH_OPTION_{e.option.upper()}, {needs}, {excludes}, {when}, {least}, {most}, "
               f"{count}, \"{e.about}\")")


def of_x(rows):
    """The macro that calls X with the words of each row."""
    return "".join(f" \\\n    X({', '.join(row)})" for row in rows)


class Layout:
    """defines: (name, value), in the order of the file; of_c, of_verilog: those of one language."""

    def __init__(self, machine):
        self.machine, self.defines, self.of_verilog = machine, [], set()
        self.rows = {kind: [] for kind in ("profile", "width", "kind", "reg", "counter", "error")}
        for kind, words in machine.rows:
            if kind in self.rows:
                self.rows[kind].append(words)
            for name, value in getattr(self, kind, lambda words: ())(words):
                self.defines.append((name, value))
        self.effects = list(machine.effects.values())
        built = [e for e in self.effects if e.bit is not None]
        self.mask = sum(1 << e.bit for e in built)
        self.built = "".join(f" | ({e.core} != 0 ? 32'd1 << {e.bit} : 32'd0)" for e in built)
        self.defines += [(f"EFFECT_{e.name.upper()}", e.bit) for e in built]
        rows = self.rows
        self.defines += [
            ("EFFECT_BITS", machine.bits), ("KINDS", len(rows["kind"])),
            ("KINDS_UNBOUNDED", sum(1 << int(number) for number, _, *more in rows["kind"]
                                    if more == ["unbounded"])),
            ("COUNTERS", len(rows["counter"])),
            ("COUNTERS_BOTH", sum(1 << int(number) for number, _, by, *_ in rows["counter"]
                                  if by == "both")),
            ("ERRORS", len(rows["error"]))]

    # ---- definitions of a line, by its first word ----
    def profile(self, words):
        names = [f"PROFILE_{words[0].upper()}_{key}" for key in ("W", "WD", "PQ", "NG", "FW", "PR")]
        self.of_verilog.update(names)
        return zip(names, words[1:])

    def width(self, words):
        name = f"WIDTH_{words[0].upper()}_LSB"
        self.of_verilog.add(name)
        return [(name, words[1])]

    @staticmethod
    def const(words):
        return [words[:2]]

    @staticmethod
    def kind(words):
        return [(words[1].upper(), words[0])]

    @staticmethod
    def field(words):
        word, name, lsb, bits = words[:4]
        name = f"{word}_{name}".upper()
        return [(name, bits)] if name.endswith("_STRIDE") else \
            [(f"{name}_LSB", lsb), (f"{name}_BITS", bits)]

    @staticmethod
    def reg(words):
        return [(f"REG_{words[1]}", words[0])]

    @staticmethod
    def counter(words):
        return [(f"COUNT_{words[1]}", words[0])]

    @staticmethod
    def error(words):
        return [(f"ERROR_{words[1]}", words[0])]

    # ---- as text ----
    def tables(self):
        """Of C: lists as initialisers, and as macros that call X for each entry."""
        rows = self.rows

        def names(kind):
            return ", ".join(f'"{name.lower()}"' for _, name, *_ in rows[kind])

        def each(kind):
            return "".join(f" \\\n    X({name})" for _, name, *_ in rows[kind])
        yield "PROFILE_TABLE", ", ".join(f'{{"{name}", {", ".join(numbers[:6])}}}'
                                         for name, *numbers in rows["profile"])
        yield "WIDTH_TABLE", ", ".join(
            f'{{"{key}", offsetof(struct sph_profile, {key}), {", ".join(numbers)}, '
            f'"{" ".join(why[:why.index(":")])}"}}'
            for key, *numbers, why in ((*row[:5], row[5:]) for row in rows["width"]))
        yield "COUNTER_NAMES", names("counter")
        yield "ERROR_NAMES", names("error")
        yield "EFFECT_MASK", self.mask
        whole = self.effects
        yield "EACH_EFFECT(X)", "".join(entries(self.machine, [e for e in whole if not e.is_part]))
        yield "EACH_PART(X)", "SPH_EACH_EFFECT(X)" + "".join(
            entries(self.machine, [e for e in whole if e.is_part]))
        yield "EACH_REG(X)", each("reg")
        yield "EACH_KIND(X)", each("kind")
        yield "EACH_COUNTER(X)", of_x((name.upper(), name.lower())
                                      for _, name, *_ in rows["counter"])
        yield "EACH_SIZE(X)", of_x((size.name, size.standard)
                                   for size in self.machine.sizes.values())
        yield "EACH_PACE(X)", of_x((profile.upper(), *word.split("="))
                                   for profile, words in self.machine.paces.items()
                                   for word in words)
        for kind, rules in (("UNIT_COUNT", self.machine.units), ("RATE", self.machine.rates)):
            yield f"EACH_{kind}(X)", of_x((name, f"({rule})") for name, rule in rules.items())
        yield "EACH_LOAD(X)", of_x((name.replace(" ", "_"), f'"{name}"', *of)
                                   for name, of in self.machine.loads.items())

    def c(self):
        shared = [row for row in self.defines if row[0] not in self.of_verilog]
        return told([*c_head("layout.h", FROM), "#ifndef SPH_LAYOUT_H", "#define SPH_LAYOUT_H", "",
                     *(f"#define SPH_{name} {value}" for name, value in (*shared, *self.tables())),
                     "", "#endif"])

    def verilog(self):
        return told([
            *verilog_head("rt_layout.vh", FROM), "`ifndef RT_LAYOUT_VH", "`define RT_LAYOUT_VH",
            *(f"`define RT_{name} {value}" for name, value in self.defines),
            f"`define RT_EFFECTS_BUILT (32'd0{self.built})",
            "`define RT_DEEPEST (REFRACT != 0 && REFLECT < `RT_REFRACT_DEPTH ? "
            "`RT_REFRACT_DEPTH : REFLECT)", "`endif"])


# ---- parameters of rt_core ----
def parameter(name, value, what, end=","):
    return f"    parameter {name:<10} = {value}{end}".ljust(32) + f" // {what}"


def parameters_of(effects):
    return [parameter(e.core, e.all, (f"0..{e.most}" if e.most > 1 else "0 or 1") + f": {e.about}")
            for e in effects]


def size_parameter(size, end=","):
    return parameter(size.name, size.standard,
                     f"{size.least}..{size.most}{', power of two' * size.power}: {size.about}", end)


def effects_of(machine, parts):
    return [e for e in machine.effects.values() if e.is_part == parts]


def widths(machine):
    """(NAME, words of its line)"""
    return [(words[0].upper(), words) for kind, words in machine.rows if kind == "width"]


def declarations(machine):
    """{NAME: line} of parameters of rt_core that are no widths."""
    declared = dict(zip((e.core for e in machine.effects.values()),
                        parameters_of(machine.effects.values())))
    declared |= {s.name: size_parameter(s) for s in machine.sizes.values()}
    return declared


def shade_names(machine):
    return [word for kind, words in machine.rows if kind == "shade" for word in words]


def shade_parameters(machine):
    declared = declarations(machine)
    return [declared[name] for name in shade_names(machine)]


def shade_pass(machine):
    return connected(shade_names(machine))


def effect_parameters(machine):
    return [parameter(name, f"`RT_PROFILE_STANDARD_{name}", " ".join(words[words.index(":") + 1:]))
            for name, words in widths(machine)] + [
        "    // effects that are elaborated, a machine that asks for more is refused "
        "(MISSING_EFFECT)", *parameters_of(effects_of(machine, False))]


def core_parameters(machine):
    sizes = list(machine.sizes.values())
    return ['    `include "rt_effects.vh"', *parameters_of(effects_of(machine, True)),
            "    // sizes, on which only cells and cycles depend"] + [
        size_parameter(s, "," * (s is not sizes[-1])) for s in sizes]


# ---- what is given to parameters of the same name ----
def connected(names, last=","):
    """`.NAME(NAME),` in lines of up to 90 columns and a blank."""
    line, lines = "", []
    for name in names:
        word = f".{name}({name})" + (last if name is names[-1] else ",")
        if len(line + word) > 90:
            lines.append(line)
            line = ""
        line += (" " if line else "        ") + word
    return lines + [line]


def effects_pass(machine):
    return connected([name for name, _ in widths(machine)] +
                     [e.core for e in effects_of(machine, False)])


def core_pass(machine):
    return ['        `include "rt_effects_pass.vh"'] + connected(
        [e.core for e in effects_of(machine, True)] + [s.name for s in machine.sizes.values()], "")


# ---- what is legal ----
def check(legal, message):
    return f"    `RT_CHECK({legal}, rt_core_{message.replace('+', '_plus_')})"


def between(name, least, most, power=False):
    legal = f"{name} >= {least} && {name} <= {most}"
    return check(legal + f" && ({name} & ({name} - 1)) == 0" * power,
                 f"{name}_must_be_{'a_power_of_two_from_' * power}{least}_to_{most}")


def unit(name, how_many):
    """Lines that end where an alternative does."""
    line, lines = f"    localparam {name} =", []
    for i, part in enumerate(f"{how_many};".split(" : ")):
        if len(line + part) > 84:
            lines.append(line)
            line = " " * 28
        line += (" : " if i else " ") + part
    return lines + [line]


def core_rules(machine):
    yield from (line for row in machine.units.items() for line in unit(*row))
    yield from (between(name, *words[3:5]) for name, words in widths(machine))
    core = {name: e.core for name, e in machine.effects.items()}
    for e in machine.effects.values():
        yield between(e.core, 0, e.most)
        yield from (check(f"{e.core} == 0 || {core[word]} != 0", f"{e.core}_needs_{core[word]}")
                    for word in e.needs)
        yield from (check(f"{e.core} == 0 || {core[word]} == 0", f"{e.core}_excludes_{core[word]}")
                    for word in e.excludes if e.is_part)
    yield from (between(s.name, s.least, s.most, s.power) for s in machine.sizes.values())
    yield from (check(legal, rule) for rule, legal in machine.rules.items())


FILES = (
    ("effects", "Widths and effects: the first of the parameters of a module.", effect_parameters),
    ("effects_pass", "rt_effects.vh to an instance, by name: the first that it is given.",
     effects_pass),
    ("core_parameters", "All parameters of rt_core: the last of those of a module.",
     core_parameters),
    ("core_pass", "rt_core_parameters.vh to an instance, by name: all that it is given.",
     core_pass),
    ("shade_parameters", "Parameters of rt_shade and of what hands them on, besides effects.",
     shade_parameters),
    ("shade_pass", "rt_shade_parameters.vh to an instance, by name.", shade_pass),
    ("core_rules", "Units of an engine, legal values of parameters, alone and together.",
     core_rules))


def c(machine):
    return Layout(machine).c()


def verilog(machine):
    """(NAME of rt_NAME.vh, its text)"""
    yield "layout", Layout(machine).verilog()
    for name, what, lines in FILES:
        yield name, told([*verilog_head(f"rt_{name}.vh", FROM, what), *lines(machine)])
