# page.py - what stands between ports and registers, into the pages of rt_core and rt_top
# SPDX-License-Identifier: Apache-2.0
"""Of the standard core with everything, and rt_top around it with a display."""
from itertools import groupby
from pathlib import Path

from ..pages.place import place
from . import folder, ports
from .netlist import Netlist


def rows(top, build, *given):
    """ports.table() with ports of one kind that stand side by side in one row, the head first."""
    values, _ = folder.parameters("standard", "all", given)
    if top == "rt_core":
        values = {n: v for n, v in values.items() if n not in folder.lists.OF_SHELL}
    work = Path(build) / "ip-page" / top
    work.mkdir(parents=True, exist_ok=True)
    folder.elaborated(top, values, work / "netlist.json", work)
    found = groupby(ports.table(Netlist(work / "netlist.json")),
                    key=lambda row: (row[1], *row[3:]))
    return [["ports", "", "clock", "between them and registers"]] + [
        [", ".join(row[0] for row in group), *kind] for kind, group in found]


def main(build):
    for page, top, given in (("docs/reference/core.md", "rt_core", ()),
                             ("docs/reference/rt_top.md", "rt_top", ("VIDEO=1",))):
        place(page, "make ip-page", {"timing": rows(top, build, *given)})
