# age.py - how old the measured figures of the pages are
# SPDX-License-Identifier: Apache-2.0
"""Of each measured table, or those of some pages (scenarios, area): the commit that it was measured
at, its day, the command, and how many commits have changed rtl/, cmodel/ and scenes/ since. So with
the cells of cores and boards. Whether a figure would be another one today, its command alone
tells."""
import subprocess
import sys
from functools import lru_cache

from . import board, cores, measured


@lru_cache(maxsize=None)
def since(commit, folder):
    """Commits behind one that changed a folder; ? if this tree does not have it."""
    done = subprocess.run(["git", "rev-list", "--count", commit + "..HEAD", "--", folder],
                          check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return done.stdout.strip() if done.returncode == 0 else "?"


def lines(pages):
    """(page, table, commit, day, command), all of them or those of some pages."""
    found = [(row.page, row.table, row.commit, row.day, row.command) for row in measured.rows()]
    found += [("cores", name, of["commit"], of["day"], "make pages")
              for name, of in cores.record().items()]
    found += [("board", name, *made, f"make board BOARD={name}") for name, made in board.runs()]
    return [line for line in found if not pages or line[0] in pages]


def main(*pages):
    rows = [["page", "table", "commit", "day", *measured.SOURCES, "command"]]
    rows += [[page, table, commit, day,
              *(since(commit.rstrip("+"), folder) for folder in measured.SOURCES), command]
             for page, table, commit, day, command in lines(pages)]
    if not rows[1:]:
        sys.exit(f"age: no measured table in {', '.join(pages)}")
    widths = [max(map(len, column)) for column in zip(*rows)]
    print("\n".join("  ".join(word.ljust(width) for word, width in zip(row, widths)).rstrip()
                    for row in rows))
