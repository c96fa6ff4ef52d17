# ports.py - what stands between each port of a block and its registers, from the netlist
# SPDX-License-Identifier: Apache-2.0
from .netlist import LOGIC

HEAD = ["port", "", "bits", "clock", "between it and registers"]


def words(names):
    return ", ".join(f"`{name}`" for name in sorted(names))


def output(netlist, bits):
    mask = 0
    for bit in bits:
        mask |= netlist.come_from(bit)
    clocks = [c for c in netlist.clocks if mask & netlist.mask[c]]
    through = [name for name in netlist.inputs.values() if mask & netlist.mask[f"port {name}"]]
    said = f"combinational from {words(set(through))}" if through else \
        "constant" if not clocks else "logic behind registers" if mask & LOGIC else "a register"
    return ", ".join(clocks), said


def main_input(netlist, name, readers, reached):
    clocks = readers[name]
    if not clocks and not reached:
        return "", "a clock" if name in netlist.clocks else "nothing reads it"
    said = ["logic before registers" if any(clocks.values()) else "a register"] if clocks else []
    said += [f"combinational to {words(reached)}"] if reached else []
    return ", ".join(sorted(clocks)), "; ".join(said)


def table(netlist):
    """Rows below HEAD, in the order of the ports."""
    readers, reached = netlist.readers(), {}
    for name, (way, bits) in netlist.ports.items():
        for bit in bits if way == "output" else ():
            mask = netlist.come_from(bit)
            for port in readers:
                if mask & netlist.mask[f"port {port}"]:
                    reached.setdefault(port, set()).add(name)
    return [[f"`{name}`", {"input": "in", "output": "out"}[way], str(len(bits)),
             *(output(netlist, bits) if way == "output" else
               main_input(netlist, name, readers, reached.get(name, ())))]
            for name, (way, bits) in netlist.ports.items()]
