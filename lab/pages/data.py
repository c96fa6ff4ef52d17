# data.py - tables that are too long for a page: docs/results/data/PAGE.TABLE.tsv
# SPDX-License-Identifier: Apache-2.0
"""Such a file has a line of SPDX, a line of column names, and a line for each row. A page shows
some of it with the regions `rows PAGE.TABLE; ROW | ROW...; COLUMN | COLUMN...` and
`cell PAGE.TABLE; ROW; COLUMN`; `all` or nothing stands for all rows, nothing for all columns. A
row is named by its first column, or by its first ones joined by blanks."""
import os
import re
from pathlib import Path

from . import markdown

FOLDER = Path("docs/results/data")
HEAD = "# SPDX-License-Identifier: Apache-2.0\n"


def path_of(page, table):
    """Where the table of a page lies if it is not in the page itself."""
    page = Path(page)
    return page.parent / "data" / f"{page.stem}.{table}.tsv"


def of_markdown(text):
    """The table of a page as lines of a file; an empty first cell becomes the one above it."""
    rows = []
    for line in text.splitlines():
        if line.startswith("|") and set(line) - set("|-: "):
            cells = [cell.strip().replace(r"\|", "|")
                     for cell in re.split(r"(?<!\\)\|", line.strip()[1:-1])]
            rows.append([cells[0] or (rows[-1][0] if len(rows) > 1 else "")] + cells[1:])
    return HEAD + "".join("\t".join(row) + "\n" for row in rows)


def read(name):
    """(column names, rows), of a file or of a table in its page."""
    if (FOLDER / f"{name}.tsv").exists():
        text = (FOLDER / f"{name}.tsv").read_text(encoding="utf-8")
    else:
        page, _, table = name.partition(".")
        page = (FOLDER.parent / f"{page}.md").read_text(encoding="utf-8")
        text = of_markdown(re.search(rf"<!-- {table} -->\n(.*?)<!-- end -->", page, re.S)[1])
    lines = text.splitlines()
    head, *rows = [line.split("\t") for line in lines if not line.startswith("# ")]
    return head, rows


def write(path, text):
    new = path.with_suffix(".tmp")
    new.write_text(text, encoding="utf-8")
    os.replace(new, path)


def _words(text):
    return [] if text.strip() in ("", "all") else [word.strip() for word in text.split("|")]


def _chosen(name, wanted):
    head, found = read(name)
    plain = [[cell.strip("`") for cell in row] for row in found]
    chosen = [row for row, cells in zip(found, plain) if not wanted or any(
        word == " ".join(cells[:n]) for word in wanted for n in range(1, len(cells)))]
    missing = [word for word in wanted if not any(
        word == " ".join(cells[:n]) for cells in plain for n in range(1, len(cells)))]
    if missing:
        raise KeyError(f"{name} has no row {missing[0]}")
    return head, chosen


def _column(name, head, word):
    if word not in head:
        raise KeyError(f"{name} has no column {word}; there are {', '.join(head)}")
    return head.index(word)


def rows(*arguments):
    """A table of some rows and columns."""
    name, *parts = " ".join(arguments).split(";")
    wanted, columns = (parts + ["", ""])[:2]
    head, found = _chosen(name.strip(), _words(wanted))
    places = [_column(name, head, word) for word in _words(columns)] or range(len(head))
    return markdown.table([head[i] for i in places], [[row[i] for i in places] for row in found])


def cell(*arguments):
    """One figure."""
    name, row, column = [part.strip() for part in " ".join(arguments).split(";")]
    head, found = _chosen(name, [row])
    return found[0][_column(name, head, column)]
