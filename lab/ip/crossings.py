# crossings.py - every path between clocks in rt_top, the SDRAM's bus and the boards, by its netlist
# SPDX-License-Identifier: Apache-2.0
"""Demands of each that it is one of those that constraints.py allows, as check_crossings.py has it:
rt_sync of two flip-flops that nothing stands before, rt_async_fifo, a register that stands still.
Input ports of a board are of no clock: they come to the first flip-flop of rt_sync, or to none.
rt_top is the smallest with video and layers. --rtl: another folder than rtl. A line a top."""
import sys
import tempfile
from pathlib import Path

from . import check_crossings, constraints, folder
from .netlist import Netlist

BOARDS = "rt_ulx3s_ram", "rt_ulx3s_sdram"
TOPS = "rt_top", "rt_sdram_bus", *BOARDS


def unsynchronised(netlist):
    """Input ports of a board that a register takes without rt_sync."""
    ports = {name: bits for name, (way, bits) in netlist.ports.items() if way == "input"}
    return [f"port {name} comes to {state.name} ({state.clock}) without rt_sync"
            for state in netlist.states.values() if state.clock
            for name in ports
            if any(netlist.come_from(bit) & netlist.mask[f"port {name}"] for bit in state.takes)
            and not constraints.synchronises(state)]


def check(top, rtl, work):
    """(what is wrong, crossings, clocks)"""
    values = folder.parameters("draft", "none", ("VIDEO=1", "LAYERS=1"))[0] \
        if top == "rt_top" else {}
    folder.elaborated(top, values, work / "netlist.json", work, rtl)
    netlist = Netlist(work / "netlist.json")
    allowed = work / f"{top}.sdc"
    allowed.write_text(constraints.sdc(constraints.crossings(netlist), netlist.clocks))
    wrong = unsynchronised(netlist) if top in BOARDS else check_crossings.ports(netlist)
    more, number = check_crossings.check(netlist, str(allowed))
    return [line.removeprefix(f"{allowed}: ") for line in wrong + more], number, netlist.clocks


def main(*tops, rtl="rtl"):
    failed = False
    for top in tops or TOPS:
        with tempfile.TemporaryDirectory() as work:
            wrong, number, clocks = check(top, rtl, Path(work))
        failed = failed or bool(wrong)
        for line in wrong:
            print(f"# {line}")
        print(f"{'not ok' if wrong else 'ok'} - {top}: {number} crossings of {len(clocks)} clocks")
    return int(failed)
