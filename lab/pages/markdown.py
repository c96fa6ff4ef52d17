# markdown.py - tables of words, and regions of pages
# SPDX-License-Identifier: Apache-2.0
"""A region is what stands between `<!-- begin: NAME -->` and `<!-- end -->`: lines, if the marks
stand on lines of their own, else words within a line."""
import re
import textwrap
from pathlib import Path

REGION = re.compile(r"(<!-- begin: ([^\n]*?) -->)(\n?)(.*?)(<!-- end -->)", re.S)


def pages():
    """All pages of the tree."""
    return [Path("README.md"), Path("CONTRIBUTING.md")] + sorted(Path("docs").rglob("*.md"))


def table(head, rows):
    """A table of words, without padding: a longer cell changes one line."""
    lines = ["| " + " | ".join(cell.replace("|", r"\|") for cell in map(str, row)) + " |"
             for row in [head] + rows]
    lines.insert(1, "|" + "---|" * len(head))
    return "\n".join(lines).replace("|  |", "| |").replace("|  |", "| |")


def entries(rows):
    """A list of (name, meaning), wrapped as the text around it."""
    return "\n".join(textwrap.fill(f"- {name}: {meaning}", 100, subsequent_indent="  ",
                                   break_long_words=False, break_on_hyphens=False)
                     for name, meaning in rows)


def nested(head, items):
    """A list below a line of a list; a single item stays in the line."""
    if len(items) == 1:
        return f"{head}: {items[0]}"
    return "\n".join([f"{head}:"] + [f"  - {item}" for item in items])


def names(text):
    """Of all regions, in their order."""
    return [match[2] for match in REGION.finditer(text)]


def fill(text, make):
    """The text with each region as make(name) has it."""
    return REGION.sub(lambda m: m[1] + m[3] + make(m[2]) + m[3] + m[5], text)
