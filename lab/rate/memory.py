# memory.py - clocks of a frame by latency and width of memory: `make memory-sweep`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `memory` into PAGE: 96x54 pixels of random spheres, cold caches. Memory answers
after a number of clocks, in order, with a beat a clock. Beside the clocks stands what the run says
that limits it at latency 200. examples/sweeps/memory.txt is a small one of these."""
from collections import namedtuple

from . import cores
from ..pages.place import place

SIZE = "96x54"
SPHERES = (100, 1000, 10000, 50000, 100000, 1000000)
LATENCIES = (20, 100, 200, 400)
LIMIT = 200  # the latency at which the limit is told
AS_IS = 0    # MEM_PENDING by the rule of rt_core


class Core(namedtuple("Core", "pipes mem_data mem_pending")):
    def axes(self):
        return {name: str(value) for name, value in self._asdict().items()}


CORES = [Core(1, 64, 16), Core(4, 64, 16)] + \
    [Core(pipes, data, AS_IS) for pipes in (1, 2, 3, 4) for data in (64, 128, 256)]


def rows(build):
    yield ["spheres", "pipes", "bits", "lines on their way",
           *(f"latency {latency}" for latency in LATENCIES), f"limit at {LIMIT}"]
    found = cores.runs(build, "memory-sweep", SIZE, {
        (spheres, core, latency): (f"random:{spheres}", cores.SPHERES,
                                   {**core.axes(), "latency": latency})
        for spheres in SPHERES for core in CORES for latency in LATENCIES})
    for spheres in SPHERES:
        for core in CORES:
            runs = {latency: found[spheres, core, latency] for latency in LATENCIES}
            limit = runs[LIMIT]["limit"]
            yield [str(spheres), str(core.pipes), str(core.mem_data),
                   str(core.mem_pending or core.mem_data),
                   *(str(cores.cycles(run)) for run in runs.values()),
                   f"{limit['unit']} {100 * limit['busy']:.0f} %" if limit["binds"] else "no unit"]


def main(build, page):
    place(page, "make memory-sweep", {"memory": list(rows(build))})
