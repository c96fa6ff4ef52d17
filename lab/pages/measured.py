# measured.py - which run made each measured table of the pages: command, commit, day
# SPDX-License-Identifier: Apache-2.0
"""A measured table stands between `<!-- NAME -->` and `<!-- end -->` of a page, or in the page's
file of the folder `data` beside it (data.py). The record has a line for each: page, table, command,
the last commit that changed sources, its day, digest of the table. place.py alone writes such a
table and its line, at once, when a command has measured that table whole. A page says with the
region `measured PAGE` what the record has of it.

Whether sources have changed since is no matter of the pages: `make pages-age` tells it."""
import hashlib
import re
import subprocess
import textwrap
from collections import namedtuple
from itertools import groupby
from pathlib import Path

from .. import intact
from . import data

NAME = "docs/results/data/measured.tsv"
HEAD = ("# measured.tsv - which run made each table of the pages\n"
        "# SPDX-License-Identifier: Apache-2.0\n"
        "# page, table, command, commit, day, digest of the table; written by lab/pages/place.py\n")
Row = namedtuple("Row", "page table command commit day text")
TABLE = re.compile(r"<!-- (?!begin: |end |SPDX)([a-z0-9_]+) -->\n(.*?)<!-- end -->", re.S)
SOURCES = "rtl", "cmodel", "scenes"  # that a figure may depend on


def record_of(page):
    """The record of the tree that a page belongs to."""
    for folder in Path(page).parents:
        if folder.name == "docs":
            return folder.parent / NAME
    return Path(page).parent / Path(NAME).name


def tables(page):
    """{name: digest} of the measured tables of a page, those in the file beside it among them."""
    page = Path(page)
    texts = dict(TABLE.findall(page.read_text(encoding="utf-8")))
    texts.update(data.tables(page))
    return {name: hashlib.sha256(body.encode()).hexdigest()[:8] for name, body in texts.items()}


def rows(record=NAME):
    if not Path(record).exists():
        return []
    lines = Path(record).read_text(encoding="utf-8").splitlines()
    return [Row(*line.split("\t")) for line in lines if not line.startswith("#")]


def write(found, record=NAME):
    Path(record).parent.mkdir(parents=True, exist_ok=True)
    intact.write(record, HEAD + "".join("\t".join(row) + "\n" for row in sorted(found)))


def commit():
    """(commit, day) of the last change of sources; a + behind it if they differ from it."""
    def git(*words):
        ran = subprocess.run(["git", *words], check=False, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL)
        return ran.stdout.decode().strip()
    changed = git("status", "--porcelain", "-uno", "--", *SOURCES)
    head = git("log", "-1", "--format=%h %cs", "--", *SOURCES) or "unknown unknown"
    name, day = head.split()
    return name + ("+" if changed else ""), day


def stamp(page, command, names, rest=False):
    """Notes what `command` has just made: the tables of these names. rest: only some rows of them
    are new, so they stay as old as they were."""
    stem, now, record = Path(page).stem, commit(), record_of(page)
    texts = tables(page)
    found = {(row.page, row.table): row for row in rows(record)}
    for name in names:
        before = found.get((stem, name))
        found[stem, name] = before._replace(text=texts[name]) if rest and before else Row(
            stem, name, command, *now, texts[name])
    write(found.values(), record)


def prune(pages):
    """Forgets tables that are in no page any more."""
    there = {(page.stem, name) for page in pages for name in tables(page)}
    kept = [row for row in rows() if (row.page, row.table) in there]
    if len(kept) < len(rows()):
        write(kept)


def region(stem):
    """The runs that made the tables of a page: one line if it was one run, else one for each."""
    def run(row):
        return row.command, row.day, row.commit
    runs = [(key, [row.table for row in some]) for key, some in groupby(
        sorted((row for row in rows() if row.page == stem), key=run), run)]
    lines = []
    for (command, day, at), names in runs:
        of = f"`{command}` at commit {at} of {day}"
        lines.append(f"Measured by {of}." if len(runs) == 1 else
                     f"- {', '.join(f'*{name}*' for name in names)}: {of}")
    return "\n".join(textwrap.fill(line, 100, subsequent_indent="  " * (len(runs) > 1),
                                   break_on_hyphens=False) for line in lines)


def wrong(pages):
    """What does not agree between pages and record."""
    record = {(row.page, row.table): row for row in rows()}
    stamped = {row.page for row in rows()}
    for page in pages:
        for name, text in tables(page).items():
            row = record.pop((page.stem, name), None)
            if row is None:
                yield f"{page}: nothing says when the table {name} was measured"
            elif row.text != text:
                yield f"{page}: the table {name} is not the one that `{row.command}` made"
        mark = f"<!-- begin: measured {page.stem} -->"
        if page.stem in stamped and mark not in page.read_text(encoding="utf-8"):
            yield f"{page}: has measured tables and does not tell their runs"
    for page, name in record:
        yield f"{NAME}: there is no table {name} in {page}.md"
