# families.py - the slow paths of a placed core, a line for each family
# SPDX-License-Identifier: Apache-2.0
"""DELAYS is what nextpnr writes with --sdf, the delays of cells and wires in ps, or a netlist as
JSON of Yosys, whose delays are estimated (estimate.py). Prints how many end points are later than 8
ns, then of the slowest paths, one for those that begin and end in registers
of the same names whatever their bits, the ns and the cells that each passes."""
import re
from collections import Counter, defaultdict

from . import estimate

WANTED = 8000   # ps: 125 MHz
INSTANCE = re.compile(r"\(INSTANCE (\S*?)\)?$")
WIRE = re.compile(r"\(INTERCONNECT (\S+)/(\S+) (\S+)/(\S+) \(([^)]*)\)")
CELL = re.compile(r"\(IOPATH (?:\(posedge (\S+)\)|(\S+)) (\S+) \(([^)]*)\)")
SETUP = re.compile(r"\(SETUPHOLD \(\S+ (\S+)\) \(\S+ \S+\) \(([^)]*)\)")
PRIMITIVE = re.compile(r"(_TRELLIS_FF|_LUT4|_CCU2C|_MULT18X18D|_DO_\d|\.mem\.\d|\$CCU2).*")


def late(delay):
    """The greatest of least:typical:greatest."""
    return float(delay.split(":")[-1])


def read(name):
    """{pin: [(pin, ps)]}, {pin of a register or memory: ps behind the clock}, {end point: ps}."""
    delays, begins, ends = defaultdict(list), {}, {}
    instance = ""
    with open(name, encoding="utf-8") as f:
        for line in f:
            line = line.replace("\\", "").rstrip()
            if found := INSTANCE.search(line):
                instance = found[1]
            elif found := WIRE.search(line):
                delays[found[1], found[2]].append(((found[3], found[4]), late(found[5])))
            elif found := CELL.search(line):
                pin = found[1] or found[2]
                if re.match("CLK|WCK", pin):
                    begins[instance, found[3]] = late(found[4])
                else:
                    delays[instance, pin].append(((instance, found[3]), late(found[4])))
            elif found := SETUP.search(line):
                ends[instance, found[1]] = max(ends.get((instance, found[1]), 0), late(found[2]))
    return delays, begins, ends


def arrivals(delays, begins):
    """{pin: ps}, {pin: the pin before it on its slowest path}, pins in the order of paths."""
    missing = Counter(to for wires in delays.values() for to, _ in wires)
    ready = [pin for pin in {*delays, *begins} if not missing[pin]]
    arrival, before = dict(begins), {}
    for pin in ready:                      # grows while it is walked
        for to, delay in delays.get(pin, ()):
            at = arrival.get(pin)
            if at is not None and to not in begins and at + delay > arrival.get(to, -1):
                arrival[to], before[to] = at + delay, pin
            missing[to] -= 1
            if not missing[to]:
                ready.append(to)
    return arrival, before


def short(cell):
    """The name of the source: without the bench's instances and what mapping added."""
    return PRIMITIVE.sub("", re.sub(r"u_core\.|u_engine\.|g_\w+(\[\d+\])?\.", "", cell))


def told(cells):
    """Cells in order, each instance where the path enters it."""
    said, words = "", []
    for cell in cells:
        instance, _, name = cell.rpartition(".")
        words.append(name if instance == said else f"{instance}: {name}")
        said = instance
    return " > ".join(words)


def main(name, lines=30):
    delays, begins, ends = (estimate.read if name.endswith(".json") else read)(name)
    arrival, before = arrivals(delays, begins)
    late_ends = sorted(((arrival[pin] + setup, pin) for pin, setup in ends.items()
                        if pin in arrival), reverse=True)
    too_late = sum(at > WANTED for at, _ in late_ends)
    print(f"{too_late} of {len(late_ends)} end points are later than {WANTED / 1000:g} ns")
    seen = set()
    for at, pin in late_ends:
        path = [pin]
        while path[-1] in before:
            path.append(before[path[-1]])
        cells = list(dict.fromkeys(short(cell) for cell, _ in reversed(path)))
        family = tuple(re.sub(r"\d+", "#", cell) for cell in (cells[0], cells[-1]))
        if family not in seen:
            seen.add(family)
            print(f"{at / 1000:6.2f}  {told(cells)}")
        if len(seen) == int(lines):
            break
