# typed.py - figures that somebody typed into README and the pages of results
# SPDX-License-Identifier: Apache-2.0
"""A measured figure follows its table: it stands in a measured table (measured.py) or in a region
(data.py: `cell`). What is typed grows old unseen. Typed figures are numbers with a unit of UNITS in
prose, and tables with numbers that are neither; code, regions and addresses do not count. ALLOWED
has those that may stand, with the reason: lines `PAGE | FIGURE | REASON`, where FIGURE is the
number with its unit, or `table: FIRST HEADINGS`, and * as PAGE stands for all pages. Prints every
other one (--list: all), and lines of ALLOWED that nothing needs; exits with 1 if there are any."""
import re
from pathlib import Path

ALLOWED = Path("lab/pages/typed.txt")
UNITS = (r"MHz|MULT18X18D|multipliers|LUT4eq|LUT4|LUTs?|FFs?|flip-flops|DP16KD|DPR16X4|blocks|"
         r"cycles|clocks|dB|ms|milliseconds|ns|seconds|minutes|hours|frames a second|frames/s|"
         r"visits|bytes|kB|KB|MB|GB|%|percent")
NUMBER = r"\d+(?: \d{3})*(?:\.\d+)?"
FIGURE = re.compile(rf"(?<![\w.,/:=x^-])({NUMBER}) ?({UNITS})(?!\w)")
VALUE = re.compile(rf"[-+~]?{NUMBER}(?: ?{UNITS})?(?: ?[/(,;].*| of .*)?")  # of a table's cell
LEFT_OUT = (
    re.compile(r"^```.*?^```", re.S | re.M),                    # code, drawings
    re.compile(r"<!-- begin: .*?<!-- end -->", re.S),           # generated
    re.compile(r"<!-- (?!end)[a-z0-9_]+ -->.*?<!-- end -->", re.S),  # measured tables
    re.compile(r"<!--.*?-->", re.S),
    re.compile(r"(?:(?<=\n\n)|\A)(?: {4}.*\n)+(?=\n|\Z)"),      # commands, listings
    re.compile(r"`[^`\n]*`"),
    re.compile(r"(?<=\])\([^)]*\)"),                            # addresses of links
)
TABLE = re.compile(r"(?:^\|.*\n)+", re.M)


def pages():
    return [Path("README.md")] + sorted(Path("docs/results").glob("*.md"))


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def cells(row):
    return [cell.strip() for cell in row.strip().strip("|").split("|")]


def figures(page):
    """(line, figure) of a page, in its order. README's tables are prose in columns."""
    raw, found = page.read_text(encoding="utf-8"), []
    text = raw
    for pattern in LEFT_OUT:
        text = pattern.sub(blank, text)
    for table in TABLE.finditer(text) if page.name != "README.md" else ():
        _, _, *rows = table[0].splitlines()
        head = raw[table.start():].splitlines()[0]
        if any(VALUE.fullmatch(cell) for row in rows for cell in cells(row)):
            found.append((text.count("\n", 0, table.start()) + 1,
                          "table: " + ", ".join(filter(None, cells(head)[:2]))))
            text = text[:table.start()] + blank(table) + text[table.end():]
    flat = text.replace("\n", " ")
    found += [(text.count("\n", 0, m.start()) + 1, f"{m[1]} {m[2]}")
              for m in FIGURE.finditer(flat)]
    return sorted(found)


def allowed():
    """{(page, figure): reason}"""
    lines = [line for line in ALLOWED.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    rows = {}
    for line in lines:
        page, figure, reason = (part.strip() for part in line.split(" | "))
        rows[page, figure] = reason
    return rows


def main(*names, everything=False):
    chosen = [Path(name) for name in names]
    may, used, bad = allowed(), set(), 0
    for page in chosen or pages():
        for line, figure in figures(page):
            key = next((key for key in ((page.stem, figure), ("*", figure)) if key in may), None)
            used.add(key)
            if everything or not key:
                print(f"{page}:{line}: {figure}" + (f": {may[key]}" if key else ""))
            bad += not key
    for page, figure in set(may) - used if not chosen else ():
        print(f"{ALLOWED}: {page} has no {figure}")
        bad += 1
    if bad and not everything:
        print(f"{bad} figures are typed: make each a region of its table, or name it in {ALLOWED} "
              "with a reason")
    return bad > 0 and not everything
