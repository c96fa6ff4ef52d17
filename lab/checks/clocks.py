# clocks.py - clocks of cores, and what follows from them, on placements that are made up
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.clocks FOLDER
Changes docs/results/data/clocks.tsv and README.md, so it runs in a copy of the tree; FOLDER is new.
"""
import json
import subprocess
import sys
from pathlib import Path

from .. import clocks
from ..pages import rates, told

SPHERES = "standard-ecp5-shadow+reflect2+lights3+inside-engines1"
PIPES3 = "standard-ecp5-shadow+reflect2+lights3+inside+spans-engines1-pipes3"
OTHER = "standard-ecp5-lights1+facets+bih-engines1"
folder = Path(sys.argv[1])


def placed(core, routed, reached):
    """As `make study-seeds` leaves it; then the rows of its core."""
    (folder / "core").mkdir(parents=True, exist_ok=True)
    (folder / "core/stat.json").write_text('{"creator": "Yosys 0.23 (git sha1 7ce5)"}')
    for seed, mhz in enumerate(reached, 1):
        (folder / f"8-{seed}").mkdir(exist_ok=True)
        (folder / f"8-{seed}/placed.json").write_text(json.dumps(
            {"fmax": mhz, "routed": routed, "nextpnr": "nextpnr-0.11.1"}))
    seeds = [f"8-{seed}" for seed in range(1, len(reached) + 1)]
    subprocess.run([sys.executable, "-m", "lab", "seeds", core, folder / "core", folder,
                    *seeds], check=True)
    return [row for row in clocks.rows() if row["core"] == core]


# ---- of that very core, routed, or none ----
assert clocks.clock(SPHERES).seeds == clocks.SEEDS and clocks.mhz(SPHERES)[-1].isdigit()
for core in OTHER, SPHERES + "-pipes2", "fine-" + SPHERES, PIPES3:
    assert clocks.clock(core) is None and clocks.mhz(core) == "not routed", core
    assert clocks.frames(core, 1e6) == clocks.milliseconds(core, 1e6) == "not routed", core
assert "placement" in [row["after"] for row in clocks.rows() if row["core"] == PIPES3]

# ---- placed alone it is in the table, and has no rate; routed it has, of the median ----
before = len(clocks.rows())
rows = placed(OTHER, 0, [90.0])
assert len(rows) == 1 and clocks.frames(OTHER, 1e6) == "not routed", rows
rows = placed(OTHER, 1, [50.0, 40.0])
assert len(rows) == 2 and clocks.mhz(OTHER) == "45.0 (2 seeds)", rows
rows = placed(OTHER, 1, [50.0, 40.0, 42.0, 44.0, 70.0])
assert len(rows) == 2 and len(clocks.rows()) == before + 2 and clocks.mhz(OTHER) == "44.0", rows
of = next(row for row in rows if row["after"] == "routing")
assert [of[c] for c in ("what", "worst, MHz", "best, MHz", "tools")] == \
    ["rt_core", "40.0", "70.0", "Yosys 0.23, nextpnr-ecp5 0.11.1"], of
assert f"SEEDS_CORE={OTHER} SEEDS='8-1 8-2 8-3 8-4 8-5'" in of["command"], of
assert clocks.frames(OTHER, 2e6) == "22.0" and clocks.milliseconds(OTHER, 88e3) == "2.00"
assert placed(OTHER + "-top", 1, [9.0])[0]["what"] == "rt_top"

# ---- pages follow: 640 x 1088 pixels of 14.18 clocks at 44 MHz ----
row = next(row for row in rates.rows("scenarios") if row["tree"] == "bih1")
clock = 44e6 / 640 / 1088 / float(row["cycles a pixel"])
assert row["MHz"] == "44.0" and row["frames/s"] == f"{clock:.2f}", row
placed(SPHERES, 1, [100.0] * 5)
check = subprocess.run([sys.executable, "-m", "lab", "pages", "--check", "README.md"], check=False,
                       stdout=subprocess.PIPE, text=True)
assert check.returncode and "-->100.0<!-- end --> MHz" in check.stdout, check.stdout

# ---- what a page tells by hand ----
TEXT = """At <!-- begin: clock x -->127.5<!-- end --> MHz, of 84 MHz; 9.6 frames
a second in 8 ms; 3 ms of build, 1.3 million rays/s.
| scene | frames/s | MHz |
|---|---|---|
| a | <!-- begin: frames x -->7<!-- end --> | 1 |
"""
found = [figure for _, figure in told.by_hand(TEXT)]
assert found == ["84 MHz", "9.6 frames a second", "in 8 ms", "1.3 million rays/s",
                 "the column frames/s", "the column MHz"], found
