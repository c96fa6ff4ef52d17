# benches.py - what is built around a netlist with faults, and run for each of them
# SPDX-License-Identifier: Apache-2.0
"""A bench has a name, a folder, a netlist, make(), which builds a program around the netlist's
Verilog, and runs, the cheapest first: words of the command, and what it prints if all is well."""
import glob
import os
import shutil
import subprocess

from . import netlist

NUMBER = '''#include <cstdlib>
extern "C" int mutant_number() {
    const char *number = std::getenv("MUTANT");
    return number ? std::atoi(number) : 0;
}
'''
QUICK = 3000        # vectors of the first run of a block's bench
CELLS = "tb/board/[A-Z]*.v"     # models of a vendor's cells
STEPS = ("ENGINES=1", "ROOT_STEP=2", "QUOTIENT_STEP=2")


class Broken(Exception):
    """What cannot be built, or fails without a fault."""


def shell(command, log):
    with open(log, "a", encoding="utf-8") as f:
        f.write(" ".join(command) + "\n")
        f.flush()
        if subprocess.run(command, check=False, stdout=f, stderr=f).returncode:
            raise Broken(f"{command[0]} failed: {log}")


def words_of(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout.split()


class Built:
    """What all benches have in common: Verilator, one file for the compiler, the linker."""

    def __init__(self, name, top, parameters, build):
        self.name, self.top, self.parameters, self.build = name, top, parameters, build
        self.outer = top    # what the bench sees
        self.folder = f"{build}/mutants/{name.replace('/', '-')}"

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters)

    def compile(self, verilog, harness, macros, objects, libraries, more=()):
        made, log = f"{self.folder}/made", f"{self.folder}/log"
        shutil.rmtree(made, ignore_errors=True)
        os.makedirs(made)
        shell(["verilator", "--cc", "--top-module", self.outer, "--prefix", "V" + self.outer,
               "-Wno-fatal", "-Wno-lint", "-Wno-style", "-O3", "--x-assign", "fast",
               "--x-initial", "unique", "-Mdir", made, verilog, *more], log)
        with open(f"{made}/all.cpp", "w", encoding="utf-8") as f:
            f.write(NUMBER)
            f.flush()
            subprocess.run(["sh", "sim/at_once.sh", made, harness], check=True, stdout=f)
        with open(f"{self.build}/sim/obj/compile-O1", encoding="utf-8") as f:
            compiler = f.read().split()
        shell(compiler + [*macros, "-w", "-isystem", made, "-c", f"{made}/all.cpp", "-o",
                          f"{made}/all.o"], log)
        shell(["g++", f"{made}/all.o", *objects, f"{self.build}/libsphaera.a",
               "-Wl,--as-needed", *libraries, "-lm", "-lpthread", "-o", f"{made}/bench"], log)
        return f"{made}/bench"


class Line(Built):
    """A line of tb/benches*.txt: `configuration module bench parameters / the bench's own`."""

    def __init__(self, line, build):
        self.configuration, top, self.bench, *words = line.split()
        cut = words.index("/") if "/" in words else len(words)
        super().__init__(f"{self.bench}/{self.configuration}", top,
                         [word.split("=") for word in words[:cut]], build)
        self.cells = sorted(glob.glob(CELLS)) if top in OF_A_VENDOR else []
        self.macros = [f"-D{word}" for word in words if word != "/"]
        self.runs = [["1", str(QUICK)], ["1"]]

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters, (), self.cells)

    def source(self):
        return glob.glob(f"tb/*/{self.bench}.cpp")[0]

    def sources(self):
        return [self.source(), "tb/bench.h", *self.cells]

    def make(self, verilog):
        return self.compile(verilog, self.source(),
                            ["-DNETLIST", f'-DPROFILE="{self.configuration}"', *self.macros],
                            [*sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o")),
                             f"{self.build}/test/libhard.a"],
                            words_of("pkg-config", "--libs", "gmp", "mpfr", "expat"),
                            self.cells)

    @staticmethod
    def passed(text):
        return any(line.startswith("ok") for line in text.splitlines())


class Core(Built):
    """The core in widths of draft, small frames compared with the golden model."""

    LARGE = ("--reg", "3=16383", "--reg", "4=16383", "--reg", "24=0")   # frame, pitch
    SCENES = (  # scene, options of `sphaera build`, options of the harness
        ("tests/mutants/hard.nff", (), ()),
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
        return self.compile(verilog, "tb/core/simulate_verilator.cpp",
                            ["-DVM_TRACE=0", "-DVM_TRACE_FST=0", "-DNETLIST"],
                            objects + [f"{self.build}/sim/obj/{n}.o"
                                       for n in ("verilated", "verilated_threads")],
                            ["-ljansson"])

    @staticmethod
    def passed(text):
        del text
        return True  # its exit code says all


class Shell(Built):
    """rt_top around the golden model, under its driver: make/rt_top.mk's tb_shell."""

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
        return self.compile(verilog, "tb/top/tb_shell.cpp", ["-DDATA=64"],
                            [driver, *sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o"))], [],
                            ["+1800-2017ext+sv", *(f"-I{n}" for n in sorted(glob.glob("rtl/*"))),
                             f"{self.folder}/rt_core.sv"])

    @staticmethod
    def passed(text):
        del text
        return True


CORES = ("all+texture+refract+specular+sum+spread",)


OF_A_VENDOR = ("rt_serialise", "rt_clocks")    # have cells that Yosys knows nothing of


def every(build):
    """The lines of tb/benches*.txt, as run_bench.sh has them."""
    found = subprocess.run(["awk", "-v", "pattern=/", "-v", "all=1", "-f", "tb/benches.awk",
                            "cmodel/machine/machine.def", *sorted(glob.glob("tb/benches*.txt"))],
                           check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()
    return [Line(line, build) for line in found]


def wholes(build):
    from .boards import RamBoard, SdramBoard    # which are made of what stands here
    return [*(Core(effects, build) for effects in CORES), Shell(build), SdramBoard(build),
            RamBoard(build)]


def named(name, build):
    from .proofs import Proof, listed
    proofs = [Proof(module, *proof, build) for module, proof in listed().items()]
    return next(b for b in every(build) + wholes(build) + proofs if b.name == name)
