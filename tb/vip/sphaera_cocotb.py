# sphaera_cocotb.py - agent of rt_core's ports for cocotb, with scoreboard and coverage
# SPDX-License-Identifier: Apache-2.0
"""Needs cocotb 2 and the package sphaera; docs/reference/library.md has an example. Whatever waits,
waits by a seeded choice, so that a run repeats."""
import random

import cocotb
import sphaera
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from sphaera_coverage import Coverage

LINE_BITS = 256


class CoreAgent:
    """Drives all ports of rt_core: registers, memory that answers the lines of several tags in any
    order, beat by beat, pixels that wait, counters. Every pixel goes to a sphaera.Scoreboard."""

    BINS = ("lines of two tags wait", "line overtakes another", "beats of lines alternate",
            "request waits", "pixel waits", "pixel out of raster order", "pixel that hits",
            "pixel of the background", "pixel that mirrors", "frame after another",
            "frame that keeps caches")

    def __init__(self, dut, machine, *, seed=1, pauses=30, waiting=4):
        """dut: rt_core, whose ports have its names. machine: sphaera.Machine that it has room for.
        pauses: percent of clocks in which each side waits. waiting: lines that memory takes before
        it answers one."""
        self.dut, self.machine = dut, machine
        self.board = sphaera.Scoreboard(machine)
        self.coverage = Coverage(self.BINS)
        self.random = random.Random(seed)
        self.pauses, self.waiting = pauses, waiting
        self.beats = LINE_BITS // len(dut.mem_rsp_data_i)
        self.lines = [int.from_bytes(line.tobytes(), "little") for line in machine.memory]
        self.frames = 0

    def pause(self):
        """Whether a side waits in this clock."""
        return self.random.randrange(100) < self.pauses

    async def start(self):
        """Clock and reset; from here on memory answers."""
        dut = self.dut
        for name in ("start_i", "keep_cache_i", "cfg_valid_i", "mem_req_ready_i", "mem_rsp_valid_i",
                     "mem_rsp_error_i", "pix_ready_i", "count_addr_i"):
            getattr(dut, name).value = 0
        dut.rst.value = 1
        cocotb.start_soon(Clock(dut.clk, 10, "ns").start())
        await ClockCycles(dut.clk, 16)
        dut.rst.value = 0
        cocotb.start_soon(self.memory())
        cocotb.start_soon(self.pixels())
        await RisingEdge(dut.clk)

    async def load(self):
        """Writes all registers of the machine."""
        for number, value in enumerate(self.machine.registers):
            self.dut.cfg_valid_i.value = 1
            self.dut.cfg_addr_i.value = number
            self.dut.cfg_data_i.value = int(value) & 0xffffffff
            await RisingEdge(self.dut.clk)
        self.dut.cfg_valid_i.value = 0

    async def memory(self):
        """Lines that were asked for, [tag, line, beat], the oldest first."""
        dut, asked, sends, last = self.dut, [], None, None
        mask = (1 << LINE_BITS // self.beats) - 1
        while True:
            await RisingEdge(dut.clk)
            if dut.mem_req_valid_o.value == 1:
                if dut.mem_req_ready_i.value == 1:
                    asked.append([int(dut.mem_req_tag_o.value), int(dut.mem_req_line_o.value), 0])
                else:
                    self.coverage.sample("request waits")
            self.coverage.sample("lines of two tags wait", len({tag for tag, *_ in asked}) > 1)
            if sends and dut.mem_rsp_ready_o.value == 1:
                sends[2] += 1
                if sends[2] == self.beats:
                    asked.remove(sends)
                last, sends = sends, None
            if not sends and asked and not self.pause():
                firsts = {}  # of each tag
                for line in asked:
                    firsts.setdefault(line[0], line)
                sends = self.random.choice(list(firsts.values()))
                self.coverage.sample("line overtakes another", sends is not asked[0])
                self.coverage.sample("beats of lines alternate",
                                     last in asked and sends is not last)
                data = self.lines[sends[1]] >> sends[2] * (LINE_BITS // self.beats) & mask
                dut.mem_rsp_data_i.value = data
                dut.mem_rsp_tag_i.value = sends[0]
            dut.mem_rsp_valid_i.value = int(sends is not None)
            dut.mem_req_ready_i.value = int(len(asked) < self.waiting and not self.pause())

    async def pixels(self):
        """Pixels as they leave, into the scoreboard."""
        dut, before, none = self.dut, (-1, -1), sphaera.NONE
        while True:
            await RisingEdge(dut.clk)
            if dut.pix_valid_o.value == 1 and dut.pix_ready_i.value == 1:
                x, y, prim = (int(getattr(dut, f"pix_{name}_o").value) for name in ("x", "y", "id"))
                colour = int(dut.pix_colour_o.value)
                colours = [colour >> 24 * i & 0xffffff for i in range(3)]
                self.coverage.sample("pixel out of raster order", (y, x) < before)
                self.coverage.sample("pixel that hits", prim != none)
                self.coverage.sample("pixel of the background", prim == none)
                self.coverage.sample("pixel that mirrors", colours[0] != colours[2])
                before = y, x
                self.board.pixel(x, y, colours, prim, int(dut.pix_key_o.value),
                                 int(dut.pix_visits_o.value), int(dut.pix_texture_o.value))
            elif dut.pix_valid_o.value == 1:
                self.coverage.sample("pixel waits")
            dut.pix_ready_i.value = int(not self.pause())

    async def draw(self, keep_cache=False, clocks=1_000_000):
        """A frame; how many differences it has from the model's. AssertionError: it takes more
        clocks."""
        dut = self.dut
        self.coverage.sample("frame after another", self.frames)
        self.coverage.sample("frame that keeps caches", keep_cache)
        self.frames += 1
        dut.keep_cache_i.value = int(keep_cache)
        dut.start_i.value = 1
        await RisingEdge(dut.clk)
        dut.start_i.value = 0
        await RisingEdge(dut.clk)
        await RisingEdge(dut.clk)
        for _ in range(clocks):
            if dut.busy_o.value == 0:
                break
            await RisingEdge(dut.clk)
        else:
            raise AssertionError(f"busy for {clocks} clocks")
        counters = {}
        for name, number in zip(sphaera.counter_names(), range(32)):
            dut.count_addr_i.value = number
            await ClockCycles(dut.clk, 3)
            counters[name] = int(dut.count_data_o.value)
        self.board.counters(counters)
        self.board.errors(int(dut.errors_o.value))
        return self.board.end()
