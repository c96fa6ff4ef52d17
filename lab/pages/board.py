# board.py - cells and clocks of a board's bitstream, as its page shows them
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.board --digest          of the sources as they are
          python3 -m lab.pages.board BOARD FOLDER      what synth/board.sh left there, into DATA"""
import json
import re
import sys
from datetime import datetime, timezone
from pathlib import Path

from .. import intact
from . import digest

DATA = "docs/results/data/board_{}.tsv"
HEAD = ("# board_{0}.tsv - cells of rt_{0} and what it reaches, by make board BOARD={0}\n"
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
        routed = json.loads(report.read_text(encoding="utf-8"))
        for name, part in routed["utilization"].items():
            if name == "TRELLIS_COMB":
                found["TRELLIS_COMB, placed"] = f"{part['used']} of {part['available']}"
        for clock, speed in routed["fmax"].items():
            found[f"{clock.rpartition('$')[2].rpartition('.')[2]}, MHz"] = \
                f"{speed['achieved']:.1f} of {speed['constraint']:.1f}"
    when = datetime.fromtimestamp((folder / "yosys.log").stat().st_mtime, timezone.utc)
    found["day"] = when.strftime("%Y-%m-%d")
    seconds = folder / "seconds"
    if seconds.exists() and report.exists():
        found["minutes of nextpnr-ecp5"] = f"{int(seconds.read_text(encoding='utf-8')) / 60:.0f}"
    found["sources"] = (folder / "digest").read_text(encoding="utf-8").strip()
    return found


def board(name):
    """The table of a board, and how old it is."""
    lines = Path(DATA.format(name)).read_text(encoding="utf-8").splitlines()
    rows = dict(line.split("\t") for line in lines if not line.startswith("#"))
    made, day = rows.pop("sources"), rows.pop("day")
    clocks = any(name.endswith("MHz") for name in rows)
    text = "| | |\n|---|---|\n"
    for name, value in rows.items():
        most = PARTS.get(name)
        text += f"| {name} | {value}{f' of {most}' if most else ''} |\n"
    text += "\nNot routed yet: these are Yosys' cells.\n" if not clocks else ""
    if made != sources():
        text += f"\nOf {day} and sources {made}, before their last change.\n"
    return text


def main():
    """A digest, or the data of a folder."""
    if sys.argv[1] == "--digest":
        print(sources())
        return
    name, folder = sys.argv[1:]
    found = read(Path(folder))
    rows = "".join(f"{row}\t{value}\n" for row, value in found.items())
    intact.write(DATA.format(name), HEAD.format(name) + rows)


if __name__ == "__main__":
    main()
