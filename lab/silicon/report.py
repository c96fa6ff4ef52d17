# report.py - area, clock and energy of a core that drew a frame in standard cells
# SPDX-License-Identifier: Apache-2.0
"""RUN is the folder of `make silicon`, with report.json and toggles, CORE that of the core's cells.
Prints the tables and writes RUN/silicon.json."""
import json
from pathlib import Path

from .. import intact
from ..synth.report import table

GROUPS = "switching", "internal", "clock pins", "memories"
PHASES = "busy", "idle"
BLOCKS = 14         # rows of modules that are printed
LEFT_OUT = ("the clock's tree, wires, glitches (cells have no delay here), DRAM and its pins, "
            "test logic")


class Toggles:
    """What gates_write() of tb/netlist/gates.h wrote."""

    def __init__(self, path, nets, accesses):
        first, *lines = Path(path).read_text(encoding="utf-8").splitlines()
        self.clocks = [int(n) for n in first.split()[1:]]
        rows = [tuple(map(int, line.split())) for line in lines]
        self.nets = rows[:nets]
        self.accesses = rows[nets:nets + accesses]
        self.through = rows[nets + accesses:]       # clocks that got through gates


def energies(core, toggles):
    """{phase: {module: [pJ a clock of each of GROUPS]}}"""
    found = {}
    for phase, name in enumerate(PHASES):
        sums = [[0.0] * len(GROUPS) for _ in core["modules"]]
        for (switching, internal, module), count in zip(core["nets"], toggles.nets):
            if count[phase] and module >= 0:
                sums[module][0] += switching * count[phase]
                sums[module][1] += internal * count[phase]
        for (energy, module), count in zip(core["accesses"], toggles.accesses):
            sums[module][3] += energy * count[phase]
        for (energy, module), count in zip(core["clock_gates"], toggles.through):
            sums[module][2] += energy * count[phase]
        clocks = toggles.clocks[phase]
        found[name] = {module: [value / clocks for value in row]
                       for module, row in zip(core["modules"], sums)}
        for module, clock in core["clock"].items():
            found[name][module][2] += clock
    return found


def total(modules):
    return [sum(column) for column in zip(*modules.values())]


def of_run(core, report, toggles):
    """The figures: kGE, mm2, MHz, pJ a clock, nJ a pixel and a ray, mW."""
    counters = report["cold"]["counters"]
    rays = sum(count for name, count in counters.items()
               if name.startswith("rays_") and name != "rays_waiting")
    logic = sum(core["areas"].values())
    timing = core["timing"]
    mhz = timing["mhz"] if timing else None
    found = {
        "schema": "sphaera-silicon", "version": 1, "scene": report["scene"],
        "profile": report["profile"], "core": report["core"], "library": core["library"],
        "liberty": core["liberty"], "macros": core["macros"], "pixels": report["pixels"],
        "rays": rays, "cycles": counters["cycles"], "counters": counters,
        "kge": logic / core["nand2"] / 1000, "cells": sum(core["cells"].values()),
        "flip_flops": core["flip_flops"], "clock_gates": len(core["clock_gates"]),
        "logic_mm2": logic / 1e6,
        "memories": core["memories"],
        "memory_mm2": sum(of["um2"] for of in core["memories"].values()) / 1e6,
        "mhz": mhz, "paths": timing["paths"] if timing else None,
        "leakage_mw": sum(core["leakage_nw"].values()) / 1e6, "left_out": LEFT_OUT,
        "blocks": {module: {"kge": area / core["nand2"] / 1000}
                   for module, area in core["areas"].items()}, "energy": None}
    if not core["power"]:
        return found
    phases = energies(core, toggles)
    for name, modules in phases.items():
        for module, row in modules.items():
            if sum(row):
                found["blocks"].setdefault(module, {"kge": 0.0})[name] = dict(zip(GROUPS, row))
    busy, idle = (dict(zip(GROUPS, total(phases[name]))) for name in PHASES)
    of_frame = sum(busy.values()) * toggles.clocks[0] / 1000
    found["energy"] = {
        "busy": busy, "idle": idle, "nj_pixel": of_frame / report["pixels"],
        "nj_ray": of_frame / rays if rays else None,
        "busy_mw": sum(busy.values()) * mhz / 1000 if mhz else None,
        "idle_mw": sum(idle.values()) * mhz / 1000 if mhz else None}
    return found


def summed(block, phase):
    return sum(block.get(phase, {}).values())


def blocks_table(found):
    """Modules without those inside of them, the hungriest first."""
    blocks = found["blocks"]
    most = sorted(blocks, key=lambda name: (-summed(blocks[name], "busy"), -blocks[name]["kge"]))
    rows = []
    for name in most[:BLOCKS]:
        block = blocks[name]
        busy = block.get("busy", dict.fromkeys(GROUPS, 0.0))
        rows.append([name, f"{block['kge']:.1f}"] + ([f"{busy[group]:.1f}" for group in GROUPS] + [
            f"{summed(block, 'busy'):.1f}", f"{summed(block, 'idle'):.1f}"]
            if found["energy"] else []))
    return table(["module", "kGE"] + (["pJ a clock: " + GROUPS[0], *GROUPS[1:], "busy", "idle"]
                                      if found["energy"] else []), rows)


def lines(found):
    memories = ", ".join(f"{of['bits']} bits in {of['macros']} {kind} macros"
                         for kind, of in found["memories"].items())
    yield (f"cells {found['kge']:.1f} kGE of NAND2, {found['logic_mm2']:.3f} mm2, {found['cells']} "
           f"cells, {found['flip_flops']} flip-flops, {found['clock_gates']} gates of the clock in "
           f"{found['library']}")
    yield f"memories {found['memory_mm2']:.3f} mm2: {memories}, of {found['macros']}"
    if found["mhz"]:
        yield f"clock {found['mhz']:.1f} MHz by OpenSTA, register to register; slowest paths:"
        for path in found["paths"]:
            yield f"  {path['ns']:.2f} ns  {' > '.join(path['through'])}"
    else:
        yield "clock: not known, there is no OpenSTA (make silicon-setup)"
    energy = found["energy"]
    if not energy:
        yield f"energy: missing, {found['liberty']} has no tables of internal_power"
        return
    for phase in PHASES:
        of = energy[phase]
        power = energy[f"{phase}_mw"]
        yield (f"{phase} {sum(of.values()):.1f} pJ a clock: " + ", ".join(
            f"{group} {of[group]:.1f}" for group in GROUPS)
            + (f"; {power:.2f} mW" if power else ""))
    yield (f"energy {energy['nj_pixel']:.3f} nJ a pixel"
           + (f", {energy['nj_ray']:.3f} nJ a ray" if energy["nj_ray"] else "")
           + f"; leakage {found['leakage_mw']:.4f} mW, which alone is left while active_o is low "
           "and the clock stands")


def main(run, core):
    run, core = Path(run), Path(core)
    known = json.loads((core / "core.json").read_text("utf-8"))
    report = json.loads((run / "report.json").read_text("utf-8"))
    found = of_run(known, report, Toggles(run / "toggles", len(known["nets"]),
                                                 len(known["accesses"])))
    intact.write(run / "silicon.json", json.dumps(found, indent=1) + "\n")
    print("\n".join(lines(found)))
    print(blocks_table(found))
    print(f"left out: {found['left_out']}")
