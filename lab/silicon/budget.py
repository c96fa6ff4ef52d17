# budget.py - does a frame take no more energy than synth/energy_budget.txt lets it? TAP lines
# SPDX-License-Identifier: Apache-2.0
"""Maps the standard core and draws random:256 with `make silicon`; a line a module of BUDGET. Exits
with 1 if a module takes more, or is not in the core."""
import sys

from ..synth import budget
from . import events, report

CORE = "rt_core"    # with all that is inside of it; other modules without those inside of them


def read(path):
    """{module: (pJ a busy clock, pJ an idle one)}"""
    return budget.read(path, "silicon-budget", "`module busy idle`, pJ a clock")


def compared(limits, found):
    """(line, whether it is within) of each module, of what silicon.json has."""
    for module, most in limits.items():
        if module == CORE:
            takes = [sum(found["energy"][phase].values()) for phase in report.PHASES]
        elif module in found["blocks"]:
            takes = [report.summed(found["blocks"][module], phase) for phase in report.PHASES]
        else:
            yield f"{module}: not in the core", False
            continue
        yield (f"{module}: " + ", ".join(
            f"{is_now:.0f} of {limit} pJ {phase}"
            for is_now, limit, phase in zip(takes, most, report.PHASES)),
               all(is_now <= limit for is_now, limit in zip(takes, most)))


def main(path):
    limits, bad = read(path), 0
    for line, ok in compared(limits, events.drawn("standard", "random:256", ())):
        bad += not ok
        print(f"{'ok' if ok else 'not ok'} - {line}")
    sys.exit(bad > 0)
