# cocotb_top.py - a frame of rt_top in memory, each pixel and counter against the golden model
# SPDX-License-Identifier: Apache-2.0
import os
import random

import cocotb
import sphaera
from sphaera_cocotb_top import TopAgent, registers


@cocotb.test()
async def frame(dut):
    """A frame through channels that pause."""
    random.seed(1)
    machine = sphaera.Machine.read(os.environ["MACHINE"])
    board, agent = sphaera.Scoreboard(machine), TopAgent(dut, registers(os.environ["RDL"]))
    await agent.start()
    agent.pauses(20)
    await agent.load_machine(machine)
    board.errors(await agent.draw())
    differ = await agent.score(board, machine)
    assert not differ, f"{differ} differences\n{board.text}"
    print(agent.coverage)
    assert not agent.coverage.missing
