# fill.py - brings pages up to date with the sources, or says which are not
# SPDX-License-Identifier: Apache-2.0
"""Fills the regions of the pages: README.md and all of docs/ if none is named. --check writes
nothing, shows the lines that differ, and exits with 1 if there are any."""
import difflib
import sys
from pathlib import Path

from .. import intact
from . import markdown, measured, regions, verilog


def fresh(page):
    """(as it stands, as it ought to be)"""
    text = page.read_text(encoding="utf-8")
    opened, closed = text.count("<!-- begin: "), len(markdown.names(text))
    if opened != closed:
        raise regions.Unknown(f"{opened} regions begin and {closed} end")
    return text, markdown.fill(text, regions.make)


def main(*names, check=False):
    stale = bad = 0
    if not check:
        measured.prune(markdown.pages())
    for fault in measured.wrong(markdown.pages()) if check else ():
        print(fault, file=sys.stderr)
        bad += 1
    for page in [Path(name) for name in names] or markdown.pages():
        try:
            now, wanted = fresh(page)
        except (regions.Unknown, verilog.Bad) as fault:
            print(f"{page}: {fault}", file=sys.stderr)
            bad += 1
            continue
        if now == wanted:
            continue
        stale += 1
        if check:
            lines = difflib.unified_diff(now.splitlines(), wanted.splitlines(), str(page),
                                         "as the sources have it", n=0, lineterm="")
            print("\n".join(lines))
        else:
            intact.write(page, wanted)
            print(f"  PAGE {page}")
    if check and stale:
        print(f"{stale} pages do not tell what the sources say: make pages")
    sys.exit(bool(bad or check and stale))
