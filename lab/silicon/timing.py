# timing.py - static timing of a netlist by OpenSTA, register to register
# SPDX-License-Identifier: Apache-2.0
"""run(netlist, library, macros, folder) gives {"mhz", "paths"}: the slowest paths, each with its
delay and the modules that it goes through, which are others than those of slower ones; None if
OpenSTA is not there. The clock is ideal, wires have no delay, ports are left out. Memories are
cells of a library that is written here: their access time from address or clock, no setup."""
import re
import shutil
import subprocess

from .. import intact
from .liberty import Bad

STA = "sta"
PERIOD = 100.0      # ns
LOOKED_AT = 400     # slowest ends of paths
PATHS = 10          # that are told, each through other modules than the ones before
THRESHOLDS = "".join(
    f"{what}_{edge} : {percent};\n" for edge in ("rise", "fall") for what, percent in
    (("input_threshold_pct", 50), ("output_threshold_pct", 50), ("slew_lower_threshold_pct", 20),
     ("slew_upper_threshold_pct", 80)))
ZERO = "".join(f'{edge}_constraint(scalar) {{ values("0.0"); }} ' for edge in ("rise", "fall"))
GATE = ("cell (rt_clock_gate) { area : 0;\n"
        "pin (clk) { direction : input; clock : true; capacitance : 0; }\n"
        'pin (en) { direction : input; capacitance : 0; timing() { related_pin : "clk"; '
        f"timing_type : setup_rising; {ZERO}}} }}\n"
        'pin (gclk) { direction : output; timing() { related_pin : "clk"; '
        "timing_sense : positive_unate; "
        + "".join(f'{what}(scalar) {{ values("0.0"); }} ' for what in
                  ("cell_rise", "cell_fall", "rise_transition", "fall_transition")) + "} }\n}\n")
SCRIPT = """read_liberty {liberty}
read_liberty {folder}/macros.lib
read_verilog {folder}/timing.v
link_design core
create_clock -name clk -period {period} [get_ports clk]
report_checks -path_delay max -group_count {paths} -format full -digits 4
exit
"""


def pins(kind, net_lists):
    """[(name of the pin, net)] of lists of nets."""
    return [(f"{kind}{which}_{bit}", net) for which, nets in enumerate(net_lists)
            for bit, net in enumerate(nets)]


def macro_pins(memory):
    """Inputs that are looked at with the clock, addresses of ports that are read at once by port,
    outputs by port."""
    clocked, at_once, out = [], [], []
    for which, read in enumerate(memory.reads):
        address = pins(f"ra{which}", [read.address])
        if read.clocked:
            clocked += address + pins(f"re{which}", [[read.enable]])
        at_once.append([] if read.clocked else address)
        out.append(pins(f"rd{which}", [read.data]))
    for which, write in enumerate(memory.writes):
        clocked += pins(f"w{which}", [write.address, write.data, write.enable])
    return clocked, at_once, out


def macro(name, memory, time, capacitance):
    """A cell of Liberty, ns and pF."""
    clocked, at_once, out = macro_pins(memory)
    scalars = "".join(f'{kind}(scalar) {{ values("{value:.4f}"); }} ' for kind, value in
                      (("cell_rise", time), ("cell_fall", time), ("rise_transition", 0.05),
                       ("fall_transition", 0.05)))
    text = [f"cell ({name}) {{ area : 0;\n",
            "pin (clk) { direction : input; clock : true; capacitance : 0; }\n"]
    for pin, _ in clocked:
        text.append(f"pin ({pin}) {{ direction : input; capacitance : {capacitance:.5f}; timing() "
                    f'{{ related_pin : "clk"; timing_type : setup_rising; {ZERO}}} }}\n')
    for address, data in zip(at_once, out):
        for pin, _ in address:
            text.append(f"pin ({pin}) {{ direction : input; capacitance : {capacitance:.5f}; }}\n")
        arcs = f'timing() {{ related_pin : "clk"; timing_type : rising_edge; {scalars}}} '
        if address:
            arcs += (f'timing() {{ related_pin : "{" ".join(pin for pin, _ in address)}"; '
                     f"timing_sense : non_unate; {scalars}}} ")
        text += [f"pin ({pin}) {{ direction : output; {arcs}}}\n" for pin, _ in data]
    return "".join(text) + "}\n"


def verilog(netlist, folder):
    """The netlist, with instances i0, i1, ... of placed cells, m0, ... of memories."""
    def net(number):
        return f"n{number}" if number > 1 else f"1'b{number}"
    ports, wires = [], []
    for name, (direction, nets) in netlist.ports.items():
        ports += [(f"{name}_{bit}" if name != "clk" else "clk", direction, number)
                  for bit, number in enumerate(nets)]
    for name, direction, number in ports:
        wires.append(f"{direction} {name};\n")
        if direction == "input":
            wires.append(f"wire n{number};\nassign n{number} = {name};\n" if number > 1 else "")
        else:
            wires.append(f"assign {name} = {net(number)};\n")
    lines = [f"{cell.name} i{at} (" + ", ".join(f".{pin}({net(number)})" for pin, number in
                                                nets.items()) + ");\n"
             for at, (_, cell, nets, _) in enumerate(netlist.placed)]
    lines += [f"rt_clock_gate g{at} (.en({net(gate.enable)}), .clk({net(netlist.clock)}), "
              f".gclk({net(netlist.gated_clock(at))}));\n"
              for at, gate in enumerate(netlist.gates_of_clock)]
    for at, memory in enumerate(netlist.memories):
        clocked, at_once, out = macro_pins(memory)
        every = clocked + sum(at_once, []) + sum(out, [])
        lines.append(f"macro{at} m{at} (.clk({net(netlist.clock)}), "
                     + ", ".join(f".{pin}({net(number)})" for pin, number in every) + ");\n")
    intact.write(folder / "timing.v", "".join(
        [f"module core ({', '.join(name for name, _, _ in ports)});\n"] + wires + lines
        + ["endmodule\n"]))


def through(text, netlist):
    """Modules along a path, in its order."""
    found = []
    for kind, number in re.findall(r"\b([img])(\d+)/", text):
        at = int(number)
        module = (netlist.owner_module(netlist.placed[at][3]) if kind == "i" else
                  netlist.user_module(netlist.memories[at]) if kind == "m" else
                  netlist.owner_module(netlist.gates_of_clock[at].owner))
        if not found or found[-1] != module:
            found.append(module)
    return found


def run(netlist, library, macros, folder):
    if not shutil.which(STA):
        return None
    verilog(netlist, folder)
    intact.write(folder / "macros.lib", "library (macros) {\n"
                 'delay_model : table_lookup; time_unit : "1ns"; voltage_unit : "1V"; '
                 "capacitive_load_unit (1, pf); "
                 'current_unit : "1mA"; leakage_power_unit : "1nW"; '
                 f"nom_voltage : {library.voltage or 1};\n"
                 + THRESHOLDS + GATE
                 + "".join(macro(f"macro{at}", memory, macros.time(memory), macros.pin(memory))
                           for at, memory in enumerate(netlist.memories)) + "}\n")
    intact.write(folder / "timing.tcl", SCRIPT.format(
        liberty=library.path, folder=folder, period=PERIOD, paths=LOOKED_AT))
    done = subprocess.run([STA, "-no_splash", "-exit", str(folder / "timing.tcl")],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    intact.write(folder / "timing.log", done.stdout)
    paths = {}
    for text, slack in re.findall(r"Startpoint:(.*?)\s(-?[\d.]+)\s+slack", done.stdout, re.S):
        paths.setdefault(tuple(through(text, netlist)), round(PERIOD - float(slack), 3))
    if not paths:
        raise Bad(f"{folder}/timing.log: OpenSTA found no path between registers")
    return {"mhz": 1000 / max(paths.values()),
            "paths": [{"ns": ns, "through": list(modules)}
                      for modules, ns in list(paths.items())[:PATHS]]}
