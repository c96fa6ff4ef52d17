# data.py - tables that are too long for a page: docs/results/data/PAGE.tsv
# SPDX-License-Identifier: Apache-2.0
"""A page's file has them one below the other: a line `# table NAME`, a line of column names, and a
line for each row. An empty table is one that no command has filled yet. A page shows some of it
with the regions `rows PAGE.TABLE` and `cell PAGE.TABLE; ROW; COLUMN`. Which rows and
columns, says a line `PAGE.TABLE; ROW | ROW...; COLUMN | COLUMN...` of SHOWN; nothing stands for all
of them. A row is named by its first column, or by its first ones joined by blanks."""
import os
import re
from pathlib import Path

from .. import intact
from . import markdown

FOLDER = Path("docs/results/data")
SHOWN = FOLDER / "shown.txt"
HEAD = "# SPDX-License-Identifier: Apache-2.0\n"
TITLE = "# {0}.tsv - the long tables of {0}.md, as lab/pages/data.py reads them\n" + HEAD
MARK = re.compile(r"^# table (\w+)\n", re.M)


def path_of(page):
    """Where those tables of a page lie that are not in the page itself."""
    page = Path(page)
    return page.parent / "data" / f"{page.stem}.tsv"


def tables(page):
    """{name: text} of them, each text as of_rows() makes it."""
    path = path_of(page)
    if not path.exists():
        return {}
    _, *parts = MARK.split(path.read_text(encoding="utf-8"))
    return {name: HEAD + text.rstrip("\n") + "\n" for name, text in zip(parts[::2], parts[1::2])}


def names():
    """Every table of the folder, as read() takes it."""
    for path in sorted(FOLDER.glob("*.tsv")):
        page = FOLDER.parent / f"{path.stem}.md"
        if page.exists():
            yield from (f"{path.stem}.{name}" for name in tables(page))
        else:
            yield path.stem


def put(page, texts):
    """Writes these tables of a page; its others stay."""
    path, kept = path_of(page), {**tables(page), **texts}
    intact.write(path, TITLE.format(path.stem) + "".join(
        f"\n# table {name}\n{kept[name].removeprefix(HEAD)}" for name in sorted(kept)))


def of_rows(rows):
    """Rows, the column names first, as such a file has them."""
    return HEAD + "".join("\t".join(row) + "\n" for row in rows)


def of_markdown(text):
    """The table of a page as lines of a file; an empty first cell becomes the one above it."""
    rows = []
    for line in text.splitlines():
        if line.startswith("|") and set(line) - set("|-: "):
            cells = [cell.strip().replace(r"\|", "|")
                     for cell in re.split(r"(?<!\\)\|", line.strip()[1:-1])]
            rows.append([cells[0] or (rows[-1][0] if len(rows) > 1 else "")] + cells[1:])
    return of_rows(rows)


def read(name):
    """(column names, rows) of NAME.tsv, or of PAGE.TABLE: in the page, or in its file."""
    stem, _, table = name.partition(".")
    page = FOLDER.parent / f"{stem}.md"
    if not table:
        text = (FOLDER / f"{name}.tsv").read_text(encoding="utf-8")
    elif table in (long := tables(page)):
        text = long[table]
    else:
        text = of_markdown(re.search(rf"<!-- {table} -->\n(.*?)<!-- end -->",
                                     page.read_text(encoding="utf-8"), re.S)[1])
    lines = text.splitlines()
    head, *rows = [line.split("\t") for line in lines if not line.startswith("# ")]
    return head, rows


def _words(text):
    return [word.strip() for word in text.split("|")] if text.strip() else []


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


def shown(name):
    """(rows, columns) of a table that its page shows, by name."""
    for line in SHOWN.read_text(encoding="utf-8").splitlines():
        if line.startswith(name + ";"):
            return [_words(part) for part in line.split(";")[1:]]
    return [], []


def chosen(name):
    """(column names, rows) of those rows that a page shows."""
    return _chosen(name, shown(name)[0])


def rows(name):
    """A table as its page shows it."""
    columns = shown(name)[1]
    head, found = chosen(name)
    places = [_column(name, head, word) for word in columns] or range(len(head))
    return markdown.table([head[i] for i in places], [[row[i] for i in places] for row in found])


def cell(*arguments):
    """One figure."""
    name, row, column = [part.strip() for part in " ".join(arguments).split(";")]
    head, found = _chosen(name, [row])
    return found[0][_column(name, head, column)]
