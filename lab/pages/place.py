# place.py - puts the tables that a command has measured into their places of a page
# SPDX-License-Identifier: Apache-2.0
"""FILE's text replaces what stands between the line `<!-- NAME -->` of PAGE and the next
`<!-- end -->`, and the record (measured.py) says that COMMAND has just made it."""
import re
import subprocess
import sys

from .. import intact
from . import data, markdown, measured, whole


def place(page, command, tables, yosys=None, rest=False):
    """Tables that `command` has measured, NAME: text, or a function that makes it, or rows with the
    column names first. Each NAME stands once in the page, or in the file beside it
    (data.py). A table that lacks a result
    (whole.py) is shown on the terminal alone: page and stamp of it stay as they are. With rest some
    rows alone are new, and the stamp stays as well. Yosys's version is brought up to date if it is
    given. The words of the page that are made of tables follow. Returns the names that were put."""
    with open(page, encoding="utf-8") as f:
        text = f.read()
    put, beside, found = [], data.tables(page), {}
    for name in tables:
        n = len(re.findall(rf"^<!-- {name} -->$", text, re.M))
        if n != 1 and name not in beside:
            sys.exit(f"page: {page}: {n} places for the table `{name}`, not one")
    for name, table in tables.items():
        lines, lacking = whole.made(table)
        if lacking:
            print(f"{page}: the table {name} stays as it is: {lacking[0]}" +
                  (f", and {len(lacking) - 1} more" if lacking[1:] else ""), flush=True)
            print(lines or "", end="\n" * bool(lines))
            continue
        put.append(name)
        rows = isinstance(lines, list)
        if name in beside:
            found[name] = data.of_rows(lines) if rows else data.of_markdown(lines)
            continue
        lines = markdown.table(lines[0], lines[1:]) if rows else lines.rstrip("\n")
        pattern = rf"(<!-- {name} -->\n)(?:(?!<!-- ).*\n)*(<!-- end -->)"
        text = re.sub(pattern, lambda m, t=lines: m[1] + t + "\n" + m[2], text)
    if not put:
        return put
    if yosys:
        text = re.sub(r"Yosys \d[\d.]*\d( \([^)[]*\))?", yosys.split(" (")[0], text)
    if found:
        data.put(page, found)
    intact.write(page, text)
    measured.stamp(page, command, put, rest)
    if subprocess.run([sys.executable, "-m", "lab", "pages", page], check=False).returncode:
        sys.exit(1)
    return put


def main(page, command, name, file):
    place(page, command, {name: lambda: whole.text(file)})
