# netlist.py - what reaches what in a flat netlist: registers, clocks, ports, through logic or not
# SPDX-License-Identifier: Apache-2.0
"""Reads the JSON that Yosys writes after `proc; flatten; opt_clean`: cells are operators, $dff and
ports of memories. A bit comes from registers, input ports, or both, through cells or through none.
This file and check_crossings.py need nothing else: they go along with an IP folder."""
import json
from collections import defaultdict

LOGIC = 1                               # the lowest bit of what a bit comes from: through a cell
# each bit of the output from the same bit of these inputs alone, and from all of the others
BITWISE = {"$not": ("A",), "$and": ("A", "B"), "$or": ("A", "B"), "$xor": ("A", "B"),
           "$xnor": ("A", "B"), "$mux": ("A", "B"), "$pos": ("A",)}
CLOCKS = ("EHXPLLL",)                   # cells whose outputs come from nothing


class State:
    """A register, or a memory: its name as a tool has it, PATH/OF/INSTANCES/NAME; clock: the port
    that it runs by; marked: the sources have async_reg; src: their files and lines; takes: bits
    that may come into it; bits: those that leave it."""

    def __init__(self, name, clock, marked=False, src=""):
        self.name, self.clock, self.marked, self.src = name, clock, marked, src
        self.takes, self.bits = set(), set()


class Netlist:
    """of its one module that is left; ports: {name: (input or output, bits)}"""

    def __init__(self, path):
        with open(path, encoding="utf-8") as f:
            modules = json.load(f)["modules"]
        tops = [m for m in modules.values() if "top" in m["attributes"]] or list(modules.values())
        if len(tops) != 1:
            raise ValueError(f"{path}: {len(tops)} modules are no flat netlist")
        top = tops[0]
        self.ports = {name: (p["direction"], p["bits"]) for name, p in top["ports"].items()}
        self.inputs = {bit: name for name, (way, bits) in self.ports.items() if way == "input"
                       for bit in bits}
        self.named(top["netnames"])
        self.states, self.memories, self.behind, self.state_of = {}, {}, {}, {}
        for name, cell in top["cells"].items():
            self.memory(cell)
        for name, cell in top["cells"].items():
            self.cell(name, cell)
        clocks = sorted({s.clock for s in self.states.values() if s.clock})
        self.mask = {name: 2 << i for i, name in enumerate(clocks + sorted(
            f"port {name}" for name, (way, _) in self.ports.items() if way == "input"))}
        self.clocks, self.memo = clocks, {}

    # ---- names ----
    def named(self, netnames):
        """names: of a bit; paths: {a.b: a/b} of instances; marked: those with async_reg"""
        self.names, self.paths, self.marked, self.src = defaultdict(list), {"": ""}, set(), {}
        for name, net in netnames.items():
            if net.get("hide_name"):
                continue
            whole = net["attributes"].get("hdlname", name).split()
            if "".join(whole[:-1]):
                self.paths[".".join(whole[:-1])] = "/".join(whole[:-1])
            if "async_reg" in net["attributes"]:
                self.marked.add(name)
            self.src[name] = net["attributes"].get("src", "")
            for bit in net["bits"]:
                self.names[bit].append(name)

    def instance(self, name):
        """Of a cell that has no name of its own: the instance that it is in."""
        inside = name.replace("\\", "").removeprefix("$flatten")
        return inside.partition(".$")[0] if ".$" in inside else ""

    def in_path(self, name):
        where = name
        while where not in self.paths:
            where = where.rpartition(".")[0]
        rest = name[len(where):].lstrip(".")
        return f"{self.paths[where]}/{rest}" if where else rest

    def register(self, cell, bit):
        """The name of a register that the bit is of."""
        where = self.instance(cell)
        found = [n for n in self.names[bit] if n.startswith(where + "." if where else "")]
        return min(found or [cell.replace("\\", "")], key=lambda n: (
            not n.endswith("_q"), n.count("."), n.endswith(("_i", "_o")), len(n)))

    def clock(self, bit):
        return self.inputs.get(bit, f"{min(self.names[bit], default=bit, key=len)}")

    # ---- cells ----
    def state(self, name, clock):
        if name not in self.states:
            self.states[name] = State(self.in_path(name), clock, name in self.marked,
                                      self.src.get(name, ""))
        return self.states[name]

    @staticmethod
    def inward(cell, but=()):
        return [bit for port, bits in cell["connections"].items() if port not in but and
                cell["port_directions"][port] == "input" for bit in bits]

    def memory(self, cell):
        """Ports that write come first: they say what clock a memory has."""
        if cell["type"].startswith(("$memwr", "$meminit")):
            name = cell["parameters"]["MEMID"].replace("\\", "")
            clock = cell["connections"].get("CLK", [None])[0]
            state = self.memories.setdefault(name, State(self.in_path(name), None))
            if cell["type"].startswith("$memwr"):
                state.clock = self.clock(clock)
                state.takes.update(self.inward(cell, ("CLK",)))
            self.states[f"memory {name}"] = state

    def cell(self, name, cell):
        kind, wires = cell["type"], cell["connections"]
        if kind.startswith(("$memwr", "$meminit")):
            return
        if kind.startswith("$mem"):
            of = self.memories.get(cell["parameters"]["MEMID"].replace("\\", ""))
            if int(cell["parameters"]["CLK_ENABLE"], 2):
                raise ValueError(f"{name}: a memory is read behind a register of its own")
            for bit in wires["DATA"]:
                self.behind[bit] = (self.inward(cell, ("CLK", "EN", "ARST", "SRST")),
                                    of if of and of.clock else None)
            return
        if "CLK" in wires and "Q" in wires:
            others = self.inward(cell, ("CLK", "D"))
            for bit, taken in zip(wires["Q"], wires["D"]):
                state = self.state(self.register(name, bit), self.clock(wires["CLK"][0]))
                state.takes.update([taken, *others])
                state.bits.add(bit)
                self.state_of[bit] = state
            return
        if kind in CLOCKS:
            return
        if "SCLK" in wires:             # a register at a pin
            state = self.state(name, self.clock(wires["SCLK"][0]))
            state.takes.update(self.inward(cell, ("SCLK",)))
            for port, bits in wires.items():
                if cell["port_directions"][port] == "output":
                    state.bits.update(bits)
                    self.state_of.update(dict.fromkeys(bits, state))
            return
        if kind in ("$assert", "$assume", "$cover", "$print", "$check", "$scopeinfo"):
            return
        parallel = BITWISE.get(kind, ())
        width = max(len(b) for p, b in wires.items() if cell["port_directions"][p] == "output")
        aligned = all(len(wires[p]) == width for p in parallel)
        for port, bits in wires.items():
            if cell["port_directions"][port] == "output":
                for i, bit in enumerate(bits):
                    taken = self.inward(cell, parallel) + [wires[p][i] for p in parallel] \
                        if parallel and aligned else self.inward(cell)
                    self.behind[bit] = (taken, None)

    # ---- what reaches what ----
    def come_from(self, bit):
        """A mask: LOGIC, clocks of registers, input ports."""
        memo, stack = self.memo, [bit]
        while stack:
            at = stack[-1]
            if at in memo:
                stack.pop()
            elif at in self.state_of:
                memo[at] = self.mask[self.state_of[at].clock]
            elif at in self.inputs:
                memo[at] = self.mask[f"port {self.inputs[at]}"]
            elif at not in self.behind:         # a constant, or nothing
                memo[at] = 0
            else:
                taken, of = self.behind[at]
                left = [b for b in taken if b not in memo]
                stack += left
                if not left:
                    found = LOGIC | (self.mask[of.clock] if of else 0)
                    for b in taken:
                        found |= memo[b]
                    memo[at] = found
        return memo[bit]

    def sources(self, bit, clock):
        """States of another clock than this that the bit comes from: {state: through logic}."""
        found, seen, left = {}, set(), [(bit, False)]
        while left:
            at, through = left.pop()
            if (at, through) in seen:
                continue
            seen.add((at, through))
            state = self.state_of.get(at)
            if state:
                if state.clock != clock:
                    found[state] = found.get(state, False) or through
            elif at in self.behind:
                taken, of = self.behind[at]
                if of and of.clock != clock:
                    found[of] = found.get(of, False) or through
                left += [(b, True) for b in taken]
        return found

    def crossings(self):
        """(from state, to state, through logic), each once, by name."""
        found = {}
        for state in self.states.values():
            other = sum(self.mask[c] for c in self.clocks if c != state.clock)
            for bit in state.takes if state.clock else ():
                if self.come_from(bit) & other:
                    for source, through in self.sources(bit, state.clock).items():
                        pair = source, state
                        found[pair] = found.get(pair, False) or through
        return sorted(((a, b, through) for (a, b), through in found.items()),
                      key=lambda row: (row[1].name, row[0].name))

    def readers(self):
        """{input port: {clock: through logic}} of the registers that it comes to."""
        found = {name: {} for name, (way, _) in self.ports.items() if way == "input"}
        for state in self.states.values():
            for bit in state.takes if state.clock else ():
                mask = self.come_from(bit)
                for name in found:
                    if mask & self.mask[f"port {name}"]:
                        found[name][state.clock] = found[name].get(state.clock, False) or \
                            bool(mask & LOGIC)
        return found
