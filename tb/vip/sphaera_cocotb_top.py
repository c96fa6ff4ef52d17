# sphaera_cocotb_top.py - agent of rt_top for cocotb: AXI masters and slaves of cocotbext-axi
# SPDX-License-Identifier: Apache-2.0
"""Needs cocotb 2, cocotbext-axi and systemrdl-compiler. Without a machine of the package sphaera it
drives the block; with one, score() compares a frame and its counters."""
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotbext.axi import (AxiLiteBus, AxiLiteMaster, AxiReadBus, AxiResp, AxiSlaveRead,
                           AxiSlaveWrite, AxiWriteBus)
from sphaera_coverage import Coverage
from systemrdl import RDLCompiler

SCENE, STORE, APART, STRIDE = 0x4000, 0x100000, 0x10000, 256
SNAPSHOT = 1 << 5   # of CONTROL
HIGH = 0x5a     # bits 39..32 of every address, where there are any


def registers(path):
    """{name: node} as a SystemRDL text, docs/reference/rt_top.rdl, has them."""
    compiler = RDLCompiler()
    compiler.compile_file(str(path))
    return {node.inst_name: node for node in compiler.elaborate().top.registers()}


class Memory(bytearray):
    """Seen from address `high` on alone."""
    high = 0

    def __getitem__(self, at):
        return super().__getitem__(self.low(at))

    def __setitem__(self, at, value):
        super().__setitem__(self.low(at), value)

    def low(self, at):
        """The same place from 0 on. AssertionError: it lies beyond memory."""
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


class TopAgent:
    """rt_top between a master of its registers and slaves of its two buses."""

    def __init__(self, dut, named):
        """dut: rt_top, whose ports have its names. named: registers()."""
        self.dut, self.registers = dut, named
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
        """Bursts that were taken, by their lengths."""
        valid, ready, length = (getattr(self.dut, f"m_{name}{what}")
                                for what in ("valid", "ready", "len"))
        while True:
            await RisingEdge(self.dut.clk)
            if self.dut.rst.value == 0 and valid.value == 1 and ready.value == 1:
                self.lengths[name].add(int(length.value) + 1)

    async def start(self):
        """Resets it."""
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
        """The word of a register. AssertionError: it answers with an error."""
        answer = await self.lite.read(self.registers[name].absolute_address, 4)
        assert answer.resp == AxiResp.OKAY, name
        return int.from_bytes(answer.data, "little")

    async def put(self, name, value):
        """Writes a register."""
        answer = await self.lite.write(self.registers[name].absolute_address,
                                       value.to_bytes(4, "little"))
        assert answer.resp == AxiResp.OKAY, name

    async def draw(self):
        """A frame; its sticky errors."""
        await self.put("ERRORS", 0xffffffff)
        await self.put("CONTROL", 1)
        while await self.get("STATUS") & 1:
            await ClockCycles(self.dut.clk, 50)
        return await self.get("ERRORS")

    async def load(self, values, memory):
        """A machine's registers and the bytes of its memory."""
        if await self.get("CORE_BUS") >> 10 & 63 > 32:
            self.memory.high = HIGH << 32
            await self.put("ADDRESS_HIGH", HIGH * 0x01010101)
        at = self.memory.high + SCENE
        self.memory[at:at + len(memory)] = memory
        base = self.registers["M_EFFECTS"].absolute_address
        for number, value in enumerate(values):
            await self.lite.write(base + 4 * number, value.to_bytes(4, "little"))
        await self.put("SCENE_BASE", SCENE)
        await self.put("STRIDE", STRIDE)
        for frame in range(3):
            await self.put(f"FRAME{frame}", STORE + APART * frame)

    async def load_machine(self, machine):
        """The same of a sphaera.Machine. AssertionError: its frame does not fit this memory."""
        assert machine.width <= STRIDE // 4 and machine.height <= APART // STRIDE, "too large"
        await self.load([int(word) & 0xffffffff for word in machine.registers],
                        machine.memory.astype("<u4").tobytes())

    async def newest(self):
        """Where pixel 0, 0 of the newest frame stands; rows are STRIDE bytes apart."""
        return STORE + APART * (await self.get("STATUS") >> 6 & 3)

    async def score(self, board, machine):
        """The newest frame, 32 bits a pixel, and the counters, into a sphaera.Scoreboard; how many
        differences there are. It alone needs the package."""
        import sphaera  # pylint: disable=import-outside-toplevel
        start, rows = await self.newest(), memoryview(self.memory)
        for y in range(machine.height):
            at = start + STRIDE * y
            for x in range(machine.width):
                rgb = int.from_bytes(rows[at + 4 * x:at + 4 * x + 4], "little")
                board.colour(x, y, rgb >> 16 & 255 | rgb & 0xff00 | (rgb & 255) << 16)
        await self.put("CONTROL", SNAPSHOT)
        board.counters({name: await self.get(f"C_{name.upper()}_LOW") |
                        await self.get(f"C_{name.upper()}_HIGH") << 32
                        for name in sphaera.exact_counters()})
        return board.end()

    @property
    def coverage(self):
        """What buses and registers have met so far."""
        coverage = Coverage(("scene burst", "frame burst", "burst overtakes another",
                             "beats of bursts alternate", "answer of the scene bus",
                             "answer of the frame bus"))
        for name, n in (("scene burst", len(self.lengths["scene_ar"])),
                        ("frame burst", len(self.lengths["frame_aw"])),
                        ("burst overtakes another", self.reads.overtakes),
                        ("beats of bursts alternate", self.reads.alternates),
                        ("answer of the scene bus", self.reads.answers),
                        ("answer of the frame bus", self.writes.answers)):
            coverage.bins[name] = n
        return coverage
