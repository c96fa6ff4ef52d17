# cocotb_core.py - frames of rt_core, each pixel against the golden model, until all bins are met
# SPDX-License-Identifier: Apache-2.0
import os

import cocotb
import sphaera
from sphaera_cocotb import CoreAgent


@cocotb.test()
async def frames(dut):
    """A frame, and one that keeps the caches of the first."""
    agent = CoreAgent(dut, sphaera.Machine.read(os.environ["MACHINE"]))
    await agent.start()
    await agent.load()
    for keep_cache in (False, True):
        differ = await agent.draw(keep_cache)
        assert not differ, f"{differ} differences\n{agent.board.text}"
    print(agent.coverage)
    assert not agent.coverage.missing
