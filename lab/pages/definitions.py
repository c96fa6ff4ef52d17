# definitions.py - what machine.def, bundles.def and modes.def define, as tables and lists
# SPDX-License-Identifier: Apache-2.0
import re
from functools import lru_cache
from pathlib import Path

from sim.definition import Definition

from ..generate.modes import Modes
from ..generate.top import Registers
from . import markdown

definition = lru_cache(maxsize=None)(Definition)


def rows(kind):
    """The words of each line of a kind, behind it."""
    return [words for first, words in definition().rows if first == kind]


def constants():
    """{name: value}"""
    return {name: value for name, value, *_ in rows("const")}


def registers():
    """Those without a meaning, and those with the same one, share an entry."""
    merged = []
    for number, name, *meaning in rows("reg"):
        if merged and meaning in ([], merged[-1][3]):
            merged[-1][1] = number
            merged[-1][2] += f"`, `{name}"
        else:
            merged.append([number, number, name, meaning])
    return markdown.entries((f"{first}{f'..{last}' * (first != last)} `{name}`", " ".join(meaning))
                            for first, last, name, meaning in merged)


FORMAT = Path("cmodel/machine/format.h")


def file_format():
    """{name of format.h: value}, and how many registers there are."""
    found = dict(re.findall(r"\bSPH_([A-Z0-9_]+) = (\d+)\b", FORMAT.read_text()))
    number = {name: int(value) for name, value in found.items()}
    number["N_REGS"] = 1 + max(int(row[0]) for row in rows("reg"))
    number["HEADER_BYTES"] = number["AT_REGS"] + 4 * number["N_REGS"]
    number["LINE_BYTES"] = 4 * int(constants().get("LINE_WORDS", 8))
    return number


def file_number(name):
    return str(file_format()[name])


def file_header():
    """The fields of a machine file's header, by byte."""
    n = file_format()
    return markdown.table(["byte", "field", "type"], [
        [n["AT_MAGIC"], "magic `SPHAERA1`", "8 bytes"],
        [n["AT_VERSION"], f"version, {n['FILE_VERSION']}", "u32"],
        [n["AT_HEADER"], f"bytes before memory, {n['HEADER_BYTES']}", "u32"],
        [n["AT_N_REGS"], f"number of registers, {n['N_REGS']}", "u32"],
        [n["AT_LINE_WORDS"], f"32-bit words in a line, {n['LINE_BYTES'] // 4}", "u32"],
        [n["AT_LINES"], "lines of memory", "u32"],
        [n["AT_GRID_LOG2"], "log2 of the grid step", "s32"],
        [n["AT_PROFILE"], "profile widths W, WD, PQ, NG, FW and PR", f"{n['N_WIDTHS']} u32"],
        [n["AT_NAME"], "name of the scene, with a zero at the end", f"{n['NAME_BYTES']} bytes"],
        [n["AT_ORIGIN"], "origin, coordinates of grid point 0", "3 f64"],
        [n["AT_ROTATION"], "rotation, the grid's x, y, z axes in the scene's frame", "9 f64"],
        [n["AT_REGS"], f"registers 0..{n['N_REGS'] - 1}", f"{n['N_REGS']} s32"]])


def top_registers():
    """Those of rt_top, as its bus sees them."""
    return Registers(definition()).table()


def effects():
    """Word, parameter with its default and range, the bit of EFFECTS by which a machine asks."""
    def told(e):
        words = [f"needs {', '.join(e.needs)}"] * bool(e.needs)
        words += [f"goes without {', '.join(e.excludes)}"] * bool(e.excludes)
        return "; ".join([e.about, *words])

    def name(e):
        asked = f", bit {e.bit}" * (e.bit is not None)
        return f"`{e.name}`, `{e.core}` = {e.all} (0..{e.most}{asked})"
    return markdown.entries((name(e), told(e)) for e in definition().effects.values())


def counters():
    """A star behind the number: counted by the RTL alone."""
    return markdown.entries((number + "\\*" * (where == "rtl") + f" `{name}`", " ".join(words))
                            for number, name, where, *words in rows("counter"))


def errors():
    return markdown.entries((f"{bit} `{name}`", " ".join(words))
                            for bit, name, *words in rows("error"))


def profiles():
    """Widths in bits; PR 0 is every bit of the root."""
    return markdown.table(["profile", "W", "WD", "PQ", "NG", "FW", "PR"],
                          [[name, *widths[:5], "all" if widths[5] == "0" else widths[5]]
                           for name, *widths in rows("profile")])


def widths():
    return markdown.table(["width", "bits, from", "to", "and why no more"],
                          [[name.upper(), least, most, " ".join(why[:why.index(":")])]
                           for name, _, _, least, most, *why in rows("width")])


def modes():
    return Modes().table()


BUNDLES = Path("rtl/engine/bundles.def")


def bundles():
    """A list for each bundle: what it is, and its fields with their bits and meaning, but for a
    VALID and a SLOT that say nothing of their own."""
    told = []
    for line in BUNDLES.read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        kind, *words = line.split(maxsplit=2 if line.startswith("b") else 3)
        if kind == "bundle":
            told.append((f"- **`{words[0]}`**, {words[1]}", []))
        elif kind == "field":
            name, width, *meaning = words
            if not meaning and name in ("VALID", "SLOT"):
                continue
            bits = [width] * (width != "1")
            told[-1][1].append(" ".join([f"`{name}`"] + bits + [f"({m})" for m in meaning]))
    return "\n".join(markdown.nested(*bundle) for bundle in told)
