# lint_layers.py - the folders of cmodel are layers, and no two C files need each other
# SPDX-License-Identifier: Apache-2.0
"""Objects as the build leaves them, OBJ/cmodel/FOLDER/FILE.o. An object that uses a symbol of
another one needs it; a file that includes a header needs it. Prints what needs something of a layer
that is not below its own, and each circle of files; 1 if there is one."""
import re
import subprocess
from pathlib import Path

# From the ground up; those on one line stand beside one another, and neither needs the other.
LAYERS = """
common driver            errors, files; what a host does (driver/ beside cmodel/)
machine                  number formats, registers, records, the machine file
math                     the arithmetic that model and RTL share
core                     what passes between stages: rays, hits, pixels, counters
texture
shade
prim
trace
pixel memory
engine build             the golden model ends here: one pixel, literally
fast validate scene      its fast twin; is a machine sound; scene files
reference render         the scene in double precision; whole frames
builder                  scene to machine
naive image trial        a second model, of unbounded integers; pictures; machines on trial
sphaera view             the library's face; the live view
tool
"""
RANK = {name: rank for rank, line in enumerate(LAYERS.strip().splitlines())
        for name in line[:25].split()}
DEFINED = "TDBRVWC"
KINDS = (".h", ".c", ".cpp")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)


def calls(objects):
    """{object: the objects that define what it uses}"""
    listed = subprocess.run(["nm", "-P", *objects], check=True, text=True, stdout=subprocess.PIPE)
    at, where, used = objects[0], {}, {name: set() for name in objects}
    for line in listed.stdout.splitlines():
        if line.endswith(":"):
            at = line[:-1]
            continue
        symbol, kind = line.split()[:2]
        if kind in DEFINED:
            where[symbol] = at
        elif kind == "U":
            used[at].add(symbol)
    return {name: {where[s] for s in symbols if s in where} - {name}
            for name, symbols in used.items()}


def includes(folder):
    """{file: the headers of the folder that it includes}"""
    files = {str(f.relative_to(folder)): f for f in folder.rglob("*") if f.suffix in KINDS}
    return {name: set(INCLUDE.findall(path.read_text(encoding="utf-8"))) & set(files)
            for name, path in files.items()}


def circles(needs):
    """Sets of more than one that reach each other."""
    def reach(start):
        seen, todo = set(), [start]
        while todo:
            for other in needs[todo.pop()] - seen:
                seen.add(other)
                todo.append(other)
        return seen
    reached = {name: reach(name) for name in needs}
    found = {frozenset({name} | {o for o in reached[name] if name in reached[o]})
             for name in needs if name in reached[name]}
    return sorted(sorted(circle) for circle in found)


def upward(needs):
    """(file, what it needs) where that is in no layer below its own."""
    for name, others in needs.items():
        for other in others:
            a, b = (re.sub(r".*(cmodel|obj)/", "", n).split("/")[0] for n in (name, other))
            if a != b and RANK.get(b, 99) >= RANK.get(a, 99):
                yield name, other


def main(*objects):
    called, included = calls(objects), includes(Path("cmodel"))
    wrong = sorted(set(upward(called)) | set(upward(included)))
    for name, other in wrong:
        print(f"not in a layer below: {name} needs {other}")
    found = circles(called) + circles(included)
    for circle in found:
        print("a circle: " + ", ".join(re.sub(r".*/cmodel/|\.o$", "", name) for name in circle))
    return bool(wrong or found)
