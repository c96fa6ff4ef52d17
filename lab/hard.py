#!/usr/bin/env python3
# hard.py - puts the table and the chart of a campaign in their places in docs/results/hard_cases.md
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab hard-page PAGE PICTURE LIST TABLE...

LIST is what `hard --list` prints; each TABLE is what `hard` printed of a campaign. Its rows take
the places of those of the same family and profile; families that no TABLE has stay as they are.
Sums are made of all rows, and PICTURE anew.
"""
import re
import subprocess
from pathlib import Path

from .pages import data, markdown
from .pages.place import place

CHART = """set terminal svg noenhanced size 1300,720 font "sans,12" background "white"
set output "{out}"
set multiplot layout 2,1 title "Wrong hit or miss, root or order, per million cases (ours: 0)"
set style data histogram
set style histogram clustered gap 1
set style fill solid noborder
set logscale y
set yrange [0.1:1000000]
set ytics ("1" 1, "10" 10, "100" 100, "1000" 1000, "10 000" 10000, "100 000" 100000)
set grid ytics lc rgb "#cccccc"
set xtics rotate by 45 right nomirror
set bmargin 5
set key outside right center vertical samplen 2
set datafile missing "-"
"""
PANEL = """set title "profile {profile}"
set xrange [-0.7:{last}]
plot {bars}
"""
COLOURS = {"float32 textbook": "#cc6677", "float32 Gems": "#ddaa33", "float64 textbook": "#4477aa",
           "ours": "#228833"}
FORMULAS = ["float32 textbook", "float32 paper", "float32 Gems", "float64 textbook"]
SHOWN = ("standard", "reference")


def counts(cell):
    """(hits, roots, orders) that are wrong, of a cell like `3587/0/0, 1.7`, `0, 7e-13` or `-`."""
    return [int(n) for n in (cell.replace("-", "0", cell == "-").split(",")[0].split("/")
                             + ["0", "0"])[:3]]


def wrong(row, formula):
    """Per million cases; what is 0 has no place on the axis."""
    count = sum(counts(row[formula]))
    return f"{1e6 * count / int(row['cases']):.3f}" if count else "-"


def chart(found, picture):
    text = CHART.format(out=picture)
    for profile in SHOWN:
        rows = [r for r in found if r["profile"] == profile and r["family"] != "3 bits"]
        text += f"${profile} << end\n"
        for r in rows:
            text += " ".join([r["family"]] + [wrong(r, f) for f in COLOURS]) + "\n"
        bars = []
        for n, (f, colour) in enumerate(COLOURS.items(), 2):
            none = all(wrong(r, f) == "-" for r in rows)
            what = f'NaN with boxes title "{f}: 0"' if none else \
                f'${profile} using {n}:xtic(1) title "{f}"'
            bars.append(f'{what} lc rgb "{colour}"')
        text += "end\n" + PANEL.format(profile=profile, last=len(rows) - 0.3,
                                       bars=", \\\n     ".join(bars))
    subprocess.run(["gnuplot"], input=text, text=True, check=True)


def merged(old, tables):
    """Rows as dictionaries, those of the tables in the places of old ones or behind them."""
    rows = {(r["family"], r["profile"]): r for r in old}
    for table in tables:
        lines = [line for line in Path(table).read_text(encoding="utf-8").splitlines()
                 if line.startswith("|")]
        head, _, *found = [[c.strip() for c in line.strip()[1:-1].split("|")] for line in lines]
        for cells in found:
            if cells[1]:
                rows[cells[0], cells[1]] = dict(zip(head, cells), ours=cells[4])
    return list(rows.values())


def summed(name, rows):
    """One line of sums; what no formula says anything of is a dash."""
    line = [name, sum(int(r["cases"]) for r in rows), sum(int(r["hits"]) for r in rows)]
    for f in ["ours"] + FORMULAS:
        cells = [r[f] for r in rows if r[f] != "-"]
        line.append("/".join(str(sum(n)) for n in zip(*map(counts, cells))) if cells else "-")
    return line


def sums(rows, kind):
    """What stands in the page: all cases, the sums of profiles and of kinds."""
    def table(first, key):
        names = list(dict.fromkeys(map(key, rows)))
        lines = [summed(n, [r for r in rows if key(r) == n]) for n in names]
        return markdown.table([first, "cases", "hits", "ours"] + FORMULAS, lines + (
            [summed("all", rows)] if first == "profile" else []))
    wrong_ones = sum(sum(counts(r["wrong"])) + int(r["other"]) for r in rows)
    cases = sum(int(r["cases"]) for r in rows)
    head = [f"{cases} cases, {wrong_ones} wrong.", ""]
    return "\n".join(head + [table("profile", lambda r: r["profile"])]), \
        table("kind", lambda r: kind.get(r["family"], "spheres"))


def main(page, command, family, picture, listing, *tables):
    kind = dict(re.findall(r"^\| `(\w+)` \| (\w+) \|", Path(listing).read_text(encoding="utf-8"),
                           re.M))
    head, old = data.read("hard_cases.campaign")
    rows = merged([dict(zip(head, cells), ours=cells[4]) for cells in old if cells[1]], tables)
    order = ["3 bits", *kind]
    rows.sort(key=lambda r: order.index(r["family"]))
    text, kinds = sums(rows, kind)
    place(page, command, {"campaign": markdown.table(head, [[r[h] for h in head] for r in rows]),
                          "sums": text, "kinds": kinds}, rest=bool(family))
    chart(rows, picture)
