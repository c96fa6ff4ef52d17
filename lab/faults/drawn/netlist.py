# netlist.py - elaborated RTL with many faults in it, one of which a number selects
# SPDX-License-Identifier: Apache-2.0
"""Yosys elaborates a module and all below it, without mapping or optimising: its cells are the
operators of the source. `mutate` chooses faults in them and puts all of a batch into one netlist,
each behind its own value of `mutsel`. A fault is known by

  module       as the source has it
  where        file and lines of the cell, in rtl/
  cell, nth    its name without Yosys' numbers, or its type; which one of those that are alike
  port, bit    where the fault is
  mode, other  inv, const0, const1, or cnot0, cnot1: inverted where bit `other` of the port is 0, 1

so that it can be found in a netlist with other parameters; it is put into every variant of the
module, as a fault of the source would be. Clocks have none: a design of one clock has no fault of
that kind."""
import glob
import json
import os
import re
import subprocess
from collections import defaultdict, namedtuple

Fault = namedtuple("Fault", "module where cell nth port bit mode other")
PUBLIC = "/* verilator public_flat_rd */"
CLOCK = re.compile(r"(.*_)?(S?CLK(I|FB|O.*)?|clk5?)(_i|_o)?")
WIDTH = 16  # bits of mutsel; value 0 is the sound netlist


def base(name):
    """The source's name of a module that Yosys has given parameters."""
    return re.search(r"(rt_[a-z0-9_]+)(?:\\|$)", name)[1]


def columns(where):
    return re.findall(r"\.(\d+)", where.split(":")[-1])


def run(folder, name, lines):
    """Runs a script of Yosys; what it printed."""
    script = os.path.join(folder, name)
    with open(script, "w", encoding="utf-8") as f:
        f.write("\n".join(lines) + "\n")
    ran = subprocess.run(["yosys", "-q", "-s", script], check=False, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ran.returncode:
        raise RuntimeError(f"{script}: {ran.stdout[-2000:]}")
    return ran.stdout


def public():
    found = set()
    for name in glob.glob("rtl/*/*.v"):
        with open(name, encoding="utf-8") as f:
            found |= set(re.findall(rf"(\w+)\s*{re.escape(PUBLIC)}", f.read()))
    return sorted(found)


def head(name):
    """The head of a module in the place of it."""
    with open(glob.glob(f"rtl/*/{name}.v")[0], encoding="utf-8") as f:
        return f.read().split("\n);\n", maxsplit=1)[0] + "\n);\n"


def elaborate(folder, top, parameters, outside, cells):
    folders = sorted({os.path.dirname(n) for n in glob.glob("rtl/*/*.v")})
    for name in outside:
        with open(f"{folder}/{name}.v", "w", encoding="utf-8") as f:
            f.write(head(name) + "endmodule\n")
    files = [n for n in sorted(glob.glob("rtl/*/*.v")) if os.path.basename(n)[:-2] not in outside]
    values = " ".join(f"-set {n} {v}" for n, v in parameters)
    return ["verilog_defaults -add " + " ".join("-I" + f for f in folders),
            "read_verilog -defer " + " ".join(files),
            *(f"read_verilog -lib {folder}/{name}.v" for name in outside),
            *(f"read_verilog -lib {name}" for name in cells),
            *([f"chparam {values} {top}"] if parameters else []),
            f"hierarchy -top {top}", "proc -norom",
            "setattr -set keep 1 " + " ".join("w:" + name for name in public()),
            "opt_expr", "opt_clean", "wreduce", "opt_clean"]


class Netlist:
    """A module and all below it: their cells, and the faults that fit into them. Modules that are
    outside, and a vendor's cells in files of models, are instances without anything in them."""

    def __init__(self, folder, top, parameters, outside=(), cells=()):
        self.folder, self.top = folder, top
        self.script = [f"read_rtlil {folder}/plain.il"]
        os.makedirs(folder, exist_ok=True)
        plain = f"{folder}/plain.json"
        run(folder, "plain.ys", elaborate(folder, top, parameters, outside, cells) +
            [f"write_rtlil {folder}/plain.il", f"write_json {plain}"])
        with open(plain, encoding="utf-8") as f:
            found = {name: module for name, module in json.load(f)["modules"].items()
                     if "blackbox" not in module["attributes"]}
        os.remove(plain)
        self.variants = defaultdict(list)   # module: its names in the netlist
        self.cells = {}                     # (variant, name): key of the cell
        self.at = {}                        # (variant, key): its name, {port: bits}
        self.size = {}                      # variant: bits of its cells' ports
        self.fixed = {}                     # variant: {(cell, port, bit): "0" or "1"}
        self.dead = {}                      # variant: {(cell, port, bit)} that no output hears of
        self.both = set()                   # (variant, cell, port) of both directions: a pin
        for name, module in found.items():
            self.variants[base(name)].append(name)
            self._cells(name, module["cells"])
            self.both |= {(name, cell, port) for cell, what in module["cells"].items()
                          for port, way in what["port_directions"].items() if way == "inout"}
            self.fixed[name] = {(cell, port, i): bit for cell, what in module["cells"].items()
                                for port, bits in what["connections"].items()
                                for i, bit in enumerate(bits) if bit in ("0", "1")}
        read = {}                           # variant: bits of its inputs that it reads
        def look(name):
            if name not in read:
                for cell in found[name]["cells"].values():
                    if cell["type"] in found:
                        look(cell["type"])
                self.dead[name], read[name] = dead(found[name], read)
        for name in found:
            look(name)
        for names in self.variants.values():
            names.sort(key=lambda n: (-self.size[n], n))

    def _cells(self, variant, cells):
        def number(item):
            last = re.search(r"\$(\d+)$", item[0])
            return int(last[1]) if last else 0, item[0]
        alike, bits = defaultdict(int), 0
        for name, cell in sorted(cells.items(), key=number):
            where = re.sub(r"rtl/", "", cell["attributes"].get("src", "").split("|")[-1])
            plain = name if "$" not in name else cell["type"] if cell["type"][0] == "$" else "cell"
            what = (where, plain.split("$")[-1] if plain[0] == "$" else plain)
            key = (*what, alike[what])
            alike[what] += 1
            self.cells[variant, name] = key
            ports = {p: len(b) for p, b in cell["connections"].items()}
            self.at[variant, key] = name, ports
            bits += sum(ports.values())
        self.size[variant] = bits

    def choose(self, counts, seed):
        """Faults of modules, at most {module: count}, by Yosys' measure of what they cover."""
        run(self.folder, "list.ys", self.script + [
            f"mutate -list {count + count // 4 + 4} -seed {seed} "
            f"-module {self.variants[module][0]} -o {self.folder}/{module}.list"
            for module, count in counts.items()])
        return [fault for module, count in counts.items()
                for fault in self._listed(module)[:count]]

    def _listed(self, module):
        listed, chosen = f"{self.folder}/{module}.list", []
        with open(listed, encoding="utf-8") as f:
            for line in f:
                word = line.split()
                option = dict(zip(word[1::2], word[2::2]))
                port, wire = option["-port"].lstrip("\\"), option.get("-wire", "").lstrip("\\")
                variant, name = self.variants[module][0], option["-cell"].lstrip("\\")
                if (CLOCK.fullmatch(port) or CLOCK.fullmatch(wire) or
                        (variant, name, port) in self.both):    # which a fault would cut in two
                    continue
                bit, other = int(option["-portbit"]), int(option.get("-ctrlbit", -1))
                fixed = self.fixed[variant]
                if (name, port, bit) in self.dead[variant] or (
                        option["-mode"] == "const" + fixed.get((name, port, bit), "-")) or (
                        other >= 0 and (name, port, other) in fixed
                        and option["-mode"] != "cnot" + fixed[name, port, other]):
                    continue    # no fault: nothing depends on it, or it changes nothing
                where, cell, nth = self.cells[variant, name]
                if option["-mode"] == IDLE.get(cell) or cell.startswith("meminit"):
                    continue    # a word that a file gives a ROM is no fault of the source
                chosen.append(Fault(module, where, cell, nth, port, bit, option["-mode"], other))
        os.remove(listed)
        return list(dict.fromkeys(chosen))

    def places(self, fault):
        """Commands of Yosys, without selector, that put a fault into every variant it fits."""
        for variant in self.variants.get(fault.module, ()):
            name, ports = self.at.get((variant, (fault.where, fault.cell, fault.nth)), ("", {}))
            if max(fault.bit, fault.other) < ports.get(fault.port, 0):
                yield (f"mutate -mode {fault.mode} -module {variant} -cell "
                       f"{name if name[0] == '$' else chr(92) + name} "
                       f"-port {chr(92)}{fault.port} -portbit {fault.bit}"
                       + (f" -ctrlbit {fault.other}" if fault.other >= 0 else ""))

    def again(self, fault):
        """The fault, or what it is called where lines have moved: the module's one cell that is
        alike and in the same columns, an instance by its name alone. None if there is none."""
        if any(self.places(fault)):
            return fault
        named = fault.cell.split(".")[-1].startswith("u_")
        moved = {fault._replace(where=where) for _, (where, cell, nth) in self.at
                 if (cell, nth) == (fault.cell, fault.nth)
                 and (named or columns(where) == columns(fault.where))}
        moved = [f for f in moved if any(self.places(f))]
        return moved[0] if len(moved) == 1 else None

    def write(self, faults, verilog):
        """A Verilog file with faults 1, 2, ...; which of them fit. C++ gives their number."""
        lines, fitting = [], []
        for fault in faults:
            found = list(self.places(fault))
            if found:
                fitting.append(fault)
                lines += [f"{p} -ctrl mutsel {WIDTH} {len(fitting)}" for p in found]
        run(self.folder, "write.ys", self.script + lines + [f"write_verilog -noattr {verilog}"])
        with open(verilog, encoding="utf-8") as f:
            text = f.read()
        with open(verilog, "w", encoding="utf-8") as f:
            f.write(marked(selected(text, self.top) if fitting else text))
        return fitting


# A bit of an `or` may be what it likes where another one is 1, and one of an `and` where it is 0.
IDLE = {"reduce_or": "cnot1", "reduce_bool": "cnot1", "logic_not": "cnot1", "logic_and": "cnot1",
        "logic_or": "cnot1", "reduce_and": "cnot0"}
BITWISE = {"$mux", "$pmux", "$dff", "$and", "$or", "$xor", "$xnor", "$not", "$pos"}
CARRIES = {"$add", "$sub", "$mul", "$neg", "$shl", "$sshl"}


def dead(module, read):
    """Bits of cells' ports that no output of the module and no instance in it depends on: a fault
    there is none. Bits of a word are told apart where an operator treats them apart. Then the bits
    of inputs that something depends on; `read` has those of the modules below."""
    readers = defaultdict(list)     # bit: (cell, port, index) that drive it
    cells = module["cells"]
    for name, cell in cells.items():
        for port, way in cell["port_directions"].items():
            if way == "output":
                for i, bit in enumerate(cell["connections"][port]):
                    readers[bit].append((name, port, i))
    live, todo = set(), [bit for port in module["ports"].values() if port["direction"] != "input"
                         for bit in port["bits"]]

    def inputs(name, port, i):
        cell = cells[name]
        kind, nets = cell["type"], cell["connections"]
        for other, way in cell["port_directions"].items():
            if way == "output":
                continue
            for j, bit in enumerate(nets[other]):
                if kind in read and (other, j) not in read[kind]:
                    continue
                if kind in BITWISE and other in "ABD" and j % len(nets[port]) != i and (
                        len(nets[other]) % len(nets[port]) == 0):
                    continue
                if kind in CARRIES and other == "A" and j > i or (
                        kind in ("$add", "$sub", "$mul") and other == "B" and j > i):
                    continue
                yield (name, other, j), bit

    for name, cell in cells.items():  # what an instance or a memory does is not looked at
        if cell["type"][0] != "$" or cell["type"].startswith(("$paramod", "$mem")):
            below = read.get(cell["type"])
            for port, way in cell["port_directions"].items():
                for i, bit in enumerate(cell["connections"][port]):
                    if way != "output" and (below is None or (port, i) in below):
                        live.add((name, port, i))
                        todo.append(bit)
    seen = set()
    while todo:
        bit = todo.pop()
        if bit in seen:
            continue
        seen.add(bit)
        for place in readers[bit]:
            live.add(place)
            for spot, more in inputs(*place):
                live.add(spot)
                todo.append(more)
    return {(name, port, i) for name, cell in cells.items() for port in cell["connections"]
            for i in range(len(cell["connections"][port])) if (name, port, i) not in live}, {
        (name, i) for name, port in module["ports"].items() if port["direction"] == "input"
        for i, bit in enumerate(port["bits"]) if bit in seen}


def marked(text):
    """Signals inside that benches read: Yosys writes none of Verilator's comments."""
    return re.sub(rf"^(  wire (?:\[.*\] )?(?:{'|'.join(public())}));", rf"\1 {PUBLIC};", text,
                  flags=re.M)


def selected(text, top):
    """The port `mutsel` of the top module becomes a register that C++ sets: it comes down to all
    modules with faults, and stands in no port that a bench would have to know."""
    at = re.search(rf"^module {top}\s*\(", text, re.M).start()
    head, rest = text[:at], text[at:]
    port = f"  input [{WIDTH - 1}:0] mutsel;\n  wire [{WIDTH - 1}:0] mutsel;\n"
    rest, found = re.subn(r"\A([^;]*), mutsel\s*\);", r"\1);", rest)  # Yosys breaks some lines
    if not found or port not in rest:
        raise RuntimeError(f"{top} has no selector of faults")
    return head + rest.replace(
        port, '  import "DPI-C" function int mutant_number();\n'
        f"  reg [{WIDTH - 1}:0] mutsel;\n  initial mutsel = mutant_number();\n", 1)
