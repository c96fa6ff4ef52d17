# cocotb_run.py - builds rt_top with IDs on both buses in Icarus and runs the tests of cocotb_top.py
# SPDX-License-Identifier: Apache-2.0
"""NAME=VALUE: parameters of the core. Exits with 1 if a test fails."""
import re
import sys
from pathlib import Path

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

BUSES = r"clk|rst|irq_o|s_axil_\w+|m_scene_\w+|m_frame_\w+"   # no display, nobody reads frames
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


def main(folder, machine, frame, data, *parameters):
    sys.path += [str(Path(name).resolve()) for name in (".", "tb/vip")]  # cocotb hands them on
    sources = sorted(path for path in Path("rtl").rglob("*.v") if "board" not in path.parts)
    runner = get_runner("icarus")
    top = Path(folder, "cocotb_top.v")
    top.parent.mkdir(parents=True, exist_ok=True)
    top.write_text(wrapper([("DATA", "DATA"), ("MEM_DATA", "MEM_DATA"), ("ADDR", "ADDR"),
                            *(word.split("=") for word in parameters)]), encoding="utf-8")
    runner.build(sources=[*sources, top], hdl_toplevel="cocotb_top",
                 includes=sorted({path.parent for path in Path("rtl").rglob("*.vh")}),
                 build_args=["-g2005"],
                 parameters={"DATA": min(int(data), 128), "MEM_DATA": data,
                             "ADDR": 40 if data == "128" else 32}, build_dir=folder,
                 always=True)
    results = runner.test(test_module="lab.top.cocotb_top", hdl_toplevel="cocotb_top",
                          build_dir=folder, test_dir=folder, extra_env={
                              "MACHINE": str(Path(machine).resolve()),
                              "FRAME": str(Path(frame).resolve()),
                              "RDL": str(Path("docs/reference/rt_top.rdl").resolve()),
                              "COCOTB_LOG_LEVEL": "WARNING"})
    tests, failed = get_results(results)
    print(f"cocotb, {data} bits: {tests - failed} of {tests} tests passed")
    return failed > 0
