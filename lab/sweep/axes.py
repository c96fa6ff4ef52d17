# axes.py - axes of sweeps, which of them shape which measure, and the key of a job
# SPDX-License-Identifier: Apache-2.0
"""An axis is a variable of make in small letters, with its rule and its meaning
(make/variables.mk); a width of the profile (w, wd, pr, pq, ng, fw) and a size of rt_core besides
are axes, too. A key is `measure=NAME`, then NAME=VALUE for every axis that shapes the measure,
in the order of SHAPES: a result has one key, whatever the sweep that asked for it."""
import re
import sys
from urllib.parse import quote, unquote

sys.path.insert(0, "sim")
import cores
import definition
import front
import scene as scenes
import variables
from words import Wrong, lines, perhaps

from ..runner import named

BUILD = ["scene", "size", "profile", "samples", "accel", "tree", "max_prims", "max_tree_depth",
         "depth", "background", "levels", "traverse", "at", "build_more"]
UNITS = ["engines", "pipes", "leaf_units", "shades", "root_step", "quotient_step", "sizes"]
SHAPES = {
    "counts": BUILD,
    "accuracy": BUILD + ["truth"],
    "price": [name for name in BUILD if name != "profile"],  # of all profiles at once
    "cycles": BUILD + ["effects", *UNITS, "latency", "stall", "seed", "memory", "core_mhz",
                       "warm"],
    "cells": ["profile", "effects", *UNITS, "target", "yosys"],
}
AXES = list(dict.fromkeys(name for names in SHAPES.values() for name in names))
# where a sweep has something else than make if nothing is given; scene: must be
USUAL = {"scene": "", "profile": "standard", "tree": "auto", "leaf_units": "0", "seed": "1",
         "size": "96x54", "yosys": "yosys"}
TABLE = variables.Table()
# rules; tree auto: as the build takes it; truth: reflections of the reference, empty: as depth
RULES = {name: TABLE.rules.get(name.upper(), "0..MAX_DEPTH|") for name in AXES}
RULES["tree"] += "|auto"
DEFINITION = definition.read()
WIDTHS = list(DEFINITION.profiles["standard"])
SIZES = [name for name in DEFINITION.sizes if name.upper() not in TABLE.rules]
KNOWN = AXES + WIDTHS + SIZES


def _usual():
    with open(variables.NAME, encoding="utf-8") as f:
        found = dict(re.findall(r"^([A-Z_]+) +[?:]= *(.*)$", f.read(), re.M))
    return {name: USUAL.get(name, found.get(name.upper(), "")) for name in AXES}


DEFAULTS = _usual()


def name_of(word):
    """The axis of that name; Wrong with the nearest one and all."""
    if word not in KNOWN:
        raise Wrong(lines(f"there is no axis {word}{perhaps(word, KNOWN, '.')} There are", KNOWN))
    return word


def values_of(axis, words):
    """Values of an axis, each held against its rule; N..M are numbers, each."""
    found = []
    for word in words:
        if axis in WIDTHS + SIZES or ".." in RULES[axis]:
            ends = re.fullmatch("([0-9]{1,9})[.][.]([0-9]{1,9})", word)
            if ends and not 0 <= int(ends[2]) - int(ends[1]) < 1000:
                raise Wrong(f"{axis}: {word} is no range of up to 1000 numbers")
            if ends:
                found += map(str, range(int(ends[1]), int(ends[2]) + 1))
                continue
        found.append(word)
    found = [check(axis, value) for value in found]
    twice = next((value for value in found if found.count(value) > 1), None)
    if twice is not None:
        raise Wrong(f"{axis}: {twice} stands there twice")
    return found


def check(axis, value):
    """A value of that axis; Wrong if it is none. A scene that is a file of somebody's own gets the
    name that it has from the root of the tree."""
    if axis in WIDTHS:
        cores.profile(f"standard:{axis}={value}")
        return value
    if axis in SIZES:
        cores.sizes(f"{axis}={value}")
        return value
    if axis == "scene" and value == "protein":
        return value
    rule = RULES[axis]
    if value == "" and rule.endswith("|"):
        return value
    constants = dict(DEFINITION.constants, **cores.paced("reference"))
    said = ""
    for one in (r.partition("@")[0] for r in rule.split("|")):
        good, why = front.fits(one, value, constants)
        if good:
            found = scenes.find(value) if axis == "scene" else ""
            return value if found in (f"scenes/{value}.nff", named(value), "") else found
        said = said or why
    text, choice = variables.spoken(rule, constants)
    raise Wrong(f"{axis}: {value or '(nothing)'} "
                f"{said or 'is none of ' + text}{perhaps(value, choice)}")


def folded(point):
    """A point without widths and sizes of their own, which go into profile and sizes."""
    plain = {name: value for name, value in point.items() if name in AXES}
    own = [f"{name}={point[name]}" for name in WIDTHS if name in point]
    if own:
        base = plain.get("profile", DEFAULTS["profile"])
        plain["profile"] = base + (":" if ":" not in base else ",") + ",".join(own)
    own = [f"{name}={point[name]}" for name in SIZES if name in point]
    if own:
        plain["sizes"] = ",".join(filter(None, [plain.get("sizes", ""), *own]))
    return plain


def job(measure, **point):
    """The key of a job; axes that are not given are as in DEFAULTS, those that do not shape the
    measure do not matter. ValueError: a name that is none, a scene that lacks."""
    if measure not in SHAPES:
        raise ValueError(f"no measure {measure}")
    unknown = set(point) - set(KNOWN)
    if unknown:
        raise ValueError(f"{measure}: no {', '.join(sorted(unknown))}")
    full = {**DEFAULTS, **folded({name: str(value) for name, value in point.items()})}
    if not full["scene"] and "scene" in SHAPES[measure]:
        raise ValueError(f"{measure}: scene is needed")
    return " ".join([f"measure={measure}"] +
                    [f"{name}={quote(full[name], safe='=:,+/.-')}" for name in SHAPES[measure]])


def words(key):
    """A key as a dictionary, checked."""
    pairs = [word.split("=", 1) for word in key.split()]
    given = {pair[0]: unquote(pair[-1]) for pair in pairs}
    measure = given.pop("measure", None)
    try:
        if measure not in SHAPES or any(len(p) != 2 for p in pairs) or job(measure, **given) != key:
            raise ValueError(f"measure= one of {', '.join(SHAPES)}, then all its axes")
    except ValueError as e:
        sys.exit(f"sweep: '{key}' is no job: {e}")
    return {"measure": measure, **given}


def short(key):
    """What tells a key apart from one of usual values."""
    w = words(key)
    return " ".join([w.pop("measure")] + [f"{name}={value}" for name, value in w.items()
                                          if value != DEFAULTS[name]])
