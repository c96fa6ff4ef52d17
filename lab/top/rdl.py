# rdl.py - the register list of rt_top as systemrdl-compiler reads it, against the C header
# SPDX-License-Identifier: Apache-2.0
"""Says how many registers there are, or what differs from driver/sphaera_regs.h; exits with 1
then."""
import re
from pathlib import Path

from systemrdl import RDLCompiler

HEADER = Path("driver/sphaera_regs.h")


def header():
    """({register: offset}, {register_FIELD: mask}) of the C header."""
    text = HEADER.read_text(encoding="utf-8")
    offsets = re.findall(r"#define SPHAERA_(\w+) (0x\w{3})u /\* (?:ro|rw|wo|w1c):", text)
    machine = int(re.search(r"SPHAERA_MACHINE (0x\w+)u", text)[1], 16)
    offsets += [(f"M_{name}", hex(machine + 4 * int(number)))
                for name, number in re.findall(r"SPHAERA_REG_(\w+) (\d+)u", text)]
    masks = re.findall(r"#define SPHAERA_(\w+) (0x\w{8})u /\*", text)
    return ({name: int(value, 16) for name, value in offsets},
            {name: int(value, 16) for name, value in masks})


def main(path):
    compiler = RDLCompiler()
    compiler.compile_file(path)
    registers = list(compiler.elaborate().top.registers())
    offsets, masks = header()
    found = {r.inst_name: r.absolute_address for r in registers}
    fields = {f"{r.inst_name}_{f.inst_name}": (1 << f.high + 1) - (1 << f.low)
              for r in registers for f in r.fields()}
    wrong = [f"{HEADER}: {name}: {value:#x} is another in {path}"
             for one, other in ((offsets, found), (masks, fields))
             for name, value in one.items() if other.get(name) != value]
    print("\n".join(wrong) if wrong else
          f"rdl: {len(registers)} registers, {len(offsets)} of rt_top and the machine "
          f"as in {HEADER}")
    return bool(wrong)
