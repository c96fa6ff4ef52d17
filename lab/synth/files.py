# files.py - cells of large slot files, read at once or at the falling edge, of each family
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `falling` into PAGE: rt_slot_file alone, as synth/target.sh maps it."""
import re
import subprocess

from ..pages.place import place
from .results import COLUMNS

FILES = (61, 64), (134, 16), (48, 64), (32, 64)
MAPPED = """target={target} top=rt_slot_file flat=1; . synth/target.sh
yosys -q -p "read_verilog -DSYNTHESIS $defines -Irtl/memory rtl/memory/rt_slot_file.v
    chparam -set WIDTH {width} -set SLOTS {slots} -set FALLING {falling} rt_slot_file
    $map; tee -o /dev/stdout stat" """


def cells(target, width, slots, falling):
    """What it is mapped to, in words."""
    said = subprocess.run(["sh", "-c", MAPPED.format(**locals())], check=True, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    found = dict(re.findall(r"^ +(\w+) +(\d+)$", said, re.M))
    counts = ((head, sum(weight * int(n) for pattern, weight in weights.items()
                         for cell, n in found.items() if re.fullmatch(pattern, cell)))
              for name, weights, head in COLUMNS[target] if name not in ("lut4eq", "places"))
    return ", ".join(f"{n} {head}" for head, n in counts if n) or "-"


def rows():
    yield ["file", "target", "read at once", "read at the falling edge"]
    for width, slots in FILES:
        for target in COLUMNS:
            if target != "generic":
                yield [f"{width} x {slots}", target,
                       *(cells(target, width, slots, falling) for falling in (0, 1))]


def main(page):
    place(page, "make falling", {"falling": list(rows())})
