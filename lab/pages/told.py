# told.py - MHz and frames a second that pages tell by hand
# SPDX-License-Identifier: Apache-2.0
"""A clock of a core, and a rate that follows from it, stand in a generated region alone (rates.py).
So this prints each figure with a unit of UNITS that a page has outside of one, each column of a
table that is headed by such a unit, and ends with 1 if there is any. What is nobody's measurement
here, such as a figure of a paper or a standard, is a line PAGE; FIGURE; WHOSE of GIVEN. A line
without such a figure in its page is printed too."""
import re

from . import data, markdown

GIVEN = data.FOLDER / "given.txt"
UNITS = (r"(?:MHz|fps|ms a frame|(?:frames?|rays|pixels)(?: ?/ ?s\b| (?:a|per) second))")
NUMBER = r"\d[\d.]*(?: (?:to|and) \d[\d.]*)?"
FIGURE = re.compile(rf"{NUMBER} (?:million )?{UNITS}|\bin {NUMBER} ms\b")
HEAD = re.compile(rf"^ *\|(.*)\|\n *\|[-:| ]+\|$", re.M)
OWN = ("clocks", "board_", "silicon.")  # tables of clocks that a placer or a timer gave


def by_hand(text):
    """(position, figure) of each that stands outside of generated regions; a column by its head."""
    def blank(match):
        return re.sub(r"[^\n]", "~", match[0])
    text = markdown.REGION.sub(blank, text)
    for match in FIGURE.finditer(text.replace("\n", " ")):
        yield match.start(), match[0]
    for match in HEAD.finditer(text):
        for column in match[1].split("|"):
            if re.search(UNITS, column) and not FIGURE.search(column):
                yield match.start(), f"the column {column.strip()}"


def given():
    """{(page, figure)} of GIVEN."""
    lines = [line.split("; ") for line in GIVEN.read_text(encoding="utf-8").splitlines()
             if not line.startswith("#")]
    return {(page, figure) for page, figure, _ in lines}


def main():
    allowed, bad = given(), 0
    met = set()
    for page in markdown.pages():
        text = page.read_text(encoding="utf-8")
        for position, figure in by_hand(text):
            if (str(page), figure) in allowed:
                met.add((str(page), figure))
                continue
            line = text.count("\n", 0, position) + 1
            print(f"{page}:{line}: {figure} is told by hand: lab/pages/rates.py, or {GIVEN}")
            bad += 1
    for page, figure in sorted(allowed - met):
        print(f"{GIVEN}: {page} does not tell {figure} by hand")
        bad += 1
    for name in data.names():
        head = data.read(name)[0] if not name.startswith(OWN) else []
        for column in head:
            if re.search(UNITS, column):
                print(f"{name}: the column {column}: a table has clocks, no rates")
                bad += 1
    return bad > 0
