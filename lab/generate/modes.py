# modes.py - modes.def as a Verilog header, a C header and a table of the page
# SPDX-License-Identifier: Apache-2.0
import re
from collections import namedtuple

from .lines import Lines, c_head, told, verilog_head

FROM = "modes.def"
# horizontal, vertical: active, front, sync, back and polarity of each, as the line has them
Mode = namedtuple("Mode", "name khz horizontal vertical standard")


class Modes:
    """fields: {NAME: bits}, from bit 0 on; modes: of each name."""

    def __init__(self):
        self.fields, self.modes, self.lines = {}, [], Lines("rtl/video/modes.def")
        self.lines.each(self.take)

    def take(self, kind, words, text):
        if kind not in ("field", "mode"):
            self.lines.fail(f"neither field nor mode: {kind}")
        if words[0] in (*self.fields, *(mode.name for mode in self.modes)):
            self.lines.fail(f"{words[0]} stands twice")
        (self.field if kind == "field" else self.mode)(words, text)

    def field(self, words, _):
        if not re.fullmatch("[1-9][0-9]*", words[1]):
            self.lines.fail(f"{words[0]}: {words[1]} is no width")
        self.fields[words[0]] = int(words[1])

    def mode(self, words, text):
        name, *numbers = words[:12]
        if len(words) < 13:
            self.lines.fail(f"{name} has no standard, or too few numbers")
        for i, word in enumerate(numbers):
            kind, pattern = ("polarity", "[-+]") if i in (5, 10) else ("number", "[1-9][0-9]*")
            if not re.fullmatch(pattern, word):
                self.lines.fail(f'{name}: "{word}" is no {kind}')
        standard = text.split(None, 13)[13]
        self.modes.append(Mode(name, int(numbers[0]), numbers[1:6], numbers[6:], standard))

    def numbers(self, mode):
        """In the order of the fields."""
        value = {f"{axis}_{key}": int(word == "+") if key == "POL" else int(word)
                 for axis, words in (("H", mode.horizontal), ("V", mode.vertical))
                 for key, word in zip(("ACTIVE", "FRONT", "SYNC", "BACK", "POL"), words)}
        return [value[name] for name in self.fields]

    def verilog(self):
        lines = verilog_head(
            "rt_modes.vh", FROM,
            "mode_i[`RT_MODE_H_SYNC] is a field of the bundle; `RT_MODE_640X480 is a whole one")
        lines += ["`ifndef RT_MODES_VH", "`define RT_MODES_VH"]
        at = 0
        for name, bits in self.fields.items():
            lines.append(f"`define RT_MODE_{name} {at} +: {bits}")
            at += bits
        for mode in self.modes:     # the last field stands highest
            whole = [f"{bits}'d{number}" for number, bits in zip(self.numbers(mode),
                                                                 self.fields.values())]
            macro = re.sub("[^A-Z0-9]", "_", mode.name.upper())
            lines.append(f"`define RT_MODE_{macro} {{{', '.join(reversed(whole))}}}")
        return told([*lines, f"`define RT_MODE_BITS {at}", "`endif"])

    def c(self):
        each = "".join(f' \\\n    X("{mode.name}", {mode.khz}, '
                       f'{", ".join(map(str, self.numbers(mode)))})' for mode in self.modes)
        return told([
            *c_head("sphaera_modes.h", FROM, "SPHAERA_MODES(X): X(name, kHz, fields as "
                    "SPHAERA_MODE_FIELDS names them) each."),
            "#ifndef SPHAERA_MODES_H", "#define SPHAERA_MODES_H",
            f"#define SPHAERA_MODE_FIELDS {', '.join(map(str.lower, self.fields))}",
            f"#define SPHAERA_MODES(X){each}", "#endif"])

    def table(self):
        """MB/s: what the display takes at most, pixels of a row by the time of a row."""
        lines = ["| mode | MHz | active, front, sync, back | hsync | rows: the same | vsync |"
                 " whole frame | Hz | MB/s, 32 / 16 bit | standard |",
                 "|---|---|---|---|---|---|---|---|---|---|"]
        for mode in self.modes:
            across, down = (sum(map(int, words[:4])) for words in (mode.horizontal, mode.vertical))
            rates = [f"{int(mode.horizontal[0]) * size * mode.khz / across / 1000:.0f}"
                     for size in (4, 2)]
            horizontal, vertical = (f"{', '.join(words[:4])} | {words[4]}"
                                    for words in (mode.horizontal, mode.vertical))
            lines.append(f"| {mode.name} | {mode.khz / 1000:.3f} | {horizontal} | {vertical} | "
                         f"{across} x {down} | {mode.khz * 1000 / across / down:.2f} | "
                         f"{' / '.join(rates)} | {mode.standard} |")
        return "\n".join(lines)
