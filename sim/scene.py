#!/usr/bin/python3 -ES
# scene.py - the scene that somebody means
# SPDX-License-Identifier: Apache-2.0
"""usage: [FROM=folder] sim/scene.py NAME
NAME is a file, from the folder FROM if it is relative; the name of a file in scenes/ without .nff;
FILE:SECTION, one of several scenes of a file, by both; FOLDER/SECTION of FOLDER/FOLDER.nff in
scenes/; or KIND:N of `sphaera gen`. Prints FILE or FILE:SECTION, by its path from the root of the
tree if it lies below, or KIND:N; else says what there is, and ends with 2."""
import os
import re
import sys
from pathlib import Path

from words import Wrong, lines, perhaps

ROOT = Path(__file__).resolve().parent.parent


def kinds():
    text = (ROOT / "cmodel/scene/generate.c").read_text(encoding="utf-8")
    return re.findall(r'^    {"([a-z0-9_]*)", .*, SPH_TAKES_(?!NOTHING)', text, re.M)


def sections(path):
    """Names of the scenes of a file; none if it is one scene."""
    text = path.read_text(encoding="utf-8", errors="replace")
    return re.findall(r"^scene[ \t]+(\S+)", text, re.M)


def shelf(folder):
    """The file of a folder below scenes/ that has scenes of its own names."""
    return folder / (folder.name + ".nff")


def find(name):
    at = Path(os.environ.get("FROM") or ROOT, name)
    file, _, section = at.name.rpartition(":")
    there = ROOT / "scenes" / name
    for path, part in ((at, ""), (at.with_name(file) if file else at, section),
                       (there.with_name(there.name + ".nff"), ""),
                       (shelf(there.parent), there.name)):
        if path.is_file() and (not part or part in sections(path)):
            path = path.parent.resolve() / path.name
            path = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
            return f"{path}:{part}" if part else str(path)
    # Which number a kind takes, says the tool (sph_generate_parse() of the model); here digits are
    # part of a name.
    kind, colon, number = name.partition(":")
    if colon and re.fullmatch("[0-9]+", number) and kind in kinds():
        return name
    found = [(path.relative_to(ROOT / "scenes"), sections(path))
             for path in ROOT.glob("scenes/**/*.nff")]
    there = sorted(str(word) for path, parts in found
                   for word in ([path.parent / part for part in parts] or [path.with_suffix("")]))
    there += [f"{kind}:N" for kind in kinds()]
    raise Wrong(lines("is no file, and no scene" + perhaps(name, there, ".") + " There are", there),
                2)


if __name__ == "__main__":
    try:
        print(find(sys.argv[1]))
    except Wrong as fault:
        print(fault, file=sys.stderr)
        sys.exit(fault.code)
