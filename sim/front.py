#!/usr/bin/python3 -ES
# front.py - what is given to make, before anything is made: values, goals, suites; and its help
# SPDX-License-Identifier: Apache-2.0
"""usage: NAME=value ... sim/front.py values GIVEN GOALS NAME...
       sim/front.py goals GOALS MAKEFILE...
       sim/front.py suites ONLY SUITE...
       NAME=value ... sim/front.py help USUAL MAKEFILE...

values: says on stderr what is wrong with the values of the NAMEs in the environment, by the rules
of make/variables.mk, and which of GIVEN, names of a command line, make does not know; with the
nearest right word. What GOALS need has to be there: simulator, Yosys, gnuplot.
goals: says which of GOALS are no target of the MAKEFILEs; one with a slash is a file, which make
looks for itself.
suites: says that no SUITE has ONLY in its name, and which one may be meant.
help: targets, `target: ... ## text` in MAKEFILEs and the experiments of lab/table.py, and variables
with their values. USUAL: names that are printed; empty: all, with all that is said of a variable.
GIVEN, GOALS and USUAL are words of one argument. Exit code 2 if anything is wrong."""
import os
import re
import sys

import variables
from words import Wrong, nearest, perhaps

PROGRAMS = {"icarus": "iverilog", "cxxrtl": "yosys", "ecp5": "yosys", "xc7": "yosys",
            "silicon": "yosys"}

NEEDS = {"synth": "yosys", "price": "gnuplot"}


# ---- kinds of values: "" if one fits, else what is wrong ----
def window(value):
    if not re.fullmatch("[0-9]+,[0-9]+,[0-9]+,[0-9]+", value):
        return "is no window such as 0,0,16,9: left, top, right and bottom, the last two outside"
    left, top, right, bottom = map(int, value.split(","))
    size = os.environ.get("SIZE", "")
    sides = re.fullmatch("([0-9]+)x([0-9]+)", size)
    if sides and (right > int(sides[1]) or bottom > int(sides[2])):
        return f"is not inside SIZE={size}"
    return "has no pixel" if left >= right or top >= bottom else ""


def pixel(value):
    if not re.fullmatch("[0-9]+,[0-9]+", value):
        return "is no pixel such as 21,9"
    size, samples = os.environ.get("SIZE", ""), os.environ.get("SAMPLES", "") or "1"
    sides = re.fullmatch("([0-9]+)x([0-9]+)", size)
    outside = sides and any(int(at) >= int(side) for at, side in zip(value.split(","),
                                                                     sides.groups()))
    if outside and samples in ("0", "1"):
        return f"is not inside SIZE={size}"
    of = os.environ.get("WINDOW", "")
    if samples.isdecimal() and of and not window(of):
        left, top, right, bottom = (int(side) * max(1, int(samples)) for side in of.split(","))
        x, y = map(int, value.split(","))
        if not (left <= x < right and top <= y < bottom):
            return f"is not inside WINDOW={of}"
    return ""


def size_of(value):
    import cores
    most = cores.DEFINITION.constants["MAX_SIDE"]
    sides = re.fullmatch("([0-9]+)x([0-9]+)", value)
    fits = sides and all(1 <= int(side) <= most for side in sides.groups())
    return "" if fits else f"is no size such as 640x360, up to {most}x{most}"


def error(value):
    fits = re.fullmatch("([0-9]*[.]?[0-9]+)(?:,([0-9]*[.]?[0-9]+))?", value)
    fits = fits and 1e-9 <= float(fits[1]) <= 1e9 and float(fits[2] or 0) <= 99
    return "" if fits else "is no error such as 0.125 or 0.125,45: pixels, and dB up to 99"


def words(value):
    """Nothing in it means anything to make or a shell."""
    found = re.search(r"""['"`\\;&|<>(){}*?!#]""", value) or re.search(r"\[|\]|^~", value)
    link = "; a link to it may have a plain name" if "/" in value else ""
    return f"has a {found[0]}{link}" if found else ""


def word(value):
    link = "; a link to it may have a plain name" if "/" in value else ""
    return f"has a blank{link}" if re.search("[ \t]", value) else words(value)


def by(module, function):
    """What a function of a module, which takes a moment, says against the value."""
    def says(value):
        try:
            getattr(__import__(module), function)(value)
        except Wrong as fault:
            return str(fault)
        return ""
    return says


KINDS = {"<text>": lambda value: "", "<word>": word, "<words>": words, "<size>": size_of,
         "<error>": error, "<window>": window, "<pixel>": pixel,
         "<profile>": by("cores", "profile"),
         "<effects>": by("cores", "parameters"), "<sizes>": by("cores", "sizes"),
         "<scene>": by("scene", "find")}


# ---- values ----
def fits(one, value, constants):
    """(whether one alternative of a rule takes the value, what is wrong if it says so)"""
    least, dots, most = one.partition("..")
    if dots:
        top = variables.bound(most, constants)
        return bool(re.fullmatch("[0-9]{1,15}", value)) and int(value) >= int(least) and \
            (top is None or int(value) <= top), ""
    if one.startswith("<") and value != "":
        wrong = KINDS[one](value)
        return not wrong, wrong
    return one == value and not one.startswith("<"), ""


def wrong_value(name, rule, constants):
    """What is wrong with a variable's value; "" if nothing is."""
    value, reason = os.environ.get(name, ""), ""
    if value == "" and rule.endswith("|"):
        return ""
    for one in rule.split("|"):
        good, why = fits(one, value, constants)
        if good:
            return ""
        reason = reason or why
    text, choice = variables.spoken(rule, constants)
    if value == "":
        reason = "is empty" + (f"; there is {text}" if text else "")
    elif not reason:
        reason = ("is none of " if "," in text else "is not ") + text
    elif text:
        reason += f"; nor is it {text}"
    return f"{name}={value}: {reason}{perhaps(value, choice)}"


def unknown_names(given, known):
    return [f"there is no variable {name}{perhaps(name, known, '.')} `make help-all` prints them"
            for name in given if name not in known]


def is_there(program):
    return any(os.access(os.path.join(folder, program), os.X_OK)
               for folder in os.environ.get("PATH", "").split(":"))


def values(given, goals, *names):
    import cores
    rules, goals = variables.Table().rules, goals.split()
    profile = os.environ.get("PROFILE") or "all"
    if profile in ("all", "auto"):   # what all have is what the narrowest has
        profile = "draft"
    constants = dict(cores.DEFINITION.constants)
    try:
        constants.update(cores.paced(profile))
    except Wrong:
        pass
    said = unknown_names(given.split(), list(rules))
    said += filter(None, (wrong_value(name, variables.for_goals(rules[name], goals), constants)
                          for name in names))
    if said:
        raise Wrong("\n".join(said), 2)
    # what shapes a core, as far as it is known without its machine
    if {"PROFILE", "EFFECTS", "SIZES", *cores.OWN} & set(names):
        effects = os.environ.get("EFFECTS") or "auto"
        cores.key(profile, "none" if effects == "auto" else effects)
    if "setup" in goals:
        return
    simulator = os.environ.get("SIM", "")
    program = PROGRAMS.get(simulator, simulator)
    if "sim" in goals and not is_there(program):
        needs = "synth" if program == "yosys" else "sim"
        raise Wrong(f"SIM={simulator}: this simulator is not installed: make setup {needs}")
    for goal in set(NEEDS).intersection(goals):
        if not is_there(NEEDS[goal]) and not (goal == "synth" and os.environ.get("YOSYS")):
            raise Wrong(f"{NEEDS[goal]} is not installed: make setup {goal}")


# ---- goals and suites ----
def experiments():
    sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
    from lab import table
    return {row.name: row.text for row in table.EXPERIMENTS}


def text_of(name):
    with open(name, encoding="utf-8") as f:
        return f.read()


def targets(makefiles):
    """Words that stand as a target, or behind .PHONY."""
    found = dict.fromkeys(experiments())
    for name in makefiles:
        text = text_of(name).replace("\\\n", "")
        for left, right in re.findall(r"^([^\t=#:\n][^=#:\n]*)::?(?!=)([^\n;#|]*)", text, re.M):
            found.update(dict.fromkeys((right if left == ".PHONY" else left).split()))
    return [word for word in found if re.fullmatch("[a-z][a-z0-9_-]*", word)]


def goals(asked, *makefiles):
    there = targets(makefiles)
    said = [f"there is no target {goal}{perhaps(goal, there, '.')} `make help-all` prints them"
            for goal in asked.split() if goal not in there and goal != "FORCE" and "/" not in goal]
    if said:
        raise Wrong("\n".join(said), 2)


def suites(only, *names):
    """People leave out endings, and test_ before the name."""
    whole, short = {}, {}
    for name in names:
        whole.setdefault(name if "." in only else name.partition(".")[0], name)
        short.setdefault(name.removeprefix("test_").partition(".")[0], name)
    meant = whole.get(nearest(only, list(whole))) or short.get(nearest(only, list(short)))
    raise Wrong(f"ONLY={only}: no suite has this in its name" + (
        f"; is {meant} meant?" if meant else "; `ls tests/*/test_*` shows them"), 1)


# ---- help ----
def folded(text):
    """Pieces of at most 66 columns."""
    pieces = []
    while len(text) > 66:
        cut = text.rfind(" ", 0, 66)
        pieces.append(text[:cut])
        text = text[cut + 1:]
    return pieces + [text]


def help_of_targets(makefiles):
    for name in makefiles:
        for line in text_of(name).splitlines():
            match = re.match(r"([a-z][a-z-]*):(?=[^=]).*## (.*)", line)
            if match:
                yield match.groups()
            elif line.startswith("EXPERIMENTS :="):
                yield from experiments().items()


def help_of_variables(usual):
    import cores
    table, effects = variables.Table(), cores.DEFINITION.effects.values()
    everything = " ".join(e.name + ("N" if e.most > 1 else "") for e in effects)
    rest = " ".join(e.name for e in effects if not e.all)
    for name, (text, *more) in table.texts.items():
        if usual and name not in usual:
            continue
        rule, _ = variables.spoken(table.rules[name], cores.DEFINITION.constants)
        said = folded(": ".join(filter(None, (rule, text))))
        for line in () if usual else more:
            said += folded(line.replace("{words}", everything).replace("{not in all}", rest))
        yield f"  {name:<14} {os.environ.get(name, ''):<12} {said[0]}"
        yield from (f"  {'':<14} {'':<12} {line}" for line in said[1:])


def help_all(usual, *makefiles):
    usual = usual.split()
    print("Sphaera: a ray tracer in hardware, for spheres, triangles and planes\n\n"
          "make TARGET [VARIABLE=value ...]\n")
    for name, text in help_of_targets(makefiles):
        if not usual or name in usual:
            print(f"  {name:<12} {text}")
    print("", *help_of_variables(usual), sep="\n")


if __name__ == "__main__":
    for stream in sys.stdout, sys.stderr:
        stream.reconfigure(errors="surrogateescape")
    try:
        {"values": values, "goals": goals, "suites": suites, "help": help_all}[sys.argv[1]](
            *sys.argv[2:])
    except Wrong as fault:
        print(fault, file=sys.stderr)
        sys.exit(2)
