# netlist.py - a flat netlist of Yosys as cells of a library and memories
# SPDX-License-Identifier: Apache-2.0
"""read(path, library) gives a Netlist: gates in the order in which they settle, flip-flops,
memories ($mem_v2 of Yosys), ports, and of each the instance that it stands in. One clock, the port
clk, which RT_CLOCK_GATE may stop. A cell that has no model, a loop, a net without a driver raise
Bad."""
import json
import re
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

from .liberty import Bad

CLOCK = "clk"
CLOCK_GATE = "RT_CLOCK_GATE"        # of synth/silicon.sh
SKIPPED = "$scopeinfo"


@dataclass
class Gate:
    """An output of a cell that follows from inputs."""
    cell: object                # liberty.Cell
    pin: str
    inputs: list                # nets, in the order of its function's pins
    output: int
    owner: str
    name: str
    level: int = 0

    @property
    def kind(self):
        return self.cell.name, self.pin


@dataclass
class Flop:
    cell: object
    inputs: list                # nets of next_state's pins that are pins of the cell
    state: int                  # net of the state, connected or not
    inverted: int               # the other output's net; 0: none
    owner: str
    name: str
    gate: Optional[int]         # number of the gate behind which its clock is; None: no gate


@dataclass
class ClockGate:
    enable: int                 # net
    owner: str
    name: str


@dataclass
class Read:
    address: list
    data: list
    enable: int
    clocked: bool


@dataclass
class Write:
    address: list
    data: list
    enable: list                # a net for each bit of data


@dataclass
class Memory:
    width: int
    size: int
    offset: int                 # address of the first word
    init: str                   # bits from the lowest on: 0, 1, x
    reads: list
    writes: list
    owner: str
    name: str
    level: int = 0

    @property
    def kind(self):
        """Of table.macros: read behind a register or at once."""
        return "ram" if all(port.clocked for port in self.reads) else "file"

    @property
    def bits(self):
        return self.width * self.size


@dataclass
class Netlist:
    path: str
    top: str
    ports: dict                 # {name: (direction, nets)}
    gates: list
    flops: list
    gates_of_clock: list
    memories: list
    cells: dict                 # {liberty cell's name: number}
    placed: list                # of every cell of the library: name, cell, {pin: net}, owner
    modules: dict               # {instance: module}
    clock: int
    nets: int = 0
    clocks: dict = field(default_factory=dict)      # {number of a gate of the clock: its output}

    def owner_module(self, owner):
        return self.modules.get(owner, self.top)

    def gated_clock(self, gate):
        """The net behind a gate of the clock."""
        return self.clocks[gate]

    def user_module(self, memory):
        """Of a memory: what the module stands in that is nothing but memory."""
        return self.owner_module(".".join(self.path_above(memory.owner)))

    def path_above(self, owner):
        parts = owner.split(".")[:-1]
        while parts and ".".join(parts) not in self.modules:
            parts.pop()
        return parts


def instance_of(name):
    """The instance that a cell stands in; of $flatten\\u_a.\\u_b.$abc$1$2 u_a.u_b"""
    name = name.removeprefix("$flatten")
    path = name.split(".$", maxsplit=1)[0] if ".$" in name else "" if name.startswith("$") else \
        name.rpartition(".")[0]
    return path.replace("\\", "")


def number(text):
    """Of a parameter: a number, or bits."""
    return int(text, 2) if isinstance(text, str) and re.fullmatch("[01]+", text) else text


class Builder:
    """Cells of a JSON file's top module to a Netlist."""

    def __init__(self, path, library):
        self.path, self.library = path, library
        try:
            of = json.loads(Path(path).read_text(encoding="utf-8"))["modules"]
        except (OSError, json.JSONDecodeError, KeyError) as error:
            raise Bad(f"{path}: no netlist of Yosys: {error}") from error
        tops = [name for name, module in of.items()
                if int(module.get("attributes", {}).get("top", "0"), 2)]
        if len(tops) != 1:
            raise Bad(f"{path}: {len(tops)} modules are the top, not one")
        module = of[tops[0]]
        ports = {name: (port["direction"], self.nets(port["bits"]))
                 for name, port in module["ports"].items()}
        if len(ports.get(CLOCK, ("", []))[1]) != 1:
            raise Bad(f"{path}: {tops[0]} has no port {CLOCK}")
        self.out = Netlist(path, tops[0], ports, [], [], [], [], defaultdict(int), [], {},
                           ports[CLOCK][1][0])
        self.clocks = {self.out.clock: None}
        self.fresh = 2 + max((net for _, bits in ports.values() for net in bits), default=1)
        for cell in module["cells"].values():
            for bits in cell["connections"].values():
                for bit in bits:
                    if isinstance(bit, int) and bit >= self.fresh:
                        self.fresh = bit + 1
        for name, cell in module["cells"].items():
            if cell["type"] == CLOCK_GATE:
                self.clock_gate(name, cell["connections"])
        for name, cell in module["cells"].items():
            self.cell(name, cell)
        self.order()

    def bad(self, name, why):
        return Bad(f"{self.path}: cell {name}: {why}")

    @staticmethod
    def nets(bits):
        """0 and 1 are constants; what is unknown is 0."""
        return [bit if isinstance(bit, int) else int(bit == "1") for bit in bits]

    def new(self):
        self.fresh += 1
        return self.fresh - 1

    def cell(self, name, cell):
        kind = cell["type"]
        if kind == CLOCK_GATE:
            return
        if kind == SKIPPED:
            self.out.modules[name] = cell["attributes"].get("module_hdlname", name)
        elif kind == "$mem_v2":
            self.memory(name, cell)
        elif kind not in self.library.cells:
            raise self.bad(name, f"{self.library.name} has no {kind}")
        else:
            self.of_library(name, self.library.cells[kind], cell["connections"])

    def clock_gate(self, name, connections):
        pin = {key: self.nets(bits)[0] for key, bits in connections.items()}
        if pin["clk"] != self.out.clock:
            raise self.bad(name, f"a gate of another clock than {CLOCK}")
        self.out.clocks[len(self.out.gates_of_clock)] = pin["gclk"]
        self.clocks[pin["gclk"]] = len(self.out.gates_of_clock)
        self.out.gates_of_clock.append(ClockGate(pin["en"], instance_of(name), name))

    def of_library(self, name, cell, connections):
        if cell.other or any(pin.three_state for pin in cell.outputs):
            raise self.bad(name, f"{cell.name} is a {cell.other or 'driver of a bus'}, which has "
                           "no model")
        nets = {pin: self.nets(bits)[0] for pin, bits in connections.items() if bits}
        owner = instance_of(name)
        self.out.cells[cell.name] += 1
        self.out.placed.append((name, cell, nets, owner))
        if cell.register:
            self.flop(name, cell, nets, owner)
            return
        for pin in cell.outputs:
            if nets.get(pin.name, 0) < 2:
                continue
            if not pin.function:
                raise self.bad(name, f"{cell.name} says no function of {pin.name}")
            self.out.gates.append(Gate(cell, pin.name, [nets.get(p, 0) for p in pin.function.pins],
                                       nets[pin.name], owner, name))

    def flop(self, name, cell, nets, owner):
        register = cell.register
        clock = register.clock
        if clock.code not in cell.pins or nets.get(clock.code) not in self.clocks:
            raise self.bad(name, f"{cell.name} is clocked by {clock.text!r}, which is not {CLOCK}'s"
                           " rising edge")
        for when in register.asynchronous:
            bits = {pin: nets.get(pin, 0) for pin in when.pins}
            if any(net > 1 for net in bits.values()) or when.value(bits):
                raise self.bad(name, f"{cell.name} is set or cleared by {when.text!r}, whatever "
                               "the clock does")
        out = {}
        for pin in cell.outputs:
            code = pin.function.code if pin.function else ""
            which = {register.state: "state", register.inverted: "inverted",
                     f"({register.state} ^ 1)": "inverted",
                     f"({register.inverted} ^ 1)": "state"}.get(code)
            if nets.get(pin.name, 0) > 1:
                if not which:
                    raise self.bad(name, f"{cell.name} drives {pin.name} by {code!r}")
                out[which] = nets[pin.name]
        pins = [pin for pin in register.next_state.pins if pin in cell.pins]
        self.out.flops.append(Flop(cell, [nets.get(pin, 0) for pin in pins],
                                   out.get("state") or self.new(), out.get("inverted", 0),
                                   owner, name, self.clocks[nets[clock.code]]))

    def memory(self, name, cell):
        of = {key: number(value) for key, value in cell["parameters"].items()}
        pin = {key: self.nets(bits) for key, bits in cell["connections"].items()}
        width, address = of["WIDTH"], of["ABITS"]
        for side, count in (("RD", of["RD_PORTS"]), ("WR", of["WR_PORTS"])):
            for port in range(count):
                if side == "RD" and not of["RD_CLK_ENABLE"] >> port & 1:
                    continue
                if side == "WR" and not of["WR_CLK_ENABLE"] >> port & 1 or \
                        not of[f"{side}_CLK_POLARITY"] >> port & 1 or \
                        pin[f"{side}_CLK"][port] != self.out.clock:
                    raise self.bad(name, f"a port is not clocked by {CLOCK}'s rising edge")
        if of["RD_WIDE_CONTINUATION"] or of["WR_WIDE_CONTINUATION"] or of["RD_TRANSPARENCY_MASK"]:
            raise self.bad(name, "ports of several words, or that see what is being written, have "
                           "no model")
        if any(pin["RD_ARST"]) or any(pin["RD_SRST"]):
            raise self.bad(name, "a read register with a reset has no model")
        reads = [Read(pin["RD_ADDR"][p * address:(p + 1) * address],
                      [net if net > 1 else self.new()
                       for net in pin["RD_DATA"][p * width:(p + 1) * width]],
                      pin["RD_EN"][p], bool(of["RD_CLK_ENABLE"] >> p & 1))
                 for p in range(of["RD_PORTS"])]
        writes = [Write(pin["WR_ADDR"][p * address:(p + 1) * address],
                        pin["WR_DATA"][p * width:(p + 1) * width],
                        pin["WR_EN"][p * width:(p + 1) * width]) for p in range(of["WR_PORTS"])]
        self.out.memories.append(Memory(width, of["SIZE"], of["OFFSET"],
                                        cell["parameters"]["INIT"][::-1], reads, writes,
                                        instance_of(name) if name.startswith("$") else
                                        self.scope(name), name.replace("\\", "")))

    @staticmethod
    def scope(name):
        """Of a memory's name u_a.genblk1.g_x.mem: the instance, without blocks inside of it."""
        parts = name.split(".")[:-1]
        while parts and not parts[-1].startswith("u_"):
            parts.pop()
        return ".".join(parts)

    def order(self):
        """Gates and memories that are read at once, by levels: each is above what it looks at."""
        out, driver = self.out, {}
        for _, (direction, nets) in out.ports.items():
            if direction == "input":
                driver.update((net, None) for net in nets)
        for flop in out.flops:
            driver.update((net, None) for net in (flop.state, flop.inverted) if net > 1)
        for memory in out.memories:
            for read in memory.reads:
                driver.update((net, None if read.clocked else memory) for net in read.data)
        for gate in out.gates:
            if gate.output in driver:
                raise self.bad(gate.name, f"its output {gate.pin} is driven twice")
            driver[gate.output] = gate
        waits, readers = {}, defaultdict(list)
        parts = out.gates + [memory for memory in out.memories if memory.kind == "file"]
        for part in parts:
            looks = part.inputs if isinstance(part, Gate) else \
                [net for read in part.reads if not read.clocked for net in read.address]
            count = 0
            for net in looks:
                if net > 1 and net not in driver:
                    raise self.bad(part.name, "an input that nothing drives")
                if driver.get(net) is not None:
                    readers[id(driver[net])].append(part)
                    count += 1
            waits[id(part)] = count
        ready = [part for part in parts if not waits[id(part)]]
        done = 0
        while ready:
            part = ready.pop()
            done += 1
            for reader in readers[id(part)]:
                reader.level = max(reader.level, part.level + 1)
                waits[id(reader)] -= 1
                if not waits[id(reader)]:
                    ready.append(reader)
        if done != len(parts):
            stuck = next(part for part in parts if waits[id(part)])
            raise self.bad(stuck.name, "it is in a loop without a register")
        out.gates.sort(key=lambda gate: (gate.level, gate.kind))
        out.nets = self.fresh


def read(path, library):
    return Builder(path, library).out
