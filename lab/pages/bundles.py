# bundles.py - the bundles of rtl/engine/bundles.def, as a table
# SPDX-License-Identifier: Apache-2.0
from pathlib import Path

from . import markdown

DEF = Path("rtl/engine/bundles.def")


def bundles():
    """A row for each bundle: what it is, and its fields with their bits and meaning."""
    table = []
    for line in DEF.read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        kind, *words = line.split(maxsplit=2 if line.startswith("b") else 3)
        if kind == "bundle":
            table.append([f"**`{words[0]}`**", "", words[1]])
        elif kind == "field":
            name, width, *meaning = words
            table.append([f"`{name}`", width, " ".join(meaning)])
    return markdown.table(["bundle, field", "bits", "what"], table)
