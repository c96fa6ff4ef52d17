# board.py - cells and clocks of a board's bitstream, as its page shows them
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.board --digest          of the sources as they are
          python3 -m lab.pages.board FOLDER            what synth/board.sh left there, into DATA"""
import json
import os
import re
import sys
from pathlib import Path

from . import digest

DATA = Path("docs/results/data/board.tsv")
HEAD = ("# board.tsv - cells of rt_ulx3s_ram and what it reaches, by make board\n"
        "# SPDX-License-Identifier: Apache-2.0\n")
# of an LFE5U-85F
PARTS = {"LUT4": 83640, "TRELLIS_FF": 83640, "DP16KD": 208, "MULT18X18D": 156, "CCU2C": None,
         "TRELLIS_DPR16X4": None}


def sources():
    """Digest of all that a bitstream is made of."""
    paths = [path for path in Path("rtl").rglob("*") if path.suffix in (".v", ".vh")]
    return digest.of_files(paths + [Path("synth/ulx3s.lpf"), Path("synth/board.sh")])


def read(folder):
    """Lines of DATA: name, value."""
    log = (folder / "yosys.log").read_text(encoding="utf-8")
    cells = dict(re.findall(r"^     (\w+) +(\d+)$", log[log.rindex("Number of cells:"):], re.M))
    found = {name: cells.get(name, "0") for name in PARTS}
    report = folder / "report.json"
    if report.exists():
        for clock, speed in json.loads(report.read_text(encoding="utf-8"))["fmax"].items():
            found[f"{clock.rpartition('.')[2]}, MHz"] = \
                f"{speed['achieved']:.1f} of {speed['constraint']:.1f}"
    found["sources"] = (folder / "digest").read_text(encoding="utf-8").strip()
    return found


def board():
    """The table of the page, and how old it is."""
    lines = DATA.read_text(encoding="utf-8").splitlines()
    rows = dict(line.split("\t") for line in lines if not line.startswith("#"))
    made = rows.pop("sources")
    clocks = any(name.endswith("MHz") for name in rows)
    text = "| | |\n|---|---|\n"
    for name, value in rows.items():
        most = PARTS.get(name)
        text += f"| {name} | {value}{f' of {most}' if most else ''} |\n"
    text += "\nNot routed yet: these are Yosys' cells.\n" if not clocks else ""
    if made != sources():
        text += f"\nOf sources {made}, before their last change.\n"
    return text


def main():
    """A digest, or the data of a folder."""
    if sys.argv[1] == "--digest":
        print(sources())
        return
    found = read(Path(sys.argv[1]))
    new = DATA.with_suffix(".tmp")
    new.write_text(HEAD + "".join(f"{name}\t{value}\n" for name, value in found.items()),
                   encoding="utf-8")
    os.replace(new, DATA)


if __name__ == "__main__":
    main()
