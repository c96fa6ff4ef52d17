#!/usr/bin/env python3
# hard.py - puts the table and the chart of a campaign in their places in docs/results/hard_cases.md
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.hard PAGE JSON TABLE PICTURE

JSON and TABLE are what `hard` wrote of one campaign: --json, and its standard output. The table and
its sums are put in their places, PICTURE is made anew.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

from .pages import markdown
from .pages.place import place

CHART = """set terminal svg noenhanced size 1000,640 font "sans,12" background "white"
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
plot {bars}
"""
COLOURS = {"float32 textbook": "#cc6677", "float32 Gems": "#ddaa33", "float64 textbook": "#4477aa",
           "ours": "#228833"}
SHOWN = ("standard", "reference")


def wrong(row, formula):
    """Per million cases; what is 0 has no place on the axis."""
    f = row["formulas"][formula]
    count = f["wrong_hit"] + f["wrong_root"] + f["wrong_order"]
    return f"{1e6 * count / row['cases']:.3f}" if count else "-"


def chart(campaign, picture):
    text = CHART.format(out=picture)
    for profile in SHOWN:
        rows = [r for r in campaign["rows"]
                if r["profile"] == profile and r["family"] != "exhaustive"]
        text += f"${profile} << end\n"
        for r in rows:
            text += " ".join([r["family"]] + [wrong(r, f) for f in COLOURS]) + "\n"
        bars = []
        for n, (f, colour) in enumerate(COLOURS.items(), 2):
            none = all(wrong(r, f) == "-" for r in rows)
            what = f'NaN with boxes title "{f}: 0"' if none else \
                f'${profile} using {n}:xtic(1) title "{f}"'
            bars.append(f'{what} lc rgb "{colour}"')
        text += "end\n" + PANEL.format(profile=profile, bars=", \\\n     ".join(bars))
    subprocess.run(["gnuplot"], input=text, text=True, check=True)


def counts(cell):
    """(hits, roots, orders) that are wrong, of a cell such as `3587/0/0, 1.7` or `0, 7e-13`."""
    return [int(n) for n in (cell.split(",")[0].split("/") + ["0", "0"])[:3]]


def sums(campaign, lines):
    """What stands in the page: the command, all cases, and each profile's sums of the table."""
    head, *rows = [[cell.strip() for cell in line.strip()[1:-1].split("|")] for line in lines]
    rows = [row for row in rows if row[1] and set(row[1]) != {"-"}]
    wrong = sum(sum(counts(row[4])) + int(row[5]) for row in rows)
    shown = []
    for profile in [*dict.fromkeys(row[1] for row in rows), "all"]:
        of = [row for row in rows if profile in ("all", row[1])]
        shown.append([profile, sum(int(row[2]) for row in of), sum(int(row[3]) for row in of)] + [
            "/".join(str(sum(n)) for n in zip(*(counts(row[i]) for row in of)))
            for i in (4, *range(8, len(head)))])
    cases, naive = (sum(r[what] for r in campaign["rows"]) for what in ("cases", "naive"))
    return "\n".join([
        f"    make hard N={campaign['cases_a_profile']} SEED={campaign['seed']}", "",
        f"{cases} cases, {naive} answers of the naive model, {wrong} wrong.", "",
        markdown.table(["profile", "cases", "hits", "ours"] + head[8:], shown)])


def main():
    page, campaign, table, picture = sys.argv[1:]
    with open(campaign) as f:
        campaign = json.load(f)
    lines = [re.sub(" +", " ", line) for line in Path(table).read_text().splitlines()
             if line.startswith("|")]
    place(page, {"campaign": "\n".join(lines), "sums": sums(campaign, lines)})
    chart(campaign, picture)


if __name__ == "__main__":
    main()
