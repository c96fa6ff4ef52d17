# program.py - a netlist as a program that simulates it: tables for tb/netlist/gates.c
# SPDX-License-Identifier: Apache-2.0
"""Layout(netlist) gives each net its place; write() the tables, with a kernel for each kind of cell
made of the function that the library states; build() compiles them."""
import os
import subprocess
from itertools import groupby

from .. import intact
from .netlist import Gate

RUNTIME = "tb/netlist/gates.c"
LINE = 20       # numbers a line of a table


def kernel(name, function, state=None):
    """A C function of gates of one kind; state: its net is the one that is written."""
    names = [pin for pin in function.pins if pin != state]
    known = "".join(f"const uint8_t {safe(pin)} = net[in[{k} * count + i]];\n        "
                    for k, pin in enumerate(names))
    if state in function.pins:
        known += f"const uint8_t {safe(state)} = out[i];\n        "
    code = function.code
    for pin in sorted(function.pins, key=len, reverse=True):
        code = rename(code, pin)
    return (f"static void {name}(const uint8_t *net, const uint32_t *in, uint8_t *restrict out,\n"
            f"{' ' * (13 + len(name))}uint32_t count) {{\n    (void)net, (void)in;\n"
            f"    for (uint32_t i = 0; i < count; i++) {{\n        {known}out[i] = {code};\n"
            "    }\n}\n")


def safe(pin):
    """A pin's name where C has its own names."""
    return "p_" + pin.replace("[", "_").replace("]", "")


def rename(code, pin):
    out, word = [], ""
    for letter in code + " ":
        if letter.isalnum() or letter in "_[]":
            word += letter
            continue
        out.append((safe(word) if word == pin else word) + letter)
        word = ""
    return "".join(out).rstrip()


class Layout:
    """place: {net of the netlist: its byte}. Order as gates.c has it."""

    def __init__(self, netlist):
        self.netlist = netlist
        self.place, self.count = {0: 0, 1: 1}, 2
        for direction, nets in netlist.ports.values():
            if direction == "input":
                self.add(nets)
        self.state = self.count
        self.flops = [list(group) for _, group in groupby(
            sorted(netlist.flops, key=self.clocked_alike), self.clocked_alike)]
        for group in self.flops:
            self.add(flop.state for flop in group)
        reads = [(memory, read) for memory in netlist.memories for read in memory.reads]
        for _, read in reads:
            if read.clocked:
                self.add(read.data)
        self.states = self.count - self.state
        self.inverted = [flop for flop in netlist.flops if flop.inverted > 1]
        self.inverted_state = self.count
        self.add(flop.inverted for flop in self.inverted)
        for _, read in reads:
            if not read.clocked:
                self.add(read.data)
        self.add(gate.output for gate in netlist.gates)
        self.reads = reads
        self.writes = [(memory, write) for memory in netlist.memories for write in memory.writes]

    @staticmethod
    def clocked_alike(flop):
        return flop.cell.name, -1 if flop.gate is None else flop.gate

    def add(self, nets):
        for net in nets:
            if net not in self.place:
                self.place[net] = self.count
                self.count += 1

    def of(self, nets):
        return [self.place.get(net, 0) for net in nets]

    def steps(self):
        """Groups of gates, and reads at once, in the order in which they settle."""
        found = [(key[0], list(group)) for key, group in
                 groupby(self.netlist.gates, key=lambda gate: (gate.level, gate.kind))]
        found += [(memory.level, at) for at, (memory, read) in enumerate(self.reads)
                  if not read.clocked]
        return [part for _, part in sorted(found, key=lambda step: step[0])]


class Writer:
    def __init__(self, layout):
        self.layout = layout
        self.inputs, self.pins, self.kernels = [], [], {}

    def name(self, cell, pin, function, state=None):
        key = cell.name, pin
        if key not in self.kernels:
            name = f"k{len(self.kernels)}"
            self.kernels[key] = name, f"/* {cell.name} {pin}: {function.text} */\n" + kernel(
                name, function, state)
        return self.kernels[key][0]

    def columns(self, rows):
        """Inputs of neighbours, input by input; where they begin."""
        at = len(self.inputs)
        for column in zip(*rows):
            self.inputs += self.layout.of(column)
        return at

    def pin_list(self, nets):
        at = len(self.pins)
        self.pins += self.layout.of(nets)
        return at

    def groups(self):
        groups, steps = [], []
        for part in self.layout.steps():
            if not isinstance(part, list):
                steps.append(f"{part} | STEP_READ")
                continue
            gate: Gate = part[0]
            name = self.name(gate.cell, gate.pin, gate.cell.pins[gate.pin].function)
            steps.append(str(len(groups)))
            groups.append(f"{{{name}, {self.columns([g.inputs for g in part])}, "
                          f"{self.layout.place[gate.output]}, {len(part)}}}")
        return groups, steps

    def flops(self):
        rows, at = [], 0
        for group in self.layout.flops:
            register = group[0].cell.register
            name = self.name(group[0].cell, "", register.next_state, register.state)
            rows.append(f"{{{{{name}, {self.columns([flop.inputs for flop in group])}, {at}, "
                        f"{len(group)}}}, {self.enable(group[0])}}}")
            at += len(group)
        return rows

    def enable(self, flop):
        """1: its clock has no gate."""
        return 1 if flop.gate is None else self.layout.of(
            [self.layout.netlist.gates_of_clock[flop.gate].enable])[0]

    def accesses(self):
        place, numbers = self.layout.place, {id(memory): at for at, memory in
                                             enumerate(self.layout.netlist.memories)}
        reads = [f"{{{numbers[id(memory)]}, {self.pin_list(read.address)}, {len(read.address)}, "
                 f"{place[read.data[0]]}, {place.get(read.enable, 0)}, {int(read.clocked)}}}"
                 for memory, read in self.layout.reads]
        writes = [f"{{{numbers[id(memory)]}, {self.pin_list(write.address)}, "
                  f"{len(write.address)}, {self.pin_list(write.data)}, "
                  f"{self.pin_list(write.enable)}, 0}}" for memory, write in self.layout.writes]
        return reads, writes

    def memories(self):
        rows, inits, bit = [], "", 0
        for memory in self.layout.netlist.memories:
            known = set(memory.init) & set("01")
            rows.append(f"{{{memory.size}, {memory.width}, {memory.offset}, {bit}, "
                        f"{len(inits) if known else '~0U'}}}")
            if known:
                inits += memory.init.ljust(memory.bits, "x")[:memory.bits]
            bit += memory.bits
        return rows, inits, bit

    def text(self):
        layout = self.layout
        groups, steps = self.groups()
        flops, (reads, writes) = self.flops(), self.accesses()
        memories, inits, bits = self.memories()
        ports, port_nets = [], []
        for name, (_, nets) in layout.netlist.ports.items():
            ports.append(f'{{"{name}", {len(port_nets)}, {len(nets)}}}')
            port_nets += layout.of(nets)
        sizes = {"NETS": layout.count, "STATE": layout.state, "STATES": layout.states,
                 "INVERTED_STATE": layout.inverted_state, "INVERTED": len(layout.inverted),
                 "STEPS": len(steps), "FLOPS": len(flops), "READS": len(reads),
                 "WRITES": len(writes), "MEMORIES": len(memories), "BITS": bits,
                 "PORTS": len(ports), "ENABLES": len(layout.netlist.gates_of_clock)}
        uint = "static const uint32_t"
        return "".join(
            ["/* written by lab/silicon/program.py */\n#define STEP_READ 0x80000000U\nenum {\n"]
            + [f"    {name} = {value},\n" for name, value in sizes.items()] + ["};\n"]
            + [code for _, code in self.kernels.values()]
            + [table("static const struct group groups", groups, 4),
               table(f"{uint} steps", steps), table("static const struct clocked flops", flops, 4),
               table(f"{uint} inputs", self.inputs), table(f"{uint} pins", self.pins),
               table("static const struct access reads", reads, 3),
               table("static const struct access writes", writes, 3),
               table("static const struct memory memories", memories, 3),
               table(f"{uint} inverted_of",
                     layout.of(flop.state for flop in layout.inverted)),
               table(f"{uint} enables",
                     layout.of(gate.enable for gate in layout.netlist.gates_of_clock)),
               table("static const struct port ports", ports, 4),
               table(f"{uint} port_nets", port_nets)]
            + ["static const char inits[] =\n"]
            + [f'    "{inits[at:at + 90]}"\n' for at in range(0, len(inits) or 1, 90)] + [";\n"])


def table(head, rows, line=LINE):
    """An array; one entry of zeros if there is none."""
    rows = [str(row) for row in rows] or ["0"]
    return f"{head}[] = {{\n" + "".join(
        f"    {', '.join(rows[at:at + line])},\n" for at in range(0, len(rows), line)) + "};\n"


def build(layout, path):
    """The library path, of tables that stand beside it."""
    tables = path.with_suffix(".h")
    intact.write(tables, Writer(layout).text())
    with intact.beside(path) as new:
        subprocess.run([*(os.environ.get("CC") or "cc").split(), "-std=c11", "-O2", "-shared",
                        "-fPIC", "-w", f'-DTABLES="{tables.resolve()}"', RUNTIME, "-o", new],
                       check=True)
