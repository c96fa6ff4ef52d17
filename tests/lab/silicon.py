# silicon.py - checks of lab/silicon: libraries, tables of memories, cells beside Icarus, a report
# SPDX-License-Identifier: Apache-2.0
"""usage: PYTHONPATH=. tests/lab/silicon.py read|macros|fit|budget|icarus|report [ARGUMENT...]

Each says what is wrong and ends with 1, or says nothing."""
import ctypes
import json
import random
import re
import subprocess
import sys
from pathlib import Path

from lab.pages import data
from lab.silicon import budget, core, fit, liberty, macros, netlist, program, report
from lab.silicon.function import Function

SMALL = Path("tests/lab/small.lib")
AND2 = 'function : "A & B";'
# What is replaced in small.lib (None: the file ends there), by what; what is said, line first.
BAD = (
    ("cell (NOR2) {", None, r"\d+: the file ends inside of library small, which began in line 4"),
    ("area : 3; cell", None, r"\d+: the file ends inside of cell AND2, which began in line \d+"),
    ("library (small)", "cell (small)", r"4: a library is expected, there is 'cell'"),
    ("library (small) {", "library (small) ;", r"4: '{' is missing behind library \(small\)"),
    ('"1ns"', '"1ns', r"\d+: "),                             # a text runs on
    ('"1ns"', '"1h"', r"6: time_unit is '1h', not such as 1ns"),
    ("(1, pf)", "(1, pint)", r"\d+: capacitive_load_unit is \(1, pint\), not such as \(1, pf\)"),
    ("area : 3;", "area : big;", r"\d+: area is 'big', no number"),
    ("area : 3;", "area : ;", r"\d+: area has no value"),
    ("area : 3;", "area 3;", r"\d+: '\(' is missing behind area, there is '3'"),
    ("pin (A) {", "pin (A {", r"\d+: pin \( has no '\)'"),
    ("direction : input; ", "", r"\d+: pin A has no direction"),
    (AND2, 'function : "A & X";', r"\d+: function 'A & X': the cell has no pin X"),
    (AND2, 'function : "A & ";', r"\d+: function 'A & ': it ends where a pin should be"),
    (AND2, 'function : "(A B";', r"\d+: function '\(A B': '\)' is missing"),
    (AND2, 'function : "A % B";', r"\d+: function 'A % B': '%' in a function"),
    (AND2, 'function : "A B) ";', r"\d+: function 'A B\) ': '\)' is too much"),
    ('"0.02, 0.02", "0.02, 0.02"', '"0.02, 0.02"', r"\d+: 2 values, the axes of rise_power have 4"),
    ('"0.02, 0.02", "0.02, 0.02"', '"0.02, x", "0, 0"', r"\d+: values: 'x' is no number"),
    ("rise_power (energy)", "rise_power (work)", r"\d+: rise_power: there is no template 'work'"),
    ('index_2 ("0, 1");', 'index_2 ("1, 0");', r"\d+: index_2 does not rise"),
    ("cell (AND2)", "cell (NAND2)", r"\d+: there is a second cell NAND2"),
    ("cell (AND2)", "cell ()", r"\d+: a cell without a name"),
    ('next_state : "D"; ', "", r"\d+: ff has no next_state"),
    ("nom_voltage : 2;", "", r"4: library has no nom_voltage, which energy needs"),
    ("/* small.lib", "/ * small.lib", r"1: a library is expected, there is '/'"),
)
# (text of a function, {pins: value})
FUNCTIONS = (
    ("A B'", ("AB", (0, 0, 1, 0))), ("!(A+B)", ("AB", (1, 0, 0, 0))), ("A^B", ("AB", (0, 1, 1, 0))),
    ("A | B & C", ("ABC", (0, 0, 0, 1, 1, 1, 1, 1))),   # and binds before or
    ("A * B ^ C", ("ABC", (0, 0, 0, 0, 0, 1, 1, 0))),   # exclusive or before and: A (B ^ C)
    ("(A + B)'", ("AB", (1, 0, 0, 0))), ("0", ("", (0,))), ("A''", ("A", (0, 1))),
)
MACROS = (
    ("file\t", "disc\t", r":\d+: 'disc' is none of ram, file"),
    ("ram\t6000", "ram\tmany", r":\d+: could not convert string to float: 'many'"),
    ("ram\t6000\t", "ram\t", r":\d+: 7 columns, not 8"),
    ("um2_bit\t", "um2_byte\t", r":\d+: columns are not kind um2 um2_bit"),
    ("file\t1500", "#", r": there is no line file"),
    ("reference\t24", "reference\t0", r":\d+: reference is um2, pJ and ns of a NAND2, above 0"),
)


def wrong(text):
    sys.exit(text)


def edited(source, old, new, path):
    text = source.read_text("utf-8")
    if old not in text:
        wrong(f"{source} has no {old!r}")
    at = text.index(old)
    path.write_text(text[:at] if new is None else text[:at] + new + text[at + len(old):], "utf-8")


def refused(read, path, said, what):
    try:
        read()
    except liberty.Bad as error:
        if re.match(re.escape(str(path)) + said, str(error)):
            return
        wrong(f"{what}: says {error}")
    wrong(f"{what}: was read")


def read(folder):
    """Libraries that are wrong, functions, a value between points of a table."""
    path = Path(folder, "bad.lib")
    for old, new, said in BAD:
        edited(SMALL, old, new, path)
        refused(lambda: liberty.read(path), path, ":" + said, f"{old} as {new}")
    refused(lambda: liberty.read("none.lib"), "none.lib", ": No such file", "no file")
    for text, (pins, values) in FUNCTIONS:
        function = Function(text)
        for at, value in enumerate(values):
            bits = {pin: at >> (len(pins) - 1 - i) & 1 for i, pin in enumerate(pins)}
            if function.value(bits) != value:
                wrong(f"{text}: {bits} gives {function.value(bits)}")
    inv = liberty.read(SMALL).cells["INV"].pins["Y"]
    for load, slew, value in ((0, 0, 0.1), (0.5, 0, 0.3), (0.5, 0.5, 0.35), (9, 0, 0.5)):
        if abs(inv.slews[0].at(load=load, slew=slew) - value) > 1e-9:
            wrong(f"a transition at {load} pF, {slew} ns is not {value} ns")
    if abs(inv.power[0].energy(0, 0) - 0.03) > 1e-9:
        wrong("an inverter takes another energy than 0.03 pJ")


def tables(folder):
    """Tables of memories that are wrong; one that is scaled."""
    path, library = Path(folder, "bad.tsv"), liberty.read(SMALL)
    for old, new, said in MACROS:
        edited(Path(macros.DEFAULT), old, new, path)
        refused(lambda: macros.read(path, library), path, said, f"{old} as {new}")
    scaled = macros.read(macros.DEFAULT, library).scaled
    if abs(scaled[0] - 2 / 24) > 1e-9:
        wrong(f"areas are scaled by {scaled[0]}, not by the area of NAND2")


# ---- beside Icarus ----
KNOWN, CLOCKS = 200, 500    # clocks until all is known, and in all
BENCH = """`timescale 1ns / 1ps
module bench;
    reg clk = 1'b0;
    reg [%d:0] words [0:%d];
    integer i;
    %s
    %s u (%s);
    initial begin
        $readmemb("%s", words);
        $dumpfile("%s");
        $dumpvars(0, u);
        for (i = 0; i < %d; i = i + 1) begin
            #1 {%s} = words[i];     // the clock is high: gates of it are shut
            #4 clk = 1'b0;
            #5 clk = 1'b1;
        end
        $finish;
    end
endmodule
"""


def changes(path):
    """{net of Icarus, with its bit: [times at which it changes, from KNOWN on]}; an unknown value
    behind KNOWN is wrong."""
    names, found, time, scopes = {}, {}, 0, 0
    for line in path.read_text("utf-8").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "$scope":
            scopes += 1
        elif words[0] == "$upscope":
            scopes -= 1
        elif words[0] == "$var" and scopes == 2:    # not the insides of cells
            names.setdefault(words[3], []).append((words[4].lstrip("\\\\"), int(words[2])))
        elif line[0] == "#":
            time = int(line[1:])
        elif line[0] in "01xzb" and words[-1] != "$end":
            value, code = (words[0][1:], words[1]) if line[0] == "b" else (line[0], line[1:])
            for name, width in names.get(code, []):
                fill = "0" if value[0] == "1" else value[0]
                for bit, one in enumerate(value.rjust(width, fill)[::-1]):
                    found.setdefault((name, bit), []).append((time, one))
    return found


def toggles(values):
    """Clocks behind KNOWN before whose rising edge a net has another value than before the last."""
    count, last, at = 0, None, 0
    for clock in range(CLOCKS):
        edge = 1000 * (10 * clock + 10)     # ps
        while at < len(values) and values[at][0] < edge:
            now = values[at][1]
            at += 1
        if clock >= KNOWN and now not in "01":
            return None
        count += clock > KNOWN and now != last
        last = now
    return count


def icarus(folder, lib, models, top):
    """TOP's cells, mapped before to FOLDER/TOP.json, beside Icarus: toggles of all nets."""
    folder, library = Path(folder), liberty.read(lib)
    path = folder / f"{top}.json"
    cells = netlist.read(path, library)
    layout = program.Layout(cells)
    program.build(layout, folder / f"{top}.so")
    simulated = ctypes.CDLL(str(folder / f"{top}.so"))
    simulated.gates_get.restype = ctypes.c_uint64
    inputs = {name: len(nets) for name, (way, nets) in cells.ports.items()
              if way == "input" and name != "clk"}
    drawn = random.Random(1)
    rows = [{name: int(clock < 4) if name == "rst" else drawn.getrandbits(width)
             for name, width in inputs.items()} for clock in range(CLOCKS)]
    words, vcd, out = folder / "words", folder / f"{top}.vcd", folder / f"{top}.vvp"
    words.write_text("".join("".join(f"{row[name]:0{width}b}" for name, width in inputs.items())
                             + "\n" for row in rows), "utf-8")
    ports = ", ".join(f".{name}({name})" for name in ["clk", *inputs])
    (folder / "bench.v").write_text(BENCH % (
        sum(inputs.values()) - 1, CLOCKS - 1, "".join(
            f"reg [{width - 1}:0] {name} = 0; " for name, width in inputs.items()),
        top, ports, words, vcd, CLOCKS, ", ".join(inputs)), "utf-8")
    subprocess.run(["yosys", "-q", "-p", f"read_json {path}; write_verilog -noattr -norename "
                    f"{folder}/{top}.v"], check=True)
    subprocess.run(["iverilog", "-g2005", "-s", "bench", "-o", out, folder / "bench.v",
                    folder / f"{top}.v", models], check=True)
    subprocess.run(["vvp", "-n", out], check=True, stdout=subprocess.DEVNULL)
    seen = changes(vcd)
    simulated.gates_start(ctypes.c_uint64(7))
    for clock, row in enumerate(rows):
        for name, value in row.items():
            for low in range(0, inputs[name], 64):
                simulated.gates_set(name.encode(), ctypes.c_uint64(value >> low & (1 << 64) - 1),
                                    ctypes.c_size_t(low))
        simulated.gates_settle()
        simulated.gates_count(ctypes.c_int(0 if clock > KNOWN else -1))
        simulated.gates_edge()
    libc = ctypes.CDLL(None)
    libc.fopen.restype = ctypes.c_void_p
    file = libc.fopen(str(folder / "toggles").encode(), b"w")
    simulated.gates_write(ctypes.c_void_p(file))
    libc.fclose(ctypes.c_void_p(file))
    counted = report.Toggles(folder / "toggles", layout.count, len(layout.reads + layout.writes))
    module = json.loads(path.read_text("utf-8"))["modules"][top]
    compared = 0
    for name, net in module["netnames"].items():
        for bit, number in enumerate(net["bits"]):
            values = seen.get((name, bit))
            if not isinstance(number, int) or values is None or number not in layout.place \
                    or number == cells.clock:
                continue
            want, got = toggles(values), counted.nets[layout.place[number]][0]
            compared += 1
            if want != got:
                wrong(f"{top}: {name}[{bit}] toggles {got} times, {want} in Icarus")
    if compared < layout.count // 2:
        wrong(f"{top}: {compared} nets of {layout.count} were compared")
    print(f"{top}: {compared} nets, {len(cells.gates_of_clock)} gates of the clock")


def said(folder, lib, top, *power):
    """Fields of a report of TOP's cells and made toggles; power: `no` if LIB has no such tables."""
    folder = Path(folder)
    core.main(folder / f"{top}.json", lib, macros.DEFAULT, folder)
    known = json.loads((folder / "core.json").read_text("utf-8"))
    counts = [f"{2 * (net[2] >= 0)} 0" for net in known["nets"]] + ["3 0"] * len(
        known["accesses"]) + ["1 0"] * len(known["clock_gates"])
    (folder / "toggles").write_text("clocks 4 2\n" + "\n".join(counts) + "\n", "utf-8")
    (folder / "report.json").write_text(json.dumps({
        "scene": "none", "profile": "draft", "core": "none", "pixels": 2,
        "cold": {"counters": {"cycles": 4, "rays_primary": 2, "rays_shadow": 1,
                              "rays_waiting": 9}}}), "utf-8")
    report.main(folder, folder)
    found = json.loads((folder / "silicon.json").read_text("utf-8"))
    if found["rays"] != 3 or found["kge"] <= 0 or not found["blocks"]:
        wrong("rays, kGE or blocks are wrong")
    if power:
        return None if found["energy"] is None else wrong("there is energy without tables of it")
    energy = found["energy"]
    busy = sum(energy["busy"].values())
    switching = sum(net[0] * 2 for net in known["nets"] if net[2] >= 0) / 4
    ram = sum(access[0] * 3 for access in known["accesses"]) / 4
    clock = sum(known["clock"].values()) + sum(gate[0] for gate in known["clock_gates"]) / 4
    for name, got, want in (
            ("switching", energy["busy"]["switching"], switching),
            ("memories", energy["busy"]["memories"], ram),
            ("clock pins", energy["busy"]["clock pins"], clock),
            ("idle", sum(energy["idle"].values()), sum(known["clock"].values())),
            ("a pixel", energy["nj_pixel"], busy * 4 / 1000 / 2),
            ("a ray", energy["nj_ray"], busy * 4 / 1000 / 3)):
        if abs(got - want) > 1e-6 * max(1, want):
            wrong(f"{name} is {got}, not {want}")
    return None


# ---- energies of events ----
MOST = 0.10     # that a frame outside of the fit may be off


def energies():
    """Weights of made frames are found again; frames of the page that no fit has seen are near."""
    want, clock = [5.0, 7.0, 3.0, 1.0, 0.0, 4.0, 2.0, 8.0, 6.0, 9.0], 3000.0
    drawn, lists = random.Random(1), ("shadow+lights1", "texture+boxes", "refract+facets+bih")
    frames = []
    for at in range(40):
        effects = lists[at % len(lists)]
        counts = [float(count) for count in fit.counts(
            {name: drawn.randrange(1, 9) for name, _ in fit.EVENTS.values()}, effects)]
        scale, profile = (0.5, "draft") if at > 36 else (1.0, "standard")
        idle = clock * (1 + (fit.TRIANGLES in effects))
        frames.append({"fit": "in", "effects": effects, "profile": profile, "cycles": 10.0,
                       "LUT4eq": 10000.0, "idle pJ": idle, "nJ":
                       idle / 100 + scale * sum(map(float.__mul__, want, counts)),
                       **dict(zip(fit.COUNTS, counts))})
    found = fit.fitted(frames)
    if any(abs(a - b) > 1e-9 for a, b in zip(found.weights, want)) \
            or abs(found.scales["draft"] - 0.5) > 1e-9:
        wrong(f"{found.weights}, {found.scales}, not {want} and half of it")
    if any(abs(sum(found.parts(frame).values()) - frame["nJ"]) > 1e-6 for frame in frames):
        wrong("a made frame takes another energy than it was made of")
    head, rows = data.read("silicon.frames")
    for row in rows:
        frame = dict(zip(head, row))
        if frame["fit"] == "out" and abs(float(frame["off"].split()[0])) > 100 * MOST:
            wrong(f"{frame['frame']} {frame['profile']} is off by {frame['off']}")
    if not any(row[head.index("fit")] == "out" for row in rows):
        wrong("no frame is held out")


def budgets(folder):
    """A frame that takes as much as it may, or more; lines of a budget that are none."""
    found = {"energy": {"busy": {"switching": 3.0, "memories": 4.0}, "idle": {"switching": 2.0}},
             "blocks": {"rt_isqrt": {"kge": 1.0, "busy": {"switching": 3.0}}}}
    for limits, within in (({"rt_core": (7, 2), "rt_isqrt": (3, 0)}, [True, True]),
                           ({"rt_core": (6, 2), "rt_isqrt": (2, 0)}, [False, False]),
                           ({"rt_core": (7, 1), "rt_none": (9, 9)}, [False, False])):
        seen = [ok for _, ok in budget.compared(limits, found)]
        if seen != within:
            wrong(f"{limits}: {seen}, not {within}")
    path = Path(folder, "budget.txt")
    for line in ("rt_isqrt 3", "rt_isqrt 3 many", "rt_isqrt 3 -1"):
        path.write_text(f"# none\n{line}\n", "utf-8")
        try:
            budget.read(path)
        except SystemExit as error:
            if str(error).startswith(f"silicon-budget: {path}:2: "):
                continue
            wrong(f"{line}: says {error}")
        wrong(f"{line}: was read")
    if not budget.read("synth/energy_budget.txt"):
        wrong("the budget is empty")


if __name__ == "__main__":
    {"read": read, "fit": energies, "budget": budgets, "macros": tables, "icarus": icarus,
     "report": said}[sys.argv[1]](*sys.argv[2:])
