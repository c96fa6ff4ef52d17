# estimate.py - delays of a netlist that was not placed, as placement would have them in the mean
# SPDX-License-Identifier: Apache-2.0
"""A whole core takes seconds where nextpnr takes minutes to half an hour, and the same paths come
first. Delays are those of an ECP5 of speed grade 8; a wire has the mean of routed cores by the pins
that it reaches, so that single paths are some tenths off."""
import json
import math
import re
from collections import Counter, defaultdict

# ps; of a wire: the first, and more for each doubling of the pins
WIRE, MORE, OWN = 500, 80, 100                  # OWN: a cell to the register beside it
REGISTER, MEMORY, LUT, PRODUCT = 400, 1400, 140, 2900
CARRY, CARRY_ON, SUM = 250, 35, 200             # into a chain, along it, out of it
SETUP, CONTROL = 50, 150
BLOCK = "DP16KD", "PDPW16KD"


def pins(cell, pattern, way="input"):
    return [pin for pin in cell["connections"]
            if re.fullmatch(pattern, pin) and cell["port_directions"][pin] == way]


def within(cell):
    """[(pin, pin, ps)] of a cell's own ways, [(pin, ps)] that begin and that end in it."""
    kind, having = cell["type"], cell["parameters"]
    if kind in ("LUT4", "INV"):
        return [(a, "Z", LUT) for a in pins(cell, "[ABCD]")], [], []
    if kind == "CCU2C":
        ways = [("CIN", "COUT", CARRY_ON), ("CIN", "S0", SUM), ("CIN", "S1", SUM)]
        for a in pins(cell, "[ABCD][01]"):
            ways += [(a, "COUT", CARRY), (a, "S1", CARRY)] + [(a, "S0", CARRY)] * (a[1] == "0")
        return ways, [], []
    if kind == "TRELLIS_FF":
        return [], [("Q", REGISTER)], [("DI", SETUP), ("M", SETUP), ("CE", CONTROL),
                                       ("LSR", CONTROL)]
    if kind == "TRELLIS_DPR16X4":
        return [("RAD", "DO", LUT)], [("DO", REGISTER)], [(p, SETUP) for p in ("DI", "WAD", "WRE")]
    if kind in BLOCK:
        return [], [(p, MEMORY) for p in pins(cell, "DO.*", "output")], \
            [(p, CONTROL) for p in pins(cell, r"(?!CLK).*")]
    if kind == "MULT18X18D":
        into, out = pins(cell, r"[AB]\d+"), pins(cell, r"P\d+", "output")
        kept = [having.get(name, "NONE") != "NONE" for name in ("REG_INPUTA_CLK", "REG_OUTPUT_CLK")]
        return [] if any(kept) else [(a, p, PRODUCT) for a in into for p in out], \
            [(p, REGISTER if kept[1] else PRODUCT) for p in out] if any(kept) else [], \
            [(a, SETUP if kept[0] else PRODUCT) for a in into] if any(kept) else []
    return [], [], []


def read(name):
    """As families.read() has it, of the only module of a netlist that Yosys wrote as JSON."""
    with open(name, encoding="utf-8") as f:
        module, = (m for m in json.load(f)["modules"].values()
                   if not int(m["attributes"].get("blackbox", "0"), 2))
    delays, begins, ends, driver, loads = defaultdict(list), {}, {}, {}, defaultdict(list)
    for cell_name, cell in module["cells"].items():
        at = cell_name.replace("\\", "")
        bits = {pin: [(f"{pin}{i}" if len(of) > 1 else pin, bit) for i, bit in enumerate(of)]
                for pin, of in cell["connections"].items()}
        ways, from_it, to_it = within(cell)
        for a, z, ps in ways:
            for pin, _ in bits[a]:
                delays[at, pin] += [((at, other), ps) for other, _ in bits[z]]
        begins.update(((at, pin), ps) for p, ps in from_it for pin, _ in bits.get(p, ()))
        ends.update(((at, pin), ps) for p, ps in to_it for pin, _ in bits.get(p, ()))
        for pin, of in bits.items():
            for word, bit in of:
                if isinstance(bit, int) and cell["port_directions"][pin] == "output":
                    driver[bit] = at, word
                elif isinstance(bit, int):
                    loads[bit].append((at, word))
    reach = Counter({bit: len(of) for bit, of in loads.items()})
    for bit, to in loads.items():
        if bit in driver:
            ps = WIRE + MORE * math.log2(1 + reach[bit])
            for at, pin in to:
                own = pin == "CIN" or pin == "DI" and reach[bit] == 1
                delays[driver[bit]].append(((at, pin), OWN * (pin != "CIN") if own else ps))
    return delays, begins, ends
