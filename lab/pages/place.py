# place.py - puts tables and texts in their places of a page
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.place PAGE NAME FILE
FILE's text replaces what stands between the line `<!-- NAME -->` of PAGE and the next
`<!-- end -->`."""
import re
import sys

from .. import intact
from . import data


def place(page, texts, yosys=None):
    """Each NAME of texts stands once in the page, or has a file of its own beside it (data.py).
    Yosys's version is brought up to date if it is given."""
    with open(page, encoding="utf-8") as f:
        text = f.read()
    for name, lines in texts.items():
        pattern = rf"(<!-- {name} -->\n)(?:(?!<!-- ).*\n)*(<!-- end -->)"
        text, n = re.subn(pattern, lambda m, t=lines: m[1] + t + "\n" + m[2], text)
        if n == 0 and data.path_of(page, name).exists():
            intact.write(data.path_of(page, name), data.of_markdown(lines))
        elif n != 1:
            sys.exit(f"page: {page}: {n} places for the table `{name}`, not one")
    if yosys:
        text = re.sub(r"Yosys \d[\d.]*\d( \([^)[]*\))?", yosys.split(" (")[0], text)
    intact.write(page, text)


if __name__ == "__main__":
    with open(sys.argv[3], encoding="utf-8") as file:
        place(sys.argv[1], {sys.argv[2]: file.read().rstrip("\n")})
