# memory.py - clocks of a frame by latency and width of memory: `make memory-sweep`
# SPDX-License-Identifier: Apache-2.0
"""Puts the table `memory` into PAGE: 96x54 pixels of random spheres, cold caches. Memory answers
after a number of clocks, in order, with a beat a clock. Beside the clocks stands what the run says
that limits it at latency 200."""
from collections import namedtuple

from . import cores
from ..pages.place import place

SIZE = "96x54"
SPHERES = (4096, 50000)
LATENCIES = (20, 100, 200, 400)
LIMIT = 200  # the latency at which the limit is told
AS_IS = 0    # MEM_PENDING by the rule of rt_core


class Core(namedtuple("Core", "pipes data pending")):
    def variables(self):
        return {"PIPES": str(self.pipes),
                "SIZES": f"mem_data={self.data},mem_pending={self.pending}"}


CORES = [Core(pipes, data, pending) for pipes in (1, 4)
         for data, pending in ((64, 16), (64, AS_IS), (256, AS_IS))]


def rows(bench):
    yield ["spheres", "pipes", "bits", "lines on their way",
           *(f"latency {latency}" for latency in LATENCIES), f"limit at {LIMIT}"]
    for spheres in SPHERES:
        for core in CORES:
            runs = {latency: bench.counted(f"random:{spheres}", cores.SPHERES, core,
                                           f"--latency={latency}") for latency in LATENCIES}
            limit = runs[LIMIT]["cold"]["limit"]
            yield [str(spheres), str(core.pipes), str(core.data), str(core.pending or core.data),
                   *(str(cores.cycles(run)) for run in runs.values()),
                   f"{limit['unit']} {100 * limit['busy']:.0f} %" if limit["binds"] else "no unit"]


def main(build, page):
    place(page, "make memory-sweep", {"memory": list(rows(cores.Bench(build, SIZE)))})
