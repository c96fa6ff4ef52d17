# plan.py - which bench tries the faults of a module, and how many each module gets
# SPDX-License-Identifier: Apache-2.0
"""A module is tried in a bench of its own, else in the smallest one that has it, else in the core,
else in rt_top around the golden model.
A job is one program with the faults of all modules that have their home in it."""
import glob
import hashlib
import json
import os
import re

from ... import intact
from ...jobs import store
from . import benches

SOURCES = ["rtl/*/*.v", "rtl/*/*.vh", "tb/benches*", "lab/faults/drawn/plan.py", "tool:yosys"]
LEAST = 8     # faults of the smallest module
MOST = 90     # of the largest
LINES = 160   # of a module's lines that count: a table in a ROM is longer, and is one operator
ROUNDS = 4    # benches that a fault meets: its home, another line of its bench, one above, the core


def modules():
    """{module: lines of code} of all that the lists of benches or the core can have."""
    found = {}
    for name in sorted(glob.glob("rtl/*/*.v")):
        with open(name, encoding="utf-8") as f:
            code = [line for line in f if line.strip() and not line.lstrip().startswith("//")]
        found[os.path.basename(name)[:-2]] = min(len(code), LINES)
    return found


def parents():
    """{module: modules whose source names it}"""
    names = {os.path.basename(n)[:-2] for n in glob.glob("rtl/*/*.v")}
    found = {name: set() for name in names}
    for file in glob.glob("rtl/*/*.v"):
        with open(file, encoding="utf-8") as f:
            text = re.sub(r"//.*", "", f.read())
        for name in set(re.findall(r"\brt_[a-z0-9_]+\b(?!\.vh)", text)) & names:
            found[name].add(os.path.basename(file)[:-2])
    return found


def homes(build):
    """{bench: modules with their home in it, in the order of the lists}"""
    cache, digest = f"{build}/mutants/homes.json", store.digest(SOURCES)
    if os.path.exists(cache):
        with open(cache, encoding="utf-8") as f:
            kept = json.load(f)
        if kept["digest"] == digest:
            return kept["homes"]
    lists = benches.every(build)
    tops = {}
    for bench in lists:
        tops.setdefault(bench.top, []).append(bench)
    inside, above = {}, parents()

    def look(bench):
        if bench.name not in inside:
            made = bench.netlist()
            inside[bench.name] = sum(made.size.values()), sorted(made.variants)

    first = [found[0] for found in tops.values()]
    for bench in first:
        look(bench)
    left = [m for m in modules() if m not in tops]
    for module in left:
        if any(module in has for _, has in inside.values()):
            continue
        line = {module}         # this module and all above it
        while (more := line.union(*(above[m] for m in line))) != line:
            line = more
        for bench in [b for b in lists if b.top in line]:
            look(bench)
            if module in inside[bench.name][1]:
                break
    result = {bench.name: [bench.top] for bench in first}
    for module in left:
        sizes = [(size, name) for name, (size, has) in inside.items() if module in has]
        if sizes:
            result.setdefault(min(sizes)[1], []).append(module)
    for bench in benches.wholes(build):
        look(bench)
        rest = [m for m in left if m in inside[bench.name][1]
                and not any(m in has for has in result.values())]
        if rest:
            result[bench.name] = rest
    os.makedirs(os.path.dirname(cache), exist_ok=True)
    intact.write(cache, json.dumps({"digest": digest, "homes": result}, indent=1))
    return result


def counts(total, build):
    """{bench: {module: faults}}, by the lines of the modules."""
    found, lines = homes(build), modules()
    every = sum(lines[m] for has in found.values() for m in has)
    return {bench: {m: min(MOST, max(LEAST, round(total * lines[m] / every))) for m in has}
            for bench, has in found.items()}


def name(faults):
    return hashlib.sha256(repr(sorted(map(tuple, faults))).encode()).hexdigest()[:12]


def next_benches(build, number, tried):
    """{bench: faults}: where those that nothing noticed so far are tried in a later round: another
    line of their home's bench, the smallest bench of a module above, the core."""
    lists, groups = benches.every(build), {}
    by_name = {bench.name: bench for bench in lists}
    above = parents()
    for fault, rounds in tried.items():
        if rounds[-1][1] != "survived":
            continue
        met = [bench for bench, _, _ in rounds]
        if number == ROUNDS - 1:
            options = [f"core/{effects}" for effects in benches.CORES]
        else:
            top = by_name[met[0]].top if met[0] in by_name else ""
            wanted = {top} if number == 1 else above.get(top, set())
            options = [b.name for b in lists if b.top in wanted and b.name not in met]
            options = options[-1:] if number == 1 else options[:1]
        if options and options[0] not in met:
            groups.setdefault(options[0], []).append(fault)
    return {bench: sorted(faults) for bench, faults in groups.items()}
