# board.py - cells and clocks of a board's bitstream, as its page shows them
# SPDX-License-Identifier: Apache-2.0
import json
import re
from pathlib import Path

from .. import intact
from . import measured

DATA = "docs/results/data/board_{}.tsv"
HEAD = ("# board_{0}.tsv - cells of rt_{0} and what it reaches, by make board BOARD={0}\n"
        "# SPDX-License-Identifier: Apache-2.0\n")
# of an LFE5U-85F
PARTS = {"LUT4": 83640, "TRELLIS_FF": 83640, "DP16KD": 208, "MULT18X18D": 156, "CCU2C": None,
         "TRELLIS_DPR16X4": None}


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
    seconds = folder / "seconds"
    if seconds.exists() and report.exists():
        found["minutes of nextpnr-ecp5"] = f"{int(seconds.read_text(encoding='utf-8')) / 60:.0f}"
    found["commit"], found["day"] = (folder / "commit").read_text(encoding="utf-8").split()
    return found


def data(name):
    """{row: value} of a board."""
    lines = Path(DATA.format(name)).read_text(encoding="utf-8").splitlines()
    return dict(line.split("\t") for line in lines if not line.startswith("#"))


def runs():
    """(board, (commit, day)) of each."""
    for path in sorted(Path(DATA).parent.glob("board_*.tsv")):
        name = path.stem.removeprefix("board_")
        yield name, (data(name)["commit"], data(name)["day"])


def board(name):
    """The table of a board, and of which commit it is."""
    rows = data(name)
    commit, day = rows.pop("commit"), rows.pop("day")
    clocks = any(name.endswith("MHz") for name in rows)
    text = "| | |\n|---|---|\n"
    for name_of, value in rows.items():
        most = PARTS.get(name_of)
        text += f"| {name_of} | {value}{f' of {most}' if most else ''} |\n"
    routed = "" if clocks else "Not routed yet: these are Yosys' cells. "
    return f"{text}\n{routed}`make board BOARD={name}` at commit {commit} of {day}.\n"


def commit():
    """Of the sources as they are."""
    print(*measured.commit())


def main(name, folder):
    """What synth/board.sh left in a folder, into DATA."""
    found = read(Path(folder))
    rows = "".join(f"{row}\t{value}\n" for row, value in found.items())
    intact.write(DATA.format(name), HEAD.format(name) + rows)
