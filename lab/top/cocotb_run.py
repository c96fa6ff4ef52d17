# cocotb_run.py - builds rt_top with IDs on both buses in Icarus and runs the tests of cocotb_top.py
# SPDX-License-Identifier: Apache-2.0
"""NAME=VALUE: parameters of the core. Exits with 1 if a test fails. simulate() runs the tests of a
module on any top, wrapper() makes one of rt_top."""
import re
import sys
from pathlib import Path

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

BUSES = r"clk|rst|irq_o|s_axil_\w+|m_scene_\w+|m_frame_\w+"   # no display, nobody reads frames
SIZES = [(size, size) for size in ("DATA", "MEM_DATA", "ADDR")]   # of the wrapper, handed on
IDS = {"m_frame_bid": "input [`RT_TAG_BITS-1:0]"}     # what cocotbext-axi gives besides
WRAPPER = """\
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module cocotb_top #(
    parameter DATA = 64,
    parameter MEM_DATA = 64,
    parameter ADDR = 32
) (
{ports}
);
    rt_top #({parameters}) u_top (
{connections}
    );
endmodule
`default_nettype wire
"""


def wrapper(parameters):
    """rt_top with the ports of its buses and their IDs."""
    head = Path("rtl/top/rt_top.v").read_text(encoding="utf-8").partition("\n);")[0]
    ports, connections = [], []
    for way, bits, name in re.findall(r"^    (input|output) +wire *(\[.*?\])? *(\w+)", head, re.M):
        if re.fullmatch(BUSES, name):
            ports.append(f"    {way} wire {bits} {name}")
        zero = f"{{{bits[1:-3]}+1{{1'b0}}}}" if bits else "1'b0"
        of = name if re.fullmatch(BUSES, name) else zero if way == "input" else ""
        connections.append(f"        .{name}({of})")
    ports += [f"    {way} {name}" for name, way in IDS.items()]
    return WRAPPER.format(ports=",\n".join(ports), connections=",\n".join(connections),
                          parameters=", ".join(f".{name}({value})" for name, value in parameters))


def simulate(name, folder, module, environment, parameters, wrapped=None, rtl="rtl"):
    """Builds in FOLDER by Icarus the sources of a folder: rt_core, or the wrapper() of rt_top with
    `wrapped`, with parameters; and runs the tests of a module, which find the environment's files
    and rt_top.rdl in it. 1 if one fails."""
    sources = sorted(path for path in Path(rtl).rglob("*.v") if "board" not in path.parts)
    top = "rt_core"
    if wrapped is not None:
        top = "cocotb_top"
        sources.append(Path(folder, f"{top}.v"))
        sources[-1].parent.mkdir(parents=True, exist_ok=True)
        sources[-1].write_text(wrapper(wrapped), encoding="utf-8")
    runner = get_runner("icarus")
    runner.build(sources=sources, hdl_toplevel=top, build_args=["-g2005"], build_dir=folder,
                 includes=sorted({path.parent for path in Path(rtl).rglob("*.vh")}),
                 parameters=parameters, always=True)
    files = {"RDL": "docs/reference/rt_top.rdl", **environment}
    results = runner.test(test_module=module, hdl_toplevel=top, build_dir=folder, test_dir=folder,
                          extra_env={"COCOTB_LOG_LEVEL": "WARNING",
                                     **{word: str(Path(of).resolve())
                                        for word, of in files.items()}})
    tests, failed = get_results(results)
    print(f"cocotb, {name}: {tests - failed} of {tests} tests passed")
    return failed > 0


def main(folder, machine, frame, data, *parameters):
    sys.path += [str(Path(name).resolve()) for name in (".", "tb/vip")]  # cocotb hands them on
    return simulate(f"{data} bits", folder, "lab.top.cocotb_top",
                    {"MACHINE": machine, "FRAME": frame},
                    {"DATA": min(int(data), 128), "MEM_DATA": data,
                     "ADDR": 40 if data == "128" else 32},
                    [*SIZES, *(word.split("=") for word in parameters)])
