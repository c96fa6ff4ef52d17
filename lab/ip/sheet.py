# sheet.py - the data sheet of a configuration: one page of Markdown
# SPDX-License-Identifier: Apache-2.0
from pathlib import Path

from .. import clocks
from ..pages import data, markdown
from ..pages.cores import COLUMNS
from ..synth import results
from . import ports

START = 8           # clocks of START beside those of registers and of the first pixel's place
SCENES = 5          # with the fewest clocks


def memory(p):
    """Rows of what the masters move at most."""
    lines = p["MEM_PENDING"] or p["MEM_DATA"]
    return [
        ["scene, at most", f"{p['MEM_DATA'] // 8} bytes a clock, a line of 32 bytes in "
                           f"{256 // p['MEM_DATA']} clocks"],
        ["scene, at latency L", f"{lines} lines in flight: {32 * lines} / L bytes a clock; full "
                                f"rate up to L = {lines * 256 // p['MEM_DATA']} clocks"],
        ["frame store", f"{p['DATA'] // 8} bytes a clock at most; 4 bytes a pixel, "
                        f"{12 if p['LAYERS'] else 4} with layers" if p["LAYERS"] else
                        f"{p['DATA'] // 8} bytes a clock at most; 4 bytes a pixel, RGB565 2"]]


def speed(core, shell):
    """Rows of MHz: of the very core and block, or that nobody has routed them."""
    return [["rt_top, MHz", clocks.mhz(shell) if shell else clocks.NOT],
            ["rt_core alone, MHz", clocks.mhz(core)]]


def cells(build, *keys):
    """A row of cells of each key that was synthesised here."""
    rows = []
    for key in keys:
        folder = Path(build, "synth", key) if key else None
        if folder and (folder / "stat.json").exists():
            has = results.read(folder)["core"]
            rows.append([f"`{key}`", ", ".join(f"{has[c]} {h}" for c, h in COLUMNS.items())])
    return rows or [["cells", "not synthesised here: `make synth`"]]


def frames(profile, p):
    """Rows of measured frames of 160 x 120 pixels, memory that answers after 100 clocks."""
    head, rows = data.read("cycles")
    accel = "bih" if p["ACCEL"] else "box4" if p["BOXES"] else "auto"
    found = [dict(zip(head, row)) for row in rows]
    found = [(int(r["RTL"]), r["scene"]) for r in found if r["RTL"].isdigit() and (
        r["profile"], r["accel"], r["pipes"]) == (profile, accel, str(p["PIPES"]))]
    return [[f"`{scene}`", f"{n} clocks, {n / 19200:.2f} a pixel"]
            for n, scene in sorted(found)[:SCENES]] or [["frames", "none measured"]]


def text(build, name, release, profile, p, registers, keys, netlist, crossings,
         inside):
    """p: {parameter: value}; keys: of rt_core and rt_top as synth/core.sh has them;
    netlist, inside: of rt_top, of rt_core."""
    core, shell = keys
    first = registers + START
    rows = [["release", release], ["core", f"`{name}`"],
            ["START to the first ray", f"{first} clocks, WIN_X0 + WIN_Y0 more"],
            ["visits", f"{p['ENGINES'] * p['PIPES']} nodes a clock at most"],
            ["background pixels", "1 a clock at most"],
            ["rays in flight", str(p["SLOTS"] * p["PIPES"] * p["ENGINES"])],
            *memory(p), *speed(core, shell), *cells(build, core, shell)]
    shown = " ".join(f"{n}={v}" for n, v in p.items())
    return f"""<!-- SPDX-License-Identifier: Apache-2.0 -->
# rt_top {release}: {name}

{markdown.table(["", ""], rows)}

MHz: ECP5, LFE5UM5G-85F, speed grade 8, median of seeds. Frames of 160 x 120 pixels in the RTL of
such a core, memory that answers after 100 clocks:

{markdown.table(["scene", "frame"], frames(profile, p))}

Clocks: {', '.join(netlist.clocks)}; crossings: {crossings}. Parameters: {shown}

## Ports of rt_top

{markdown.table(ports.HEAD, ports.table(netlist))}

## Ports of rt_core in it

{markdown.table(ports.HEAD, ports.table(inside))}
"""
