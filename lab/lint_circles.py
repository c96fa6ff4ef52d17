#!/usr/bin/env python3
# lint_circles.py - no two C files need each other, by what they call or by what they include
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.lint_circles OBJECT...
Objects as the build leaves them, OBJ/cmodel/FOLDER/FILE.o. An object that uses a symbol of another
one needs it; a header that includes another one needs it. Prints each circle; 1 if there is one."""
import re
import subprocess
import sys
from pathlib import Path

DEFINED = "TDBRVWC"
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
    """{header: the headers that it includes}"""
    headers = {str(h.relative_to(folder)): h for h in folder.rglob("*.h")}
    return {name: set(INCLUDE.findall(path.read_text(encoding="utf-8"))) & set(headers)
            for name, path in headers.items()}


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


def main():
    found = circles(calls(sys.argv[1:])) + circles(includes(Path("cmodel")))
    for circle in found:
        print("a circle: " + ", ".join(re.sub(r".*/cmodel/|\.o$", "", name) for name in circle))
    return bool(found)


sys.exit(main())
