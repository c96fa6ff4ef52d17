# words.py - how many words of the pages were written by hand, and how many there may be
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.words
Prints the words of each page of docs/ that are prose: without code blocks, tables, pictures,
regions that are generated, and the addresses of links. Ends with 1 if all are above MOST."""
import re
import sys
from pathlib import Path

MOST = 45000
LEFT_OUT = (
    re.compile(r"^```.*?^```", re.S | re.M),                    # code, drawings
    re.compile(r"<!-- begin: .*?<!-- end -->", re.S),           # generated
    re.compile(r"<!--.*?-->", re.S),
    re.compile(r"^ *\|.*$", re.M),                              # tables
    re.compile(r"(?:(?<=\n\n)|\A)(?: {4}.*\n)+(?=\n|\Z)"),     # commands, listings
    re.compile(r"!\[[^\]]*\]\([^)]*\)"),                        # pictures
    re.compile(r"(?<=\])\([^)]*\)"),                            # addresses of links
)


def prose(text):
    """The words of a page that are neither table, code nor generated: numbers too, but no signs."""
    for pattern in LEFT_OUT:
        text = pattern.sub(" ", text)
    return [word for word in text.split() if re.search(r"\w", word)]


def main():
    counts = sorted((len(prose(page.read_text(encoding="utf-8"))), str(page))
                    for page in Path("docs").rglob("*.md"))
    for count, page in counts:
        print(f"{count:6} {page}")
    total = sum(count for count, _ in counts)
    print(f"{total:6} words of prose, at most {MOST}")
    return total > MOST


if __name__ == "__main__":
    sys.exit(main())
