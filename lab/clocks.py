# clocks.py - the clock of a core, from the one table of them: docs/results/data/clocks.tsv
# SPDX-License-Identifier: Apache-2.0
"""Prints the MHz of a core, or frames a second of CLOCKS each; "not routed" if nobody has routed
that very core.

Every frame rate, every millisecond of a frame and every MHz of a page is made here. A core goes by
its whole key, as synth/core.sh names it: no core is told another one's clock, nor one that a placer
guessed. `make study-seeds` writes the table."""
import os
import statistics
import subprocess
from functools import lru_cache
from typing import NamedTuple

from .pages import data

TABLE = "clocks"
COLUMNS = ["core", "what", "speed grade", "after", "seeds", "worst, MHz", "median, MHz",
           "best, MHz", "tools", "command", "commit", "date"]
SPEED = "8"
SEEDS = 5  # as many as a clock is told of without their number
NOT = "not routed"


class Clock(NamedTuple):
    """Of one routed core."""
    mhz: float  # median of the seeds
    seeds: int
    worst: float
    best: float


@lru_cache(maxsize=None)
def key(profile, effects, **variables):
    """The key of a core; variables as sim/cores.py takes them: PIPES, SIZES..."""
    ran = subprocess.run(["sim/cores.py", "key", profile, effects, "ecp5"], check=True, text=True,
                         env=dict(os.environ, **{k: str(v) for k, v in variables.items()}),
                         stdout=subprocess.PIPE)
    return ran.stdout.strip()


def rows():
    """The table, a dictionary a row."""
    head, found = data.read(TABLE)
    return [dict(zip(head, (cell.strip("`") for cell in row))) for row in found]


def clock(core):
    """The Clock of that very core, None: nobody has routed it."""
    for row in rows():
        if (row["core"], row["speed grade"], row["after"]) == (core, SPEED, "routing"):
            return Clock(float(row["median, MHz"]), int(row["seeds"]), float(row["worst, MHz"]),
                         float(row["best, MHz"]))
    return None


def mhz(core):
    """In words: 127.5, or 76.0 (1 seed)."""
    found = clock(core)
    if not found:
        return NOT
    few = f" ({found.seeds} seed{'s' * (found.seeds > 1)})" if found.seeds < SEEDS else ""
    return f"{found.mhz:.1f}{few}"


def spread(core):
    """In words, with the worst and the best of the seeds: 127.5 (122.7 to 133.5)."""
    found = clock(core)
    if not found or found.seeds == 1:
        return mhz(core)
    few = f", {found.seeds} seeds" if found.seeds < SEEDS else ""
    return f"{found.mhz:.1f} ({found.worst:.1f} to {found.best:.1f}{few})"


def frames(core, clocks, form="{:.1f}"):
    """Frames a second of so many clocks each."""
    found = clock(core)
    return form.format(found.mhz * 1e6 / clocks) if found else NOT


def milliseconds(core, clocks, form="{:.2f}"):
    """Of a frame of so many clocks."""
    found = clock(core)
    return form.format(clocks / found.mhz / 1000) if found else NOT


def row_of(core, speed, placed, yosys, command, at):
    """A row of the table. placed: what synth/place.sh says of each seed, all routed or all placed;
    at: commit and date."""
    reached = [run["fmax"] for run in placed]
    tools = ", ".join([yosys, *sorted({f"nextpnr-ecp5 {run['nextpnr'].removeprefix('nextpnr-')}"
                                       for run in placed})])
    return [f"`{core}`", "rt_top" if core.endswith("-top") else "rt_core", speed,
            "routing" if placed[0]["routed"] else "placement", str(len(reached)),
            *(f"{of(reached):.1f}" for of in (min, statistics.median, max)), tools,
            f"`{command}`", *at]


def main(core, count=None):
    print(mhz(core) if count is None else frames(core, float(count)))
