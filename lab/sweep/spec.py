# spec.py - what a sweep is: its points, what is measured at each, what is drawn of it
# SPDX-License-Identifier: Apache-2.0
"""Words of a sweep are, in a file a line each with # comments, on a command line with -- before
the name:

  AXIS VALUE...      every value with every one of the other axes; N..M are numbers
  measure NAME...    counts, accuracy, price, cycles, cells; counts if none is given
  show FIGURE...     columns of the printed table, and what is drawn; FILE.csv has all figures
  x AXIS, lines AXIS, panel AXIS...   of plots: small multiples, one for each panel
  heat X Y           axes of heat maps, instead of lines
  beside FILE        a CSV file of figures to stand beside: published ones, or another sweep's
  also               in a file: the lines before the first `also` hold for all parts, which are
                     behind each `also`; their points are put together

A name that is none, a value that is none: Wrong, with the nearest right word."""
import itertools
import os
import re
import shlex
from pathlib import Path

from . import axes
from .axes import Wrong, lines, perhaps

WORDS = {"measure": 99, "show": 99, "x": 1, "lines": 1, "panel": 99, "heat": 2, "beside": 1}


class Spec:
    """measures, points, axes (those of more than one value first), and words of how it is shown."""

    def __init__(self, parts):
        self.said = {name: found[name] for name in WORDS
                     for found in parts if name in found}
        self.measures = self.said.get("measure", ["counts"])
        for name in self.measures:
            if name not in axes.SHAPES:
                raise Wrong(f"measure: {name} is none of {', '.join(axes.SHAPES)}"
                            f"{perhaps(name, axes.SHAPES)}")
        self.points = []
        for part in parts:
            given = {name: axes.values_of(name, words) for name, words in part.items()
                     if name not in WORDS}
            self._complete(given)
            self.points += [dict(zip(given, chosen))
                            for chosen in itertools.product(*given.values())]
        self.points = list({tuple(sorted(point.items())): point for point in self.points}.values())
        every = list(dict.fromkeys(name for point in self.points for name in point))
        seen = {name: list(dict.fromkeys(point[name] for point in self.points if name in point))
                for name in every}
        self.varied = {name: values for name, values in seen.items() if len(values) > 1}
        self.axes = [*self.varied, *(name for name in every if name not in self.varied)]
        for word in ("x", "lines", "panel", "heat"):
            for name in self.said.get(word, []):
                if name not in self.varied:
                    raise Wrong(f"{word}: {name} is no axis with several values here"
                                f"{perhaps(name, self.varied)}")

    def _complete(self, given):
        shaped = {name for measure in self.measures for name in axes.SHAPES[measure]}
        if "scene" in shaped and "scene" not in given:
            raise Wrong(f"no scene is given: {', '.join(self.measures)} need one")
        for name in given:
            own = "profile" if name in axes.WIDTHS else "sizes" if name in axes.SIZES else name
            if own not in shaped and not (name in ("profile", *axes.WIDTHS)
                                          and "price" in self.measures):
                raise Wrong(f"{name} shapes none of what is measured ({', '.join(self.measures)})")


def _pairs(words):
    """[(name, values)] of a command line."""
    found = []
    for word in words:
        option = re.fullmatch("--([A-Za-z_-]+)(?:=(.*))?", word, re.S)
        if option:  # and not a value such as "--bih listing"
            found.append((option[1].replace("-", "_"), [] if option[2] is None else [option[2]]))
        elif found:
            found[-1][1].append(word)
        else:
            raise Wrong(f"{word}: is no file, and no --AXIS stands before it")
    return found


def _known(name, where=""):
    if name not in WORDS and name not in axes.KNOWN:
        known = [*WORDS, *axes.KNOWN]
        raise Wrong(lines(f"{where}there is no axis and no word {name}"
                          f"{perhaps(name, known, '.')} There are", known))


def _put(into, name, values, where):
    _known(name, where)
    if not values:
        raise Wrong(f"{where}{name}: no value is given")
    if name in WORDS and not len(values) <= WORDS[name] or name == "heat" and len(values) != 2:
        raise Wrong(f"{where}{name} takes {WORDS[name]}, not {len(values)}")
    into[name] = values


def from_here(path):
    """A file's name, from where the command was called."""
    return os.path.join(os.environ.get("FROM", ""), path)


def of_file(path):
    """Parts of a file: {name: values} each."""
    try:
        text = Path(from_here(path)).read_text(encoding="utf-8")
    except OSError as why:
        raise Wrong(f"{path}: {why.strerror}") from None
    except UnicodeError as why:
        raise Wrong(f"{path}: {why}") from None
    parts = [{}]
    for number, line in enumerate(text.splitlines(), 1):
        where = f"{path}:{number}: "
        try:
            name, *values = shlex.split(line, comments=True) or [""]
        except ValueError as why:
            raise Wrong(f"{where}{why}") from None
        if name == "also":
            parts.append({})
        elif name:
            if name in parts[-1]:
                raise Wrong(f"{where}{name} stands there twice")
            _put(parts[-1], name, values, where)
            if name in axes.KNOWN:
                try:
                    axes.values_of(name, values)
                except Wrong as why:
                    raise Wrong(f"{where}{why}") from None
            elif name == "beside":  # by where the file is
                parts[-1][name] = [os.path.join(os.path.dirname(from_here(path)), values[0])]
    first, *rest = parts
    return [{**first, **part} for part in rest] or [first]


def of_words(words):
    """A Spec, and the file it is from or "": [FILE] [--NAME VALUE...]..."""
    file = words[0] if words and not words[0].startswith("--") else ""
    parts = of_file(file) if file else [{}]
    for name, values in _pairs(words[bool(file):]):
        for part in parts:
            _put(part, name, [from_here(values[0])] if name == "beside" and values else values,
                 "")
    return Spec(parts), file
