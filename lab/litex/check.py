# check.py - what the firmware told in LiteX's simulator, against the golden model
# SPDX-License-Identifier: Apache-2.0
"""Exits with 1 if a pixel differs, the firmware does not end well, the display had no pixel in
time, or LiteDRAM's model of the SDRAM tells a command that came too soon."""
import re
import sys
from pathlib import Path

from lab.top.golden import golden


def faults(told, rows):
    """What is wrong, as text; none if all is right."""
    if "sphaera: done, interrupt pending\n" not in told:
        yield "the firmware did not say: done, interrupt pending"
    if "\ndone, frames drawn" not in told:
        yield "the frames behind the first did not all end well"
    if "\nunderruns: 0x00000000\n" not in told:
        yield "the display had no pixel in time"
    if "violation" in told:
        yield "LiteDRAM's model tells a violation"
    drawn = [[int(row[at:at + 4], 16) for at in range(0, len(row), 4)]
             for row in re.findall(r"^row ([0-9a-f]+)$", told, re.M)]
    if len(drawn) != len(rows):
        yield f"{len(drawn)} rows of {len(rows)}"
    for y, (is_row, row) in enumerate(zip(drawn, rows)):
        want = [(c >> 19 & 31) << 11 | (c >> 10 & 63) << 5 | c >> 3 & 31 for c in row]
        for x, (pixel, wanted) in enumerate(zip(is_row, want)):
            if pixel != wanted:
                yield f"pixel {x}, {y} is {pixel:04x}, not {wanted:04x}"
        if len(is_row) != len(want):
            yield f"row {y} has {len(is_row)} pixels of {len(want)}"


def main(log, machine, frame):
    told = Path(log).read_text(encoding="utf-8", errors="replace")
    rows = list(golden(machine, frame))
    wrong = list(faults(told, rows))
    for text in wrong[:5]:
        print(f"litex-sim: {text}", file=sys.stderr)
    if not wrong:
        clocks, = re.findall(r"^clocks: 0x(\w+)$", told, re.M)
        frames, = re.findall(r"frames drawn: 0x(\w+)$", told, re.M)
        print(f"ok - litex-sim: {len(rows[0])}x{len(rows)} as the golden model has it, "
              f"{int(clocks, 16)} clocks; {int(frames, 16)} frames drawn while the display showed "
              "3, no underrun")
    return bool(wrong)
