# fuzz.py - what `make fuzz` has run, as the table of docs/results/fuzz.md
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.fuzz RUNS PAGE
RUNS has a row for each run (tests/fuzz/fuzz.sh). Those of one harness and one way are added up."""
import sys
from pathlib import Path

from .pages import place

NAMES = ("day", "harness", "how", "seed", "minutes", "runs", "kept", "failures", "digest")
HOW = {"afl": "AFL++", "plain": "the tree's driver"}


def table(lines):
    """Markdown of all rows; the last run says day and digest."""
    of = {}
    for line in lines:
        row = dict(zip(NAMES, line.split("\t")))
        of.setdefault((row["harness"], row["how"]), []).append(row)
    yield "| harness | by | runs | minutes | inputs kept | failures | seeds | last | sources |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for (harness, how), rows in of.items():
        def total(name, rows=rows):
            return sum(int(row[name]) for row in rows)
        seeds = " ".join(dict.fromkeys(row["seed"] for row in rows))
        runs = f"{total('runs'):,}".replace(",", " ")
        yield (f"| {harness} | {HOW[how]} | {runs} | {total('minutes')} | "
               f"{rows[-1]['kept']} | {total('failures')} | {seeds} | {rows[-1]['day']} | "
               f"{rows[-1]['digest']} |")


def main():
    runs, page = sys.argv[1:]
    text = "\n".join(table(Path(runs).read_text(encoding="utf-8").splitlines())) + "\n"
    place.place(page, {"runs": text})


main()
