# measured.py - tables that an experiment has put into a page: when, of which sources, untouched?
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.measured PAGE COMMAND [TABLE...]
Notes that COMMAND has just made its tables of PAGE, or those that are named, and brings the page's
own words up to date.

Such a table stands between `<!-- NAME -->` and `<!-- end -->`. The record has a line for each:
page, table, command, kinds of sources (digest.py), their digest, commit, day, digest of the table.
An experiment of minutes or hours is not run again for every change; its page says how old it is.
A command of a test, which compares the table itself, has dashes."""
import hashlib
import re
import subprocess
import sys
import textwrap
from collections import namedtuple
from itertools import groupby
from pathlib import Path

from .. import intact
from . import digest

RECORD = Path("docs/results/data/measured.tsv")
HEAD = ("# measured.tsv - when the tables of the pages were measured, and of which sources\n"
        "# SPDX-License-Identifier: Apache-2.0\n"
        "# written by lab/pages/measured.py\n")
Row = namedtuple("Row", "page table command kinds sources commit day text")
TABLE = re.compile(r"<!-- (?!begin: |end |SPDX)([a-z0-9_]+) -->\n(.*?)<!-- end -->", re.S)
NAMES = {"rtl": "RTL", "model": "model", "scenes": "scenes"}


def tables(page):
    """{name: digest} of the measured tables of a page, those in files beside it among them."""
    page = Path(page)
    texts = dict(TABLE.findall(page.read_text(encoding="utf-8")))
    for path in (page.parent / "data").glob(f"{page.stem}.*.tsv"):
        texts[path.name.split(".")[1]] = path.read_text(encoding="utf-8")
    return {name: hashlib.sha256(body.encode()).hexdigest()[:8] for name, body in texts.items()}


def rows():
    if not RECORD.exists():
        return []
    lines = RECORD.read_text(encoding="utf-8").splitlines()
    return [Row(*line.split("\t")) for line in lines if not line.startswith("#")]


def write(found):
    RECORD.parent.mkdir(parents=True, exist_ok=True)
    intact.write(RECORD, HEAD + "".join("\t".join(row) + "\n" for row in sorted(found)))


def commit():
    """(commit, day) of the tree; a + behind it if something differs from that commit."""
    def git(*words):
        ran = subprocess.run(["git", *words], check=False, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL)
        return ran.stdout.decode().strip()
    changed = git("status", "--porcelain", "-uno", "--", "rtl", "cmodel", "scenes")
    head = git("log", "-1", "--format=%h %cs") or "unknown unknown"
    name, day = head.split()
    return name + ("+" if changed else ""), day


def stamp(page, command, *only):
    """Notes that the tables of a command are of now, or those that are named, and those
    that nobody knew of."""
    stem, now, found = Path(page).stem, commit(), rows()
    texts = tables(page)
    known = {row.table for row in found if row.page == stem}
    found += [Row(stem, name, command, "+".join(digest.KINDS), "", "", "", "")
              for name in texts if name not in known]

    def made(row):
        return row.page == stem and (row.table in only if only else row.command == command)
    write(row._replace(command=command, sources=digest.of(row.kinds), commit=now[0], day=now[1],
                       text=texts[row.table]) if made(row) else row
          for row in found if row.page != stem or row.table in texts)


def amend(page, command):
    """Notes that some lines of a command's tables are new: the tables stay as old as they were."""
    texts = tables(page)
    write(row._replace(text=texts[row.table])
          if (row.page, row.command) == (Path(page).stem, command) else row for row in rows())


def prune(pages):
    """Forgets tables that are in no page any more."""
    there = {(page.stem, name) for page in pages for name in tables(page)}
    kept = [row for row in rows() if (row.page, row.table) in there]
    if len(kept) < len(rows()):
        write(kept)


def age(stem):
    """A sentence for each experiment whose tables are alike old, for a page's reader."""
    def alike(row):
        return row.command, row.kinds, digest.of(row.kinds) == row.sources

    def run(row):
        return row.commit, row.day
    told = []
    for (command, kinds, same), group in groupby(
            sorted((r for r in rows() if r.page == stem and r.kinds != "-"), key=alike), alike):
        made = "; ".join(", ".join(f"*{row.table}*" for row in some) + f" at {at} of {day}"
                         for (at, day), some in groupby(sorted(group, key=run), run))
        *first, last = [NAMES[kind] for kind in kinds.split("+")]
        what = ", ".join(first) + (" and " if same else " or ") + last if first else last
        what = what[0].upper() + what[1:] + (" have" if first else " has")
        told.append(f"- `{command}` made {made}. {what} {'not ' if same else ''}changed since.")
    return "\n".join(textwrap.fill(line, 100, subsequent_indent="  ", break_on_hyphens=False)
                     for line in told)


def wrong(pages):
    """What does not agree between pages and record."""
    record = {(row.page, row.table): row for row in rows()}
    for page in pages:
        there = tables(page)
        for name, text in there.items():
            row = record.pop((page.stem, name), None)
            if row is None:
                yield f"{page}: nothing says when the table {name} was measured"
            elif row.text not in (text, "-"):
                yield f"{page}: the table {name} is not the one that `{row.command}` made"
        mark = f"<!-- begin: age {page.stem} -->"
        if age(page.stem) and mark not in page.read_text(encoding="utf-8"):
            yield f"{page}: has measured tables and does not tell their age"
    for page, name in record:
        yield f"{RECORD}: there is no table {name} in {page}.md"


if __name__ == "__main__":
    stamp(*sys.argv[1:])
    sys.exit(subprocess.run([sys.executable, "-m", "lab.pages", sys.argv[1]], check=False)
             .returncode)
