# bundles.py - the bundles of rtl/engine/bundles.def, as a list
# SPDX-License-Identifier: Apache-2.0
from pathlib import Path

DEF = Path("rtl/engine/bundles.def")


def bundles():
    """A paragraph for each bundle: what it is, and its fields with their bits and meaning, but for
    a VALID and a SLOT that say nothing of their own."""
    told = []
    for line in DEF.read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        kind, *words = line.split(maxsplit=2 if line.startswith("b") else 3)
        if kind == "bundle":
            told.append((f"- **`{words[0]}`**, {words[1]}:", []))
        elif kind == "field":
            name, width, *meaning = words
            if not meaning and name in ("VALID", "SLOT"):
                continue
            bits = [width] * (width != "1")
            told[-1][1].append(" ".join([f"`{name}`"] + bits + [f"({m})" for m in meaning]))
    return "\n".join(f"{head} {'; '.join(fields)}." for head, fields in told)
