# cocotb_top.py - rt_top between the masters and slaves of cocotbext-axi, which others wrote
# SPDX-License-Identifier: Apache-2.0
"""Tests that cocotb_run.py runs. MACHINE and FRAME in the environment name a machine file and the
golden model's frame of it."""
import os
import random
import struct

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotbext.axi import (AxiLiteBus, AxiLiteMaster, AxiReadBus, AxiResp, AxiSlaveRead,
                           AxiSlaveWrite, AxiWriteBus)
from systemrdl import RDLCompiler

from lab.top.golden import golden, machine

SCENE, STORE, APART, STRIDE = 0x4000, 0x100000, 0x10000, 256
HIGH = 0x5a     # bits 39..32 of every address, where there are any


def registers():
    """{name: node} as the SystemRDL text has them."""
    compiler = RDLCompiler()
    compiler.compile_file(os.environ["RDL"])
    return {node.inst_name: node for node in compiler.elaborate().top.registers()}


REGISTERS = registers()


class Memory(bytearray):
    """Seen from address `high` on alone."""
    high = 0

    def __getitem__(self, at):
        return super().__getitem__(self.low(at))

    def __setitem__(self, at, value):
        super().__setitem__(self.low(at), value)

    def low(self, at):
        if isinstance(at, int):
            return at
        start, stop = at.start - self.high, at.stop - self.high
        assert 0 <= start < stop <= len(self), f"an address beyond memory: {at.start:#x}"
        return slice(start, stop)


class Reads(AxiSlaveRead):
    """Memory that answers in any order of IDs, and alternates their beats; the answers whose
    numbers are in `bad` are errors. So many bursts wait before it answers one."""
    bad = ()
    answers = 0
    WAITING = 4
    overtakes = alternates = 0  # beats of a burst with older ones before it; of another than before

    async def _process_read(self):
        bursts, before = [], None
        while True:
            patience = 20  # clocks, if there are not so many
            while len(bursts) < self.WAITING and (patience or not bursts):
                if self.ar_channel.empty():
                    patience = max(patience - 1, 0)
                    await RisingEdge(self.clock)
                else:
                    ar = await self.ar_channel.recv()
                    bursts.append([int(ar.arid), int(ar.araddr), int(ar.arlen) + 1])
            firsts = {}  # of each ID
            for burst in bursts:
                firsts.setdefault(burst[0], burst)
            burst = random.choice(list(firsts.values()))
            self.overtakes += burst is not bursts[0]
            self.alternates += before in bursts and burst is not before
            before = burst
            r = self.r_channel._transaction_obj()
            self.answers += 1
            wrong = self.answers in self.bad
            r.rid, r.rlast = burst[0], burst[2] == 1
            r.rresp = AxiResp.SLVERR if wrong else AxiResp.OKAY
            r.rdata = int.from_bytes(self.target[burst[1]:burst[1] + self.byte_lanes], "little")
            burst[1:] = burst[1] + self.byte_lanes, burst[2] - 1
            if not burst[2]:
                bursts.remove(burst)
            await self.r_channel.send(r)


class Writes(AxiSlaveWrite):
    bad = ()
    answers = 0

    async def _write(self, address, data, **_):
        self.answers += 1
        if self.answers in self.bad:
            raise IOError
        self.target[address:address + len(data)] = data


class Bench:
    def __init__(self, dut):
        self.dut = dut
        self.memory = Memory(0x200000)
        cocotb.start_soon(Clock(dut.clk, 10, "ns").start())
        self.lite = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axil"), dut.clk, dut.rst)
        self.reads = Reads(AxiReadBus.from_prefix(dut, "m_scene"), dut.clk, dut.rst,
                           target=self.memory)
        self.writes = Writes(AxiWriteBus.from_prefix(dut, "m_frame"), dut.clk, dut.rst,
                             target=self.memory)
        self.lengths = {"scene_ar": set(), "frame_aw": set()}  # beats of bursts that were taken
        for name in self.lengths:
            cocotb.start_soon(self.watch(name))

    async def watch(self, name):
        valid, ready, length = (getattr(self.dut, f"m_{name}{what}")
                                for what in ("valid", "ready", "len"))
        while True:
            await RisingEdge(self.dut.clk)
            if self.dut.rst.value == 0 and valid.value == 1 and ready.value == 1:
                self.lengths[name].add(int(length.value) + 1)

    async def start(self):
        self.dut.rst.value = 1
        await ClockCycles(self.dut.clk, 4)
        self.dut.rst.value = 0
        await ClockCycles(self.dut.clk, 2)

    def pauses(self, percent):
        """Every channel waits in so many of its clocks."""
        def generator():
            while True:
                yield random.randrange(100) < percent
        for channel in (self.lite.write_if.aw_channel, self.lite.write_if.w_channel,
                        self.lite.write_if.b_channel, self.lite.read_if.ar_channel,
                        self.lite.read_if.r_channel, self.reads.ar_channel, self.reads.r_channel,
                        self.writes.aw_channel, self.writes.w_channel, self.writes.b_channel):
            channel.set_pause_generator(generator())

    async def get(self, name):
        answer = await self.lite.read(REGISTERS[name].absolute_address, 4)
        assert answer.resp == AxiResp.OKAY, name
        return int.from_bytes(answer.data, "little")

    async def put(self, name, value):
        answer = await self.lite.write(REGISTERS[name].absolute_address,
                                       value.to_bytes(4, "little"))
        assert answer.resp == AxiResp.OKAY, name

    async def draw(self):
        """The errors of a frame."""
        await self.put("ERRORS", 0xffffffff)
        await self.put("CONTROL", 1)
        while await self.get("STATUS") & 1:
            await ClockCycles(self.dut.clk, 50)
        return await self.get("ERRORS")

    async def load(self):
        values, memory = machine(os.environ["MACHINE"])
        if await self.get("CORE_BUS") >> 10 & 63 > 32:
            self.memory.high = HIGH << 32
            await self.put("ADDRESS_HIGH", HIGH * 0x01010101)
        at = self.memory.high + SCENE
        self.memory[at:at + len(memory)] = memory
        base = REGISTERS["M_EFFECTS"].absolute_address
        for number, value in enumerate(values):
            await self.lite.write(base + 4 * number, value.to_bytes(4, "little"))
        await self.put("SCENE_BASE", SCENE)
        await self.put("STRIDE", STRIDE)
        for frame in range(3):
            await self.put(f"FRAME{frame}", STORE + APART * frame)

    async def compare(self, half=0):
        newest = await self.get("STATUS") >> 6 & 3
        for y, row in enumerate(golden(os.environ["MACHINE"], os.environ["FRAME"])):
            at = STORE + APART * newest + STRIDE * y
            drawn = struct.unpack_from(f"<{len(row)}{'IH'[half]}", self.memory, at)
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
    for name, node in REGISTERS.items():
        if absent.get(name):
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
    await bench.load()
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
    await bench.load()
    for slave, bit in ((bench.reads, 8), (bench.writes, 10)):
        slave.bad = (slave.answers + 5,)
        assert await bench.draw() >> bit & 1
        assert await bench.get("FRAME_COUNT") == (bit == 10)
        assert await bench.draw() == 0
        await bench.compare()
