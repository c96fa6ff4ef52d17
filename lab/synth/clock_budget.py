# clock_budget.py - is a block, routed alone, as fast as it must be? TAP lines, one a block
# SPDX-License-Identifier: Apache-2.0
"""A block is synthesised by synth/module.sh and routed between registers by synth/place.sh, speed
grade 8, seed 1; BLOCK are modules of the budget, empty: all. What is left of one lies in
BUILD/clock-budget/MODULE. Exits with 1 if a block is slower than its budget. nextpnr-ecp5 is that
of the PATH or the one of `make study-pnr`, which is installed where it is not there."""
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

from ..study import experiment


class Block(NamedTuple):
    """A line of the budget."""
    module: str
    mhz: float
    parameters: list


def read_budget(path):
    """Blocks of a budget; stops with file and line at what is none."""
    blocks = []
    with open(path, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            word = line.split("#")[0].split()
            if not word:
                continue
            if len(word) < 2 or not word[1].isdigit() or not all("=" in p for p in word[2:]):
                sys.exit(f"clock-budget: {path}:{number}: not `module MHz [PARAMETER=VALUE...]`: "
                         f"{line.strip()}")
            blocks.append(Block(word[0], float(word[1]), word[2:]))
    return blocks


def cells(row):
    """Cells in words, of a row of synth/module.sh."""
    mult, lut4eq, ff, bram, dpr = (int(cell) for cell in row.split("|")[2:7])
    return f"{mult} MULT18X18D, {lut4eq} LUT4eq, {ff} FF, {bram} DP16KD, {dpr} TRELLIS_DPR16X4"


def run(block, build):
    """(MHz, cells in words) of a block that is synthesised and routed now."""
    folder = Path(build, "clock-budget", block.module)
    folder.mkdir(parents=True, exist_ok=True)
    row = subprocess.run(["sh", "synth/module.sh", block.module, *block.parameters], check=True,
                         text=True, stdout=subprocess.PIPE,
                         env={**os.environ, "NETLIST": str(folder / "netlist.il")}).stdout
    subprocess.run(["sh", "synth/place.sh", folder, folder], check=True,
                   env={**os.environ, "BUILD": build, "ROUTE": "1", "SEED": "1", "SPEED": "8"})
    placed = json.loads((folder / "placed.json").read_text(encoding="utf-8"))
    return placed["fmax"], cells(row)


def main(build, budget):
    blocks = read_budget(budget)
    asked = os.environ.get("BLOCK", "").split()
    strange = set(asked) - {block.module for block in blocks}
    if strange:
        sys.exit(f"clock-budget: not in {budget}: {' '.join(sorted(strange))}; these are: "
                 f"{' '.join(block.module for block in blocks)}")
    experiment.there(build)
    bad = 0
    for block in blocks:
        if asked and block.module not in asked:
            continue
        mhz, taken = run(block, build)
        ok = mhz >= block.mhz
        bad += not ok
        print(f"{'ok' if ok else 'not ok'} - {block.module}: {mhz:.1f} MHz of {block.mhz:.0f}, "
              f"{taken}", flush=True)
    sys.exit(bad > 0)
