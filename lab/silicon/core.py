# core.py - a core in standard cells: the program that simulates it, its times, areas, energies
# SPDX-License-Identifier: Apache-2.0
"""Of NETLIST, flat, by synth/silicon.sh, and LIB, its library in Liberty format, writes into FOLDER
core.so, which tb_core_netlist simulates, and core.json: areas, energies of each net and memory, and
the slowest paths if OpenSTA is there."""
import json
import sys
from pathlib import Path

from .. import intact
from . import energy, liberty, macros, netlist, program, timing


def main(path, lib, table, folder):
    folder = Path(folder)
    try:
        library = liberty.read(lib)
        memories = macros.read(table, library)
        cells = netlist.read(path, library)
        layout = program.Layout(cells)
        known = energy.characterise(cells, layout, library, memories)
        known["timing"] = timing.run(cells, library, memories, folder)
    except liberty.Bad as error:
        sys.exit(f"silicon: {error}")
    intact.write(folder / "core.json", json.dumps(known) + "\n")
    program.build(layout, folder / "core.so")   # last: it is what make looks for


def buffer(lib):
    """Prints the smallest cell that repeats its input."""
    try:
        library = liberty.read(lib)
    except liberty.Bad as error:
        sys.exit(f"silicon: {error}")
    found = [cell for cell in library.cells.values()
             if len(cell.inputs) == len(cell.outputs) == 1 and cell.outputs[0].function
             and cell.outputs[0].function.code == cell.inputs[0].name
             and not (cell.register or cell.other or cell.outputs[0].three_state)]
    if not found:
        sys.exit(f"silicon: {lib}: no cell repeats its input")
    print(min(found, key=lambda cell: cell.area).name)
