#!/usr/bin/python3 -ES
# cores.py - parameters of a core from words: its profile, what it can do, its sizes, its name
# SPDX-License-Identifier: Apache-2.0
"""usage: sim/cores.py parameters LIST | --names [all|counted] | --help
       sim/cores.py profile PROFILE [name]
       sim/cores.py sizes LIST [name]
       sim/cores.py legal NAME=NUMBER...
       [ENGINES=n] [PIPES=n] [LEAF_UNITS=n] [SHADES=n] [ROOT_STEP=n] [QUOTIENT_STEP=n] \\
           [SIZES=list] sim/cores.py key PROFILE LIST [TARGET]

LIST: all, all-NAME (all but one), none, or words joined by +, the first of which may be all; words
are those of effects and parts in machine.def, with a count if most is above 1. all-NAME leaves out
what needs NAME too, and all+bih what does not go with a BIH. --names prints every such word, those
that the core `all` has, or those with a count; --table a line each: word, parameter, bit, most,
all, needs, excludes, meaning.
PROFILE: a name of machine.def, alone or with widths of its own, NAME:key=value,... (keys w, wd, pr,
pq, ng, fw), or the same as a part of a file name, NAME_keyVALUE_...
LIST of sizes: size=value,... (a `size` of machine.def in small letters), or as a part of a file
name, size1-size2; may be empty. What has a variable of make of its own is refused.
These print parameters of rtl/core/rt_core.v, NAME=VALUE, all on one line; with `name` the part of a
file name. The tool and rt_core check what goes together, these each by itself. `legal` says by the
rules of machine.def, `unit` and `legal`, what does not go together; what is not given has its
default, of the profile standard. `key` prints the name of a core, with every parameter that shapes
it, so that builds never mix; a core whose parameters do not go together has none. Sizes, units of
an engine and steps are in the name if they are not the core's own: 1 pipe, units by its rule (0),
steps of 2. Exit code 1, and why on stderr, if something is wrong."""
import os
import re
import sys

import definition
import variables
from words import Wrong, nearest

DEFINITION = definition.read()
# of make, with what rt_core has by itself, and the word for it in the name of a core
OWN = {"ENGINES": ("1", None), "PIPES": ("1", "pipes"), "LEAF_UNITS": ("0", "leaf_units"),
       "SHADES": ("0", "shades"), "ROOT_STEP": ("1", "root"), "QUOTIENT_STEP": ("2", "quotient")}


def meant(word, words):
    found = nearest(word, words)
    return f"is {found} meant?" if found else ""


def joined(values):
    return " ".join(f"{name}={number}" for name, number in values.items())


# ---- profiles ----
def profile(text):
    """{parameter: value} of its widths, and the words of its pace."""
    def wrong(why):
        return Wrong(f"profile {text}: {why}")
    name, *own = re.split("[:,_]", text)
    if name not in DEFINITION.profiles:
        said = meant(name, DEFINITION.profiles)
        raise wrong(f"{said + ' ' if said else ''}There are {' '.join(DEFINITION.profiles)}, "
                    "and each with widths of its own, NAME:key=value,...")
    widths, seen = dict(DEFINITION.profiles[name]), set()
    for word in own:
        key = word.rstrip("0123456789")
        number, key = word[len(key):], key.removesuffix("=")
        if not number:
            raise wrong(f'"{word}" is no key=value')
        if key not in widths:
            raise wrong(f'"{key}" is none of w, wd, pr, pq, ng and fw')
        if key in seen:
            raise wrong(f"{key} is given twice")
        seen.add(key)
        least, most = DEFINITION.bounds[key]
        if not least <= int(number) <= most + (key == "pr"):
            raise wrong(f"{key} is {int(number)}, not in {least}..{most}")
        widths[key] = int(number)
    if widths["pr"] == widths["w"] + widths["wd"]:
        widths["pr"] = 0
    as_it_is = all(widths[k] == DEFINITION.profiles[name][k] for k in ("w", "wd"))
    return {key.upper(): number for key, number in widths.items()}, \
        DEFINITION.paces.get(name, []) if as_it_is else []


def name_of_profile(text):
    profile(text)
    return re.sub("[:,]", "_", text).replace("=", "")


# ---- what a core can do ----
def counted(effect):
    return effect.name + (f"1..{effect.most}" if effect.most > 1 else "")


def unknown(word):
    effects = DEFINITION.effects
    said = meant(word.rstrip("0123456789"), effects)
    return Wrong(f"{word or '(nothing)'} names nothing that a core can be built with"
                 f"{'; ' + said if said else '.'} There are all, all-NAME, none, and names joined "
                 f"by + of {' '.join(map(counted, effects.values()))}")


def wanted(words):
    """{effect: count}"""
    found = {}
    for word in words:
        name = word.rstrip("0123456789")
        count, effect = word[len(name):], DEFINITION.effects.get(name)
        if not effect or not 1 <= int(count or 1) <= effect.most or (effect.most > 1 and not count):
            raise unknown(word)
        found[name] = int(count or 1)
    return found


def parameters(text):
    """{parameter: value} of a list of effects and parts."""
    effects = DEFINITION.effects
    but = text.removeprefix("all-") if text.startswith("all-") else ""
    if but and but not in effects:
        raise unknown(but)
    first, _, rest = ("all", "", "") if text.startswith("all-") else text.partition("+")
    whole = first == "all"
    rest = rest if whole else text
    given = wanted([] if rest == "none" or (whole and not rest) else rest.split("+"))
    value = dict.fromkeys(effects, 0)
    if whole:
        value = {name: 0 if name == but else e.all for name, e in effects.items()}
        for name in given:
            if effects[name].is_part:
                value.update(dict.fromkeys(effects[name].excludes, 0))
        gone = True
        while gone:     # what needs something that is not there
            gone = [n for n, e in effects.items() if value[n] and not all(map(value.get, e.needs))]
            value.update(dict.fromkeys(gone, 0))
    value.update(given)
    for name, effect in effects.items():
        if value[name] and not all(map(value.get, effect.needs)):
            raise Wrong(f"{text}: {name} needs {' and '.join(effect.needs)}")
        for other in reversed(effect.excludes if effect.is_part and value[name] else []):
            if value[other]:
                raise Wrong(f"{text}: {name} does not go with {other}")
    return {effect.core: value[name] for name, effect in effects.items()}


def list_words(which):
    return [name for name, e in DEFINITION.effects.items()
            if (e.all if which == "all" else e.most > 1 if which == "counted" else True)]


def told():
    return ["all, all-NAME (all but one), none, or words joined by +, with a count:"] + [
        f"  {counted(e):<16} {e.about}" + (f"; needs {' and '.join(e.needs)}" if e.needs else "")
        for e in DEFINITION.effects.values()]


# ---- sizes ----
def sizes(text):
    """{parameter: value}"""
    def wrong(why):
        return Wrong(f"sizes {text}: {why}")
    own = {name.lower(): name for name in variables.Table().rules}
    known = {name: size for name, size in DEFINITION.sizes.items() if name not in own}
    found = {}
    for word in re.split("[,-]", text) if text else ():
        match = re.fullmatch(r"([a-z_]+)=?([0-9]+)", word)
        if not match:
            raise wrong(f'"{word}" is no size=value')
        name, number = match[1], int(match[2])
        if name in own:
            raise wrong(f"{name} has the variable {own[name]}")
        if name not in known:
            said = meant(name, known)
            raise wrong(f'there is no "{name}"{"; " + said if said else ""} There are '
                        + " ".join(known))
        size = known[name]
        if size.name in found:
            raise wrong(f"{name} is given twice")
        if number < int(size.least) or (size.most.isdigit() and number > int(size.most)):
            raise wrong(f"{name} is {number}, not in {size.least}..{size.most}")
        if size.power and number & (number - 1):
            raise wrong(f"{name} is {number}, no power of two")
        found[size.name] = number
    return found


# ---- a core that goes together ----
def legal(given):
    """Raises what does not hold, with the values that it is about."""
    values = {key.upper(): n for key, n in DEFINITION.profiles["standard"].items()}
    values.update((e.core, e.all) for e in DEFINITION.effects.values())
    values.update((size.name, int(size.standard)) for size in DEFINITION.sizes.values())
    values.update(given)
    names = {}      # of a unit, the first parameter of its expression
    shown = {name: f"{name}={number}" for name, number in values.items()}
    for unit, expression in DEFINITION.units.items():
        name, *others = dict.fromkeys(re.findall("[A-Z][A-Z_]+", expression))
        names[unit] = name
        values[unit] = definition.value(expression, values)
        if not values[name]:
            shown[name] += f", which is {values[unit]} for " + \
                " ".join(shown[n] for n in others if n in given)
    bad = []
    for rule, expression in DEFINITION.rules.items():
        if not definition.value(expression, values):
            about = dict.fromkeys(names.get(n, n) for n in re.findall("[A-Z][A-Z_]*", expression))
            said = re.sub("([a-z0-9])_", r"\1 ", re.sub("_([a-z0-9])", r" \1", rule))
            bad.append(" ".join(shown[n] for n in about) + ": " + said)
    if bad:
        raise Wrong("\n".join(bad))


def paced(text):
    """{parameter: value} of a profile, its pace included."""
    widths, pace = profile(text)
    return widths | {name: int(number) for name, number in (word.split("=") for word in pace)}


def key(text, effects, target="", environment=os.environ):
    own = {name: environment.get(name) or usual for name, (usual, _) in OWN.items()}
    for name, number in own.items():
        if not number.isdecimal():
            raise Wrong(f"{name}={number} is no number", 2)
    other = sizes(environment.get("SIZES", ""))
    name = name_of_profile(text)
    legal(paced(text) | parameters(effects) | {n: int(v) for n, v in own.items()} | other)
    parts = [name] + [target] * bool(target) + [effects, f"engines{own['ENGINES']}"]
    parts += [word + own[n] for n, (usual, word) in OWN.items() if word and own[n] != usual]
    return "-".join(parts + [f"{n.lower()}{v}" for n, v in other.items()])


def main(command="", *words):
    first, more = (words + ("", ""))[:2]
    if command == "legal":
        for word in words:
            if not re.fullmatch("[A-Z][A-Z_]*=[0-9]+", word):
                raise Wrong(f"cores.py: {word} is no NAME=NUMBER", 2)
        return legal({n: int(v) for n, v in (word.split("=") for word in words)}) or ()
    if command == "key" and len(words) in (2, 3):
        return [key(*words)]
    if command == "sizes" and words:
        found = sizes(first)
        return ["-".join(f"{n.lower()}{v}" for n, v in found.items()) if more else joined(found)]
    if command == "profile" and words:
        widths, pace = profile(first)
        return [name_of_profile(first) if more else " ".join([joined(widths), *pace])]
    if command == "parameters" and words:
        listed = {"--names": lambda: list_words(more), "--help": told}
        return listed[first]() if first in listed else [joined(parameters(first))]
    raise Wrong(__doc__.partition("\n\n")[0])


if __name__ == "__main__":
    try:
        for printed in main(*sys.argv[1:]):
            print(printed)
    except Wrong as fault:
        print(fault, file=sys.stderr)
        sys.exit(fault.code)
