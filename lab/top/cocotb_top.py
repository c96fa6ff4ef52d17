# cocotb_top.py - rt_top between the masters and slaves of cocotbext-axi, which others wrote
# SPDX-License-Identifier: Apache-2.0
"""Tests that cocotb_run.py runs with the agent of tb/vip/sphaera_cocotb_top.py. MACHINE and FRAME
in the environment name a machine file and the golden model's frame of it."""
import os
import random
import struct

import cocotb
from cocotbext.axi import AxiResp
from sphaera_cocotb_top import STRIDE, TopAgent, registers

from lab.top.golden import golden, machine

REGISTERS = registers(os.environ["RDL"])


class Bench(TopAgent):
    def __init__(self, dut):
        super().__init__(dut, REGISTERS)

    async def load_file(self):
        await self.load(*machine(os.environ["MACHINE"]))

    async def compare(self, half=0):
        start = await self.newest()
        for y, row in enumerate(golden(os.environ["MACHINE"], os.environ["FRAME"])):
            drawn = struct.unpack_from(f"<{len(row)}{'IH'[half]}", self.memory, start + STRIDE * y)
            if half:  # RGB565
                row = [c >> 8 & 0xf800 | c >> 5 & 0x7e0 | c >> 3 & 31 for c in row]
            assert list(drawn) == row, f"row {y}: {drawn} is not {row}"


@cocotb.test()
async def every_register(dut):
    """Resets, then what is read and written: as the SystemRDL text says."""
    bench = Bench(dut)
    await bench.start()
    bench.pauses(30)
    written = {}
    bus = await bench.get("CORE_BUS")
    absent = {"LAYER_BYTES": not bus >> 9 & 1, "ADDRESS_HIGH": bus >> 10 & 63 == 32}
    builds = bus >> 16 & 31
    for name, node in REGISTERS.items():
        if absent.get(name) or (name.startswith("BUILD_") and not builds):
            assert (await bench.lite.read(node.absolute_address, 4)).resp == AxiResp.SLVERR
            continue
        value = await bench.get(name)
        for field in node.fields():
            reset = field.get_property("reset")
            if reset is not None:
                assert value >> field.low & (1 << field.width) - 1 == reset, (name, field.inst_name)
        if name == "CONTROL":
            continue
        keeps = sum((1 << f.high + 1) - (1 << f.low) for f in node.fields()
                    if f.is_sw_writable and f.get_property("onwrite") is None)
        if name == "INTERRUPT_ENABLE" and not builds:
            keeps &= 15
        new = random.getrandbits(32)
        await bench.put(name, new)
        changes = any(f.get_property("onwrite") for f in node.fields())
        if keeps or not (changes or name.startswith(("STATUS", "C_"))):
            written[name] = new & keeps if keeps else value
    for name, value in written.items():
        assert await bench.get(name) == value, name
    assert (await bench.lite.read(0xffc, 4)).resp == AxiResp.SLVERR


@cocotb.test()
async def frame(dut):
    """A frame of each format with channels that pause, all of it as the golden model draws it, by
    bursts of every length that the block has: a line, eight pixels of 32 bits, eight of 16."""
    bench = Bench(dut)
    await bench.start()
    bench.pauses(int(os.environ.get("PAUSES", "40")))
    await bench.load_file()
    for half in (0, 1):
        await bench.put("FORMAT", half)
        assert await bench.draw() == 0
        await bench.compare(half)
    scene, store = len(dut.m_scene_rdata) // 8, len(dut.m_frame_wdata) // 8
    assert bench.lengths == {"scene_ar": {32 // scene}, "frame_aw": {32 // store, 16 // store}}
    assert bench.reads.overtakes and (scene == 32 or bench.reads.alternates)


@cocotb.test()
async def errors(dut):
    """An error of each bus; the frame behind it is whole."""
    bench = Bench(dut)
    await bench.start()
    await bench.load_file()
    for slave, bit in ((bench.reads, 8), (bench.writes, 10)):
        slave.bad = (slave.answers + 5,)
        assert await bench.draw() >> bit & 1
        assert await bench.get("FRAME_COUNT") == (bit == 10)
        assert await bench.draw() == 0
        await bench.compare()
