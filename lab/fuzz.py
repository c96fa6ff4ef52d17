# fuzz.py - what `make fuzz` has run, as the table of docs/results/verification.md
# SPDX-License-Identifier: Apache-2.0
"""RUNS has a row for each run (tests/fuzz/fuzz.sh). Those of a harness that had the sources of its
last one are added up; older sources were others, and what failed in them is told on the page. RUNS
is of one machine: a harness that it lacks keeps its row of the page. Without any run the page stays
as it is, and the exit code is 1."""
import re
import sys
from pathlib import Path

from .pages import place

HEAD = ("| harness | runs | by AFL++ | by the tree's driver | minutes | inputs kept | failures "
        "| seeds | last | sources |\n|---|---|---|---|---|---|---|---|---|---|\n")
NAMES = ("day", "harness", "how", "seed", "minutes", "runs", "kept", "failures", "digest")


def total(rows, name, how=None):
    """Of a column, of the rows of one way; grouped in threes."""
    number = sum(int(row[name]) for row in rows if how in (None, row["how"]))
    return f"{number:,}".replace(",", " ")


def of_page(text):
    """{harness: its row}, as the page has them."""
    found = re.search(r"<!-- runs -->\n(.*?)<!-- end -->", text, re.S)
    rows = [line for line in (found[1] if found else "").splitlines() if line.startswith("| ")]
    return {row.split("|")[1].strip(): row for row in rows[1:]}


def of_runs(lines):
    """{harness: its row}, of the runs of each harness's last sources."""
    of, made = {}, {}
    for line in lines:
        row = dict(zip(NAMES, line.split("\t")))
        of.setdefault(row["harness"], []).append(row)
    for harness, rows in of.items():
        last = rows[-1]
        rows = [row for row in rows if row["digest"] == last["digest"]]
        seeds = " ".join(dict.fromkeys(row["seed"] for row in rows))
        kept = max(int(row["kept"]) for row in rows)
        made[harness] = (
            f"| {harness} | {total(rows, 'runs')} | {total(rows, 'runs', 'afl')} | "
            f"{total(rows, 'runs', 'plain')} | {total(rows, 'minutes')} | {kept} | "
            f"{total(rows, 'failures')} | {seeds} | {last['day']} | {last['digest']} |")
    return made


def main(*given):
    runs, page = map(Path, given)
    made = of_runs(runs.read_text(encoding="utf-8").splitlines() if runs.exists() else ())
    if not made:
        sys.exit(f"fuzz: {runs}: no run is there; {page} stays as it is")
    rows = of_page(page.read_text(encoding="utf-8")) | made
    place.place(page, "make fuzz-page", {"runs": HEAD + "\n".join(rows.values())},
                rest=bool(set(rows) - set(made)))
