#!/usr/bin/python3 -ES
# scene.py - the scene that somebody means
# SPDX-License-Identifier: Apache-2.0
"""usage: [FROM=folder] sim/scene.py NAME
NAME is a file, from the folder FROM if it is relative; the name of a file in scenes/ without .nff;
or KIND:N of `sphaera gen`. Prints the file, by its path from the root of the tree if it lies below,
or KIND:N; else says what there is, and ends with 2."""
import os
import re
import sys
from pathlib import Path

from words import Wrong, lines, perhaps

ROOT = Path(__file__).resolve().parent.parent


def kinds():
    text = (ROOT / "cmodel/scene/generate.c").read_text(encoding="utf-8")
    return re.findall(r'^    {"([a-z0-9_]*)", .*, SPH_TAKES_(?!NOTHING)', text, re.M)


def find(name):
    for path in Path(os.environ.get("FROM") or ROOT, name), ROOT / "scenes" / (name + ".nff"):
        if path.is_file():
            path = path.parent.resolve() / path.name
            return str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)
    # Which number a kind takes, says the tool (sph_generate_parse() of the model); here digits are
    # part of a name.
    kind, colon, number = name.partition(":")
    if colon and re.fullmatch("[0-9]+", number) and kind in kinds():
        return name
    there = sorted(str(path.relative_to(ROOT / "scenes").with_suffix(""))
                   for path in ROOT.glob("scenes/**/*.nff")) + [f"{kind}:N" for kind in kinds()]
    raise Wrong(lines("is no file, and no scene" + perhaps(name, there, ".") + " There are", there),
                2)


if __name__ == "__main__":
    try:
        print(find(sys.argv[1]))
    except Wrong as fault:
        print(fault, file=sys.stderr)
        sys.exit(fault.code)
