# definition.py - cmodel/machine/machine.def: profiles, effects, sizes and rules of a core
# SPDX-License-Identifier: Apache-2.0
import os
import re
from collections import namedtuple

NAME = os.path.join(os.path.dirname(__file__), "../cmodel/machine/machine.def")
WIDTHS = ("w", "wd", "pq", "ng", "fw", "pr")     # of a profile, in this order

# core: its parameter; bit: in the machine file, or None; all: of the core `all`
Effect = namedtuple("Effect", "name core bit most all needs excludes is_part about")
Size = namedtuple("Size", "name standard least most power")


class Definition:
    """What the lines of machine.def say; sim/layout.sh refuses those that say nothing sound."""

    def __init__(self):
        self.constants, self.profiles, self.paces, self.bounds = {}, {}, {}, {}
        self.effects, self.sizes, self.units, self.rules = {}, {}, {}, {}
        self.rates, self.loads = {}, {}     # of a load: how many units, clocks of all together
        effect = None
        with open(NAME, encoding="utf-8") as f:
            for line in f:
                kind, *word = line.split() or [""]
                about = line.partition(" : ")[2].strip()
                if kind in ("effect", "part"):
                    effect = self.effect(kind, word)
                elif kind == "size":
                    self.sizes[word[0].lower()] = Size(word[0], *word[1:4], word[4] == "power")
                elif kind in ("unit", "legal"):
                    (self.units if kind == "unit" else self.rules)[word[0]] = about
                elif kind == "load":
                    self.loads[word[0].replace("_", " ")] = line.strip().split(" : ")[1:]
                elif kind == "rate":
                    self.rates[word[0]] = about
                elif kind == "const":
                    self.constants[word[0]] = int(word[1])
                elif kind == "profile":
                    self.profiles[word[0]] = dict(zip(WIDTHS, map(int, word[1:7])))
                elif kind == "width":
                    self.bounds[word[0]] = int(word[3]), int(word[4])
                elif kind == "pace":
                    self.paces[word[0]] = word[1:]
                if effect and not self.effects[effect].about and re.search(r"(^| ): ", line):
                    self.effects[effect] = self.effects[effect]._replace(
                        about=re.sub(r"^(.* )?: ", "", line.strip("\n")))

    def effect(self, kind, word):
        field = dict(w.split("=", 1) for w in word[1:] if "=" in w)
        most = int(field.get("most", 1))
        self.effects[word[0]] = Effect(
            word[0], field.get("core", word[0].upper()), field.get("bit"), most,
            int(field.get("all", most)), *(field[w].split(",") if w in field else []
                                           for w in ("needs", "excludes")), kind == "part", "")
        return word[0]


def value(text, values):
    """Of a rule's expression in C: names, numbers, ?: && ||."""
    asked, has, rest = text.partition("?")
    if has:
        one, _, other = rest.partition(":")
        return value(one if value(asked, values) else other, values)
    text = text.replace("&&", " and ").replace("||", " or ").replace("/", "//")
    known = {"__builtins__": {}, "max": max, "min": min}
    return int(eval(text, known, values))   # pylint: disable=eval-used
