# benches.py - what is built around a netlist with faults, and run for each of them
# SPDX-License-Identifier: Apache-2.0
"""A bench has a name, a folder, a netlist, make(), which builds a program around the netlist's
Verilog, and runs, the cheapest first: words of the command, and what it prints if all is well."""
import glob
import os

from ... import benches
from ...benches import CELLS, Built, Line, shell, words_of
from . import netlist

NUMBER = '''#include <cstdlib>
extern "C" int mutant_number() {
    const char *number = std::getenv("MUTANT");
    return number ? std::atoi(number) : 0;
}
'''
QUICK = 3000        # vectors of the first run of a block's bench
# what Verilator is told of a netlist
LOOSE = ("-Wno-fatal", "-Wno-lint", "-Wno-style", "--x-assign", "fast")
STEPS = ("ENGINES=1", "ROOT_STEP=1", "QUOTIENT_STEP=2")


class Drawn(Built):
    """A bench around a netlist with faults: its folder, its netlist, its runs."""

    def __init__(self, name, top, parameters, build):
        super().__init__(name, top, parameters, build)
        self.folder = f"{build}/mutants/{name.replace('/', '-')}"

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters)

    def compiled(self, verilog, harness, macros, objects, libraries, more=()):
        return self.compile(self.folder, [*LOOSE, verilog, *more], harness, macros, objects,
                            libraries, begin=NUMBER)


class DrawnLine(Line, Drawn):
    """A line of tb/benches.txt around a netlist of its module."""

    def __init__(self, line, build):
        super().__init__(line, build)
        self.cells = sorted(glob.glob(CELLS)) if self.top in OF_A_VENDOR else []
        self.runs = [["1", str(QUICK)], ["1"]]

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters, (), self.cells)

    def sources(self):
        return [self.source(), "tb/bench.h", *self.cells]

    def make(self, verilog):
        return self.around(self.folder, [*LOOSE, verilog, *self.cells], ["-DNETLIST"],
                           begin=NUMBER)

    @staticmethod
    def passed(text):
        return any(line.startswith("ok") for line in text.splitlines())


class Core(Drawn):
    """The core in widths of draft, small frames compared with the golden model."""

    LARGE = ("--reg", "3=16383", "--reg", "4=16383", "--reg", "24=0")   # frame, pitch
    SCENES = (  # scene, options of `sphaera build`, options of the harness
        ("tests/faults/hard.nff", (), ()),
        ("scenes/sphereflake2.nff", ("--background", "exact"), ()),
        ("scenes/interpenetrating.nff", ("--tree", "paper"), ("--reg", "0=31")),
        ("scenes/inside.nff", ("--depth", "5"), ()),
        ("scenes/eight_lights.nff", ("--background", "rect"), ()),
        ("tests/scenes/facets/mixed.nff", ("--accel", "bvh4"), ()),
        ("tests/scenes/texture/balls.nff", ("--accel", "bvh4"), ()),
        ("tests/scenes/refraction/mixed.nff", ("--accel", "bvh4"), ()),
        ("scenes/paper100.nff", ("--background", "spans"), ("--warm",)),
        ("scenes/inside.nff", (), ("--reg", "0=3", "--life", "--cuts", "20")),
        ("tests/scenes/texture/balls.nff", ("--accel", "bvh4"),
         ("--life", "--window", "0,0,4,3", "--trials", "50")),
        # large coordinates; all pixels have one direction
        ("scenes/inside.nff", ("--depth", "1"),
         (*LARGE, "--window", "10922,10922,10926,10925", "--reg", "14=11184810")),
        ("scenes/paper5.nff", ("--depth", "1", "--background", "rect"),
         (*LARGE, "--window", "5461,5460,5466,5463", "--reg", "14=5592405", "--reg", "10=5464",
          "--reg", "11=5461", "--reg", "12=16383", "--reg", "13=16383")),
        ("scenes/paper5.nff", ("--depth", "1", "--background", "rect"),
         (*LARGE, "--window", "8190,8190,8195,8194", "--reg", "14=0", "--reg", "10=8192",
          "--reg", "11=8191", "--reg", "12=8194", "--reg", "13=8193")),
        ("scenes/paper5.nff", ("--depth", "1", "--background", "rect"),     # ends of rectangles
         (*LARGE, "--window", "10921,10921,10926,10925", "--reg", "14=0", "--reg", "10=0",
          "--reg", "11=0", "--reg", "12=10924", "--reg", "13=10923")),
        ("scenes/paper5.nff", ("--depth", "1", "--background", "rect"),
         (*LARGE, "--window", "5460,5460,5465,5464", "--reg", "14=0", "--reg", "10=0",
          "--reg", "11=0", "--reg", "12=5462", "--reg", "13=5461")),
        ("tests/scenes/facets/mixed.nff", ("--accel", "bvh4", "--size", "72x40", "--depth", "1"),
         ()),
    )

    def __init__(self, effects, build):
        widths = words_of("sim/cores.py", "profile", "draft")
        effects_on = words_of("sim/cores.py", "parameters", effects)
        super().__init__(f"core/{effects}", "rt_core",
                         [word.split("=") for word in [*widths, *effects_on, *STEPS]], build)
        common = ["--core", effects, "--built", " ".join(effects_on), "--repeat", "-", "--stop",
                  "--watchdog", "50000", "--latency", "5", "--stall", "20", "--seed", "7"]
        self.runs = [["--machine", f"{self.folder}/{number}.sph", *common, *options]
                     for number, (_, _, options) in enumerate(self.SCENES)]

    def sources(self):
        return ["tb/core/*.cpp", "tb/core/*.h", *{scene for scene, _, _ in self.SCENES}]

    def make(self, verilog):
        for number, (scene, options, _) in enumerate(self.SCENES):
            shell([f"{self.build}/sphaera", "build", scene, "--profile", "draft", "--size",
                   "20x12", "--axes", "camera", *options, "-o", f"{self.folder}/{number}.sph"],
                  f"{self.folder}/log")
        objects = [f"{self.build}/sim/obj/{os.path.basename(n)[:-4]}.o"
                   for n in sorted(glob.glob("tb/core/*.cpp"))
                   if os.path.basename(n) == "tb_core.cpp"
                   or not os.path.basename(n).startswith(("simulate_", "tb_"))]  # make/core.mk
        return self.compiled(verilog, "tb/core/simulate_verilator.cpp",
                            ["-DVM_TRACE=0", "-DVM_TRACE_FST=0", "-DNETLIST"],
                            objects + [f"{self.build}/sim/obj/{n}.o"
                                       for n in ("simulate_stages", "verilated",
                                                 "verilated_threads")],
                            ["-ljansson"])

    @staticmethod
    def passed(text):
        del text
        return True  # its exit code says all


class Shell(Drawn):
    """rt_top around the golden model, under its driver: make/rt_top.mk's tb_shell."""
    seen = ()   # Verilator's words for those who look inside; in a netlist the names are gone

    def __init__(self, build):
        effects = next(word[5:] for word in words_of("make", "-s", "top-shell")
                       if word.startswith("CORE="))    # behind what make may have built
        super().__init__("top/shell", "rt_top", [word.split("=") for word in words_of(
            "sim/cores.py", "profile", "draft") + words_of("sim/cores.py", "parameters", effects)
            + ["DATA=64", "VIDEO=1"]], build)
        self.runs = [[f"{build}/top/paper5.sph", f"{build}/top/interpenetrating.sph", "1"]]

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters, ("rt_core",))

    def sources(self):
        return ["tb/top/*", "driver/*"]

    def make(self, verilog):
        with open("tb/top/golden_core.svh", encoding="utf-8") as f:
            golden = netlist.head("rt_core") + f.read()
        with open(f"{self.folder}/rt_core.sv", "w", encoding="utf-8") as f:
            f.write(golden)
        driver = f"{self.folder}/driver.o"
        shell(["gcc", "-O2", "-c", "driver/sphaera.c", "-o", driver], f"{self.folder}/log")
        values = {"LAYERS": 0, "BUILD": 0, "MEM_DATA": 64, **dict(self.parameters)}
        macros = ["-DDATA=64", *(f"-DTOP_{name}={value}" for name, value in values.items())]
        return self.compiled(verilog, "tb/top/tb_shell.cpp", macros,
                            [driver, *sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o"))], [],
                            ["+1800-2017ext+sv", *self.seen,
                             *(f"-I{n}" for n in sorted(glob.glob("rtl/*"))),
                             f"{self.folder}/rt_core.sv"])

    @staticmethod
    def passed(text):
        del text
        return True


CORES = ("all+texture+refract+specular+sum+spread",)


OF_A_VENDOR = ("rt_serialise", "rt_clocks")    # have cells that Yosys knows nothing of


def every(build):
    return benches.every(build, DrawnLine)


def wholes(build):
    from .boards import RamBoard, SdramBoard    # which are made of what stands here
    return [*(Core(effects, build) for effects in CORES), Shell(build), SdramBoard(build),
            RamBoard(build)]


def named(name, build):
    from .proofs import Proof, listed
    proofs = [Proof(module, *proof, build) for module, proof in listed().items()]
    return next(b for b in every(build) + wholes(build) + proofs if b.name == name)
