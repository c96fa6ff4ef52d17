# lists.py - lines of tb/benches.txt, with the widths of their profiles filled in
# SPDX-License-Identifier: Apache-2.0
"""A line: configuration, module, bench, parameters of the module / of the bench alone. In it
  each            stands for every profile, a line each; without ALL=1 for the first and the last
  more            before a line: only with ALL=1
  -O0             before names of benches, no configuration: how the compiler works on them
  NAME@PROFILE    is configuration NAME with the widths of a profile
  W, WD, PQ, NG, FW, PR   alone are the width of the profile; XW=2*W+2*WD is made of them"""
import re

from sim.definition import Definition

FILE = "tb/benches.txt"


def number(text, widths):
    """Of a sum of products of numbers and widths; another text as it is."""
    if not re.fullmatch("[A-Z0-9+*]+", text):
        return text
    total = 0
    for term in text.split("+"):
        product = 1
        for factor in term.split("*"):
            if not factor.isdecimal() and factor.lower() not in widths:
                raise ValueError(f"{factor} is no number, and no width of a profile")
            product *= int(factor) if factor.isdecimal() else widths[factor.lower()]
        total += product
    return str(total)


def parameter(word, widths):
    key, equals, value = word.partition("=")
    return word if word == "/" else f"{key}={number(value if equals else key, widths)}"


def lines_of(name, words, whole, profiles):
    """The lines that one of a list stands for."""
    if name == "each":
        names = list(profiles)
        rows = [(p, p) for p in (names if whole else names[::len(names) - 1])]
    else:
        rows = [(name.partition("@")[0], name.rpartition("@")[2])]
    for configuration, profile in rows:
        widths = profiles.get(profile, {})
        yield " ".join([configuration, *words[:2], *(parameter(w, widths) for w in words[2:])])


def efforts():
    """{bench: option of the compiler} of those that the file says one of."""
    with open(FILE, encoding="utf-8") as f:
        lines = [line.split() for line in f if line.startswith("-O")]
    return {bench: words[0] for words in lines for bench in words[1:]}


def listed(whole):
    """whole: of ALL=1. Raises ValueError with file and line."""
    profiles = Definition().profiles
    with open(FILE, encoding="utf-8") as f:
        for at, line in enumerate(f, 1):
            words = line.split() if not line.startswith(("#", "-O")) else []
            more = words[:1] == ["more"]
            if len(words) < 3 + more and words:
                raise ValueError(f"{FILE}:{at}: no configuration, module and bench")
            if words and (whole or not more):
                try:
                    yield from lines_of(words[more], words[more + 1:], whole, profiles)
                except ValueError as why:
                    raise ValueError(f"{FILE}:{at}: {why}") from why
