# fuzz.py - what `make fuzz` has run, as the table of docs/results/fuzz.md
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.fuzz RUNS PAGE
RUNS has a row for each run (tests/fuzz/fuzz.sh). Those of a harness that had the sources of its
last one are added up; older sources were others, and what failed in them is told on the page."""
import sys
from pathlib import Path

from .pages import place

NAMES = ("day", "harness", "how", "seed", "minutes", "runs", "kept", "failures", "digest")


def total(rows, name, how=None):
    """Of a column, of the rows of one way; grouped in threes."""
    number = sum(int(row[name]) for row in rows if how in (None, row["how"]))
    return f"{number:,}".replace(",", " ")


def table(lines):
    """Markdown of the rows of each harness's last sources."""
    of = {}
    for line in lines:
        row = dict(zip(NAMES, line.split("\t")))
        of.setdefault(row["harness"], []).append(row)
    yield ("| harness | runs | by AFL++ | by the tree's driver | minutes | inputs kept | failures "
           "| seeds | last | sources |")
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for harness, rows in of.items():
        last = rows[-1]
        rows = [row for row in rows if row["digest"] == last["digest"]]
        seeds = " ".join(dict.fromkeys(row["seed"] for row in rows))
        kept = max(int(row["kept"]) for row in rows)
        yield (f"| {harness} | {total(rows, 'runs')} | {total(rows, 'runs', 'afl')} | "
               f"{total(rows, 'runs', 'plain')} | {total(rows, 'minutes')} | {kept} | "
               f"{total(rows, 'failures')} | {seeds} | {last['day']} | {last['digest']} |")


def main():
    runs, page = sys.argv[1:]
    text = "\n".join(table(Path(runs).read_text(encoding="utf-8").splitlines())) + "\n"
    place.place(page, {"runs": text})


main()
