# definition.py - cmodel/machine/machine.def: profiles, effects, sizes and rules of a core
# SPDX-License-Identifier: Apache-2.0
import os
import re
import sys
from collections import namedtuple

NAME = os.path.join(os.path.dirname(__file__), "../cmodel/machine/machine.def")
WIDTHS = ("w", "wd", "pq", "ng", "fw", "pr")     # of a profile, in this order
KEYS = ("core", "bit", "most", "all", "asked", "option", "needs", "excludes")   # of an effect
LEAST = {"kind": 2, "field": 4, "reg": 2, "counter": 4, "error": 2, "profile": 7, "width": 7}
SHORT = "too few words, or no number where one stands"
OPTIONS = ("when", "count", "off", "none")

# core: its parameter; bit: of register EFFECTS, or None; all: of the core `all`
Effect = namedtuple("Effect", ("name", *KEYS, "is_part", "about"))
Size = namedtuple("Size", "name standard least most power about")


class Unsound(Exception):
    """With file and line."""


class Definition:
    """What the lines of machine.def say; raises Unsound. rows: (kind, words) of each line, without
    its comment; bits: how many register EFFECTS has."""

    def __init__(self):
        self.constants, self.profiles, self.paces, self.bounds = {}, {}, {}, {}
        self.effects, self.sizes, self.units, self.rules = {}, {}, {}, {}
        self.rates, self.loads = {}, {}     # of a load: how many units, clocks of all together
        self.rows, self.bits, self.line, at = [], 0, 0, {}
        with open(NAME, encoding="utf-8") as f:
            for self.line, text in enumerate(f, 1):
                text = text.rstrip("\n")
                kind, *words = text.partition("#")[0].split() or [""]
                self.rows += [(kind, words)] if kind else []
                try:
                    (self.effect if kind in ("effect", "part", ":") else self.other)(
                        kind, words, text)
                except (IndexError, ValueError):
                    self.fail(f"{kind}: {SHORT}")
                if kind in ("effect", "part"):
                    at[words[0]] = self.line
        for self.line, effect in zip(at.values(), self.effects.values()):
            if not effect.about:
                self.fail(f"{effect.name}: what it is does not stand behind a colon")
            for word in (*effect.needs, *effect.excludes):
                if word not in self.effects:
                    self.fail(f"{effect.name}: there is no {word}")

    def fail(self, why):
        raise Unsound(f"{os.path.relpath(NAME)}:{self.line}: {why}")

    def behind(self, mark, text, words, what):
        found = re.match(f"{mark} : (.*)", text)
        return found[1] if found else self.fail(f"{words[0]}: {what} behind a colon")

    def effect(self, kind, words, text):
        if kind != ":":
            self.keys(kind, words)
        name, effect = [*self.effects.items()][-1]
        if not effect.about and re.search("(^| ): ", text):
            self.effects[name] = effect._replace(about=re.sub("^(.* )?: ", "", text))

    def keys(self, kind, words):
        name, is_part, taken = words[0], kind == "part", [e.bit for e in self.effects.values()]
        if name in self.effects:
            self.fail(f"{name} stands twice")
        if not re.fullmatch("[a-z]+", name):
            self.fail(f'"{name}" is no word of small letters')
        if not is_part and any(e.is_part for e in self.effects.values()):
            self.fail("an effect stands above each part")
        own = words[1:words.index(":")] if ":" in words else words[1:]
        for word in own:
            if word.partition("=")[0] not in KEYS:
                self.fail(f'"{word}" is none of {", ".join(KEYS)}')
        own = dict(word.split("=", 1) for word in own)
        most, bit = int(own.get("most", 1)), int(own["bit"]) if "bit" in own else None
        needs, excludes = (own[w].split(",") if w in own else [] for w in ("needs", "excludes"))
        found = Effect(name, own.get("core", name.upper()), bit, most, int(own.get("all", most)),
                       own.get("asked", ""), own.get("option", "none"), needs, excludes, is_part,
                       "")
        if found.option not in OPTIONS:
            self.fail(f'option is "{found.option}", none of when, count, off and none')
        if bit is not None and bit in taken:
            self.fail(f"bit {bit} is taken")
        if bit is None and not found.asked:
            self.fail(f"nothing asks for {name}")
        self.bits = max(self.bits, 0 if bit is None else bit + 1)
        self.effects[name] = found

    def other(self, kind, words, text):
        if len(words) < LEAST.get(kind, 0):
            raise IndexError
        if kind == "size":
            about = self.behind(".*", text, words, "what it is does not stand")
            self.sizes[words[0].lower()] = Size(words[0], *words[1:4], words[4] == "power", about)
        elif kind in ("unit", "rate", "legal"):
            {"unit": self.units, "rate": self.rates, "legal": self.rules}[kind][words[0]] = \
                self.behind("[^:]*", text, words, "no expression stands")
        elif kind == "load":
            parts = re.split(" +: ", text)
            if len(parts) != 3:
                self.fail(f"{words[0]}: not `load name : units : clocks`")
            self.loads[words[0].replace("_", " ")] = parts[1:]
        elif kind == "const":
            self.constants[words[0]] = int(words[1])
        elif kind == "profile":
            self.profiles[words[0]] = dict(zip(WIDTHS, map(int, words[1:7])))
        elif kind == "width":
            self.bounds[words[0]] = int(words[3]), int(words[4])
        elif kind == "shade":
            for word in words:
                if word not in [e.core for e in self.effects.values()] and \
                        word.lower() not in self.sizes:
                    self.fail(f"{word} is no parameter")
        elif kind == "pace":
            for word in words[1:]:
                name, _, given = word.partition("=")
                size = self.sizes.get(name.lower())
                if not size or not given.isdecimal():
                    self.fail(f'"{word}" is no size=value')
                if not int(size.least) <= int(given) or (size.most.isdecimal() and
                                                         int(given) > int(size.most)):
                    self.fail(f"{word} is not in {size.least}..{size.most}")
            self.paces[words[0]] = words[1:]


def read():
    """For a program: it ends with a message if the definition is unsound."""
    try:
        return Definition()
    except Unsound as fault:
        return sys.exit(str(fault))


def value(text, values):
    """Of a rule's expression in C: names, whole numbers, ?: && ||, max and min of two."""
    asked, has, rest = text.partition("?")
    if has:
        one, _, other = rest.partition(":")
        return value(one if value(asked, values) else other, values)
    text = text.replace("&&", " and ").replace("||", " or ").replace("/", "//")
    known = {"__builtins__": {}, "max": max, "min": min}
    return int(eval(text, known, values))   # pylint: disable=eval-used
