# variables.py - make/variables.mk, the table of what may be given to make, and its rules
# SPDX-License-Identifier: Apache-2.0
import os
import re

NAME = os.path.join(os.path.dirname(__file__), "../make/variables.mk")


class Table:
    """rules: {name: rule}; texts: {name: [what it means, and what `make help-all` adds]}"""

    def __init__(self):
        self.rules, self.texts = {}, {}
        name = None
        with open(NAME, encoding="utf-8") as f:
            for line in f:
                first = re.match(r"## ([A-Z_]+) +([^ \n]+) *(.*)", line)
                more = re.match(r"## {2,}(.*)", line)
                if first:
                    name = first[1]
                    self.rules[name], self.texts[name] = first[2], [first[3]]
                elif more:
                    self.texts[name].append(more[1])


def bound(text, constants):
    """Of a sum of numbers and names; None: it is open, or not known here."""
    parts = [int(p) if p.isdecimal() else constants.get(p) for p in text.split("+")] if text else []
    return sum(parts) if parts and None not in parts else None


def spoken(rule, constants):
    """A rule for people, and the words in it. Kinds are left out."""
    said, words = [], []
    for one in rule.split("|"):
        word, at, goal = one.partition("@")
        least, dots, most = one.partition("..")
        if not one or one.startswith("<"):
            continue
        if dots:
            top = bound(most, constants)
            said.append(f"{least} to {most if top is None else top}" if most else
                        f"{least} and more")
            continue
        said.append(f"{word} (make {goal})" if at else word)
        words.append(said[-1])
    return ", ".join(said), words


def for_goals(rule, goals):
    """A rule without words that belong to goals that are not made."""
    kept = [one.partition("@")[0] for one in rule.split("|")
            if "@" not in one or one.partition("@")[2] in goals]
    return "|".join(kept)
