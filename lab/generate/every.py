# every.py - what follows from definitions and lists of files: headers, lines at ports, lists
# SPDX-License-Identifier: Apache-2.0
"""Of machine.def, top.def, bundles.def, modes.def, VERSION and the files of rtl, into FOLDER if it
is given, else in their places. A file that stays the same keeps its time. --check-ports looks at
the fields of bundles beside ports and writes nothing: exit code 1 if one is not as it would be."""
import os

from sim.definition import Definition

from .. import intact
from . import bundles, files, layout, modes, ports, top


def every():
    """(name of a file, its text)"""
    machine = Definition()
    registers = top.Registers(machine)
    signals = bundles.Bundles(machine)
    yield "cmodel/machine/layout.h", layout.c(machine)
    for name, text in layout.verilog(machine):
        yield f"rtl/core/rt_{name}.vh", text
    yield "rtl/video/rt_modes.vh", modes.Modes().verilog()
    yield "driver/sphaera_modes.h", modes.Modes().c()
    yield "rtl/top/rt_top.vh", registers.verilog()
    yield "driver/sphaera_regs.h", registers.c()
    yield "docs/reference/rt_top.rdl", registers.rdl()
    yield "rtl/engine/rt_bundles.vh", signals.text("v")
    yield "tb/bundles.h", signals.text("c")
    yield from ports.anew(machine, signals)
    yield from files.lists()


def main(folder=None, check_ports=False):
    if check_ports:
        machine = Definition()
        wrong = list(ports.wrong(machine, bundles.Bundles(machine)))
        print(*wrong, sep="\n", end="\n" * bool(wrong))
        return 1 if wrong else 0
    for name, text in list(every()):    # nothing is written if one of them is unsound
        name = os.path.join(folder, os.path.basename(name)) if folder else name
        os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
        with intact.beside(name, anew=True) as new, open(new, "w", encoding="utf-8") as f:
            f.write(text)
    return 0
