# pairs.py - pairs of parameters of rt_core: each is refused by name, or elaborates
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 tests/core/pairs.py [all]
Prints TAP. sim/cores.py, which make and synthesis ask, has to say of every set of parameters what
the elaboration by Icarus says: the same rules, or nothing. Units of an engine are tried with all
their values. Of other sizes every pair of ends, least or most, is in one of eight whole cores: the
end of a size in core n is bit n of a word of its own, of eight bits, four of them set, the first
always; of two such words there are all four pairs of bits. The cores have different profiles and
trees in turn; all: each has each."""
import itertools
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDERS = sorted({str(path.parent) for path in Path("rtl").rglob("*.v*")})
CORE = next(str(path) for path in Path("rtl").rglob("rt_core.v"))
RULE = re.compile(r"\brt_[a-z0-9_]*?_([A-Z0-9][A-Za-z0-9_]*_(?:must|needs|excludes)_\w+)")
WIDE = 8        # cores with all pairs of ends


def said(*words):
    return subprocess.run(words, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)


def words(*command):
    return said("sim/cores.py", *command).stdout.split()


def legal(parameters):
    """The rules that do not hold, as sim/cores.py says."""
    ran = said("sim/cores.py", "legal", *parameters)
    rules = {line.split(": ", 1)[1].replace(" ", "_") for line in ran.stdout.splitlines()}
    assert (ran.returncode != 0) == bool(rules), ran.stdout
    return rules


def elaborated(parameters, whole):
    """The same, as Icarus finds modules missing that have the name of a rule; what else it says."""
    ran = said("iverilog", "-g2005", "-t", "null", *(f"-I{d}" for d in FOLDERS),
               *(f"-y{d}" for d in FOLDERS if whole), *(f"-Prt_core.{p}" for p in parameters), "-s",
               "rt_core", CORE)
    return set(RULE.findall(ran.stdout)), ran.stdout if whole else ""


def differs(case):
    """What is wrong with one set of parameters, or nothing."""
    parameters, whole = case
    refused = legal(parameters)
    rules, rest = elaborated(parameters, whole)
    if whole and refused:
        rules &= refused    # deeper modules may have rules of their own
    if rules != refused or (whole and not refused and rest):
        return f"{' '.join(parameters)}: refused for {sorted(refused)}, elaborated: " \
               f"{sorted(rules) or rest[:500]}"
    return None


def sizes():
    """[(name, least, most)] of machine.def."""
    lines = Path("cmodel/machine/machine.def").read_text(encoding="utf-8").splitlines()
    return [(f[1], f[3], f[4]) for f in map(str.split, lines) if f[:1] == ["size"]]


def number(text, parameters):
    """An end of a size, which may be a sum of widths."""
    values = dict(p.split("=") for p in parameters)
    return sum(int(values.get(part, part)) for part in text.split("+"))


UNITS = ("ENGINES", "PIPES", "LEAF_UNITS", "SHADES", "SETUPS")
EFFECTS = words("parameters", "+".join(
    word for word in words("parameters", "--names")
    if word not in ("first", "interpenetrate", "bih", "boxes", *words(
        "parameters", "--names", "counted")))) + ["REFLECT=2", "LIGHTS=8", "CONES=1"]


def units():
    """All units of an engine; INTERPENETRATE allows one shading unit."""
    for pipes, leaves, shades in itertools.product(range(1, 5), range(5), range(5)):
        given = [f"PIPES={pipes}", f"LEAF_UNITS={leaves}", f"SHADES={shades}"]
        yield [*given, "INTERPENETRATE=0"], False
        if leaves in (0, 2):
            yield given, False
            yield [*given, "INTERPENETRATE=0", "SETUPS=2"], False
            yield [*given, "INTERPENETRATE=0", "FIRST=0", "BOXES=1"], False
    for engines, pipes in itertools.product(range(1, 9), range(1, 5)):
        yield [f"ENGINES={engines}", f"PIPES={pipes}"], False


def textures():
    for lines, ways, group, on in itertools.product((8, 64, 4096), (1, 32), (1, 4), (0, 1)):
        yield [f"TEXTURE_LINES={lines}", f"TEXTURE_WAYS={ways}", f"TEXTURE_GROUP={group}",
               f"TEXTURE={on}"], on == 1


def between():
    """Values between the ends of which only some are legal."""
    for name, values in (("HIT_INTERVAL", range(8, 13)), ("BOUNCE_INTERVAL", range(10, 13)),
                         ("MEM_PENDING", (0, 1, 8, 16, 64))):
        for value in values:
            yield [f"{name}={value}"], True


def ends(everything):
    names = [size for size in sizes() if size[0] not in UNITS]
    codes = [1 + sum(2 << bit for bit in bits)
             for bits in itertools.combinations(range(WIDE - 1), 3)]
    assert len(names) <= len(codes)
    profiles, trees = ("draft", "standard", "fine", "reference"), ([], ["BOXES=1"], ["ACCEL=1"])
    some = list(itertools.product(profiles, trees))
    for row in range(WIDE):
        for profile, tree in some if everything else [(profiles[row % 4], trees[row % 3])]:
            widths = words("profile", profile)
            given = [f"{name}={number((least, most)[code >> row & 1], widths)}"
                     for code, (name, least, most) in zip(codes, names)]
            # textures: the pair is one of its own, above
            given = [g for g in given if not g.startswith("TEXTURE_LINES")]
            yield [*widths, *EFFECTS, *tree, "PIPES=4", "LEAF_UNITS=2", "SHADES=4",
                   "TEXTURE_LINES=4096", *given], True


def main(everything):
    kinds = {"units of an engine, and engines": units(), "lines of the cache of texels": textures(),
             "clocks that are one or the other": between(),
             "every pair of ends of sizes, in whole cores": ends(everything)}
    with ThreadPoolExecutor(2) as pool:
        for index, (name, cases) in enumerate(kinds.items(), 1):
            cases = list(cases)
            found = [text for text in pool.map(differs, cases) if text]
            print(f"{'not ok' if found else 'ok'} {index} - {name}: {len(cases)}", flush=True)
            for text in found[:8]:
                print("# " + text.replace("\n", "\n# "))
    print(f"1..{len(kinds)}")


main(sys.argv[1:] == ["all"])
