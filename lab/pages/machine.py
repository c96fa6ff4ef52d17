# machine.py - what cmodel/machine/machine.def defines, as tables
# SPDX-License-Identifier: Apache-2.0
import subprocess
from pathlib import Path

from . import markdown

DEF = Path("cmodel/machine/machine.def")


def rows(kind):
    """The words of each line of a kind, up to its comment or all of them."""
    found = []
    for line in DEF.read_text().splitlines():
        word = line.split("#")[0].split()
        if word and word[0] == kind:
            found.append(word[1:])
    return found


def constants():
    """{name: value}"""
    return {name: value for name, value, *_ in rows("const")}


def registers():
    """Those without a meaning share the row above them."""
    merged = []
    for number, name, *meaning in rows("reg"):
        if meaning or not merged:
            merged.append([number, number, f"`{name}`", " ".join(meaning)])
        else:
            merged[-1][1] = number
            merged[-1][2] += f", `{name}`"
    return markdown.table(["number", "name", "meaning"],
                          [[first if first == last else f"{first} .. {last}", name, meaning]
                           for first, last, name, meaning in merged])


def parts():
    """[word, parameter, bit, most, in `all`, needs, excludes, meaning] of what a core can do."""
    listed = subprocess.run(["sh", "sim/parameters.sh", "--table"], check=True, text=True,
                            stdout=subprocess.PIPE).stdout
    return [line.split("\t") for line in listed.splitlines()]


def effects():
    """What a core can do, and the bit of EFFECTS by which a machine asks for it."""
    def words(text):
        return text.replace(",", ", ")
    return markdown.table(["word", "parameter", "values", "in `all`", "bit", "what it is", "needs",
                           "goes without"],
                          [[f"`{word}`", f"`{core}`", "0, 1" if most == "1" else f"0 .. {most}",
                            whole, bit, about, words(needs), words(excludes)]
                           for word, core, bit, most, whole, needs, excludes, about in parts()])


def counters():
    """A star behind the name: counted by the RTL alone."""
    return markdown.table(["number", "name", "counts"],
                          [[number, f"`{name}`" + " \\*" * (where == "rtl"), " ".join(words)]
                           for number, name, where, *words in rows("counter")])


def errors():
    return markdown.table(["bit", "name", "when"],
                          [[bit, f"`{name}`", " ".join(words)] for bit, name, *words
                           in rows("error")])


def profiles():
    """Widths in bits; PR 0 is every bit of the root."""
    return markdown.table(["profile", "W", "WD", "PQ", "NG", "FW", "PR"],
                          [[name, *widths[:5], "all" if widths[5] == "0" else widths[5]]
                           for name, *widths in rows("profile")])


def widths():
    return markdown.table(["width", "bits, from", "to", "and why no more"],
                          [[name.upper(), least, most, " ".join(why)]
                           for name, _, _, least, most, *why in rows("width")])
