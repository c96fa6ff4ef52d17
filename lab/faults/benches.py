# benches.py - what is built around RTL with a fault: benches of modules, and their commands
# SPDX-License-Identifier: Apache-2.0
import glob
import os
import re
import shutil
import subprocess

CELLS = "tb/board/[A-Z]*.v"     # models of a vendor's cells


class Broken(Exception):
    """What cannot be built or run, or fails without a fault."""


def shell(command, log):
    with open(log, "a", encoding="utf-8") as f:
        f.write(" ".join(command) + "\n")
        f.flush()
        if subprocess.run(command, check=False, stdout=f, stderr=f).returncode:
            raise Broken(f"{command[0]} failed: {log}")


def words_of(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout.split()


def folders(*first):
    """Options of a simulator: folders of the RTL and of a vendor's cells, some before them."""
    found = [*first, *sorted({os.path.dirname(n) for n in glob.glob("rtl/*/*.v")}), "tb/board"]
    return [word for name in found for word in ("-y", name, "-I" + name)]


class Built:
    """What all benches have in common: Verilator, one file for the compiler, the linker."""

    def __init__(self, name, top, parameters, build):
        self.name, self.top, self.parameters, self.build = name, top, parameters, build
        self.outer = top    # what the bench sees

    def compile(self, folder, verilate, harness, macros, objects, libraries, effort="-O1",
                begin=""):
        """A program of Verilator's words and a harness, in folder/made; its log is folder/log."""
        made, log = f"{folder}/made", f"{folder}/log"
        shutil.rmtree(made, ignore_errors=True)
        os.makedirs(made)
        shell(["verilator", "--cc", "--top-module", self.outer, "--prefix", "V" + self.outer,
               "-O3", "--x-initial", "unique", "-Mdir", made, *verilate], log)
        with open(f"{made}/all.cpp", "w", encoding="utf-8") as f:
            f.write(begin)
            f.flush()
            subprocess.run(["sh", "sim/at_once.sh", made, harness], check=True, stdout=f)
        with open(f"{self.build}/sim/obj/compile{effort}", encoding="utf-8") as f:
            compiler = f.readline().split()
        shell(compiler + [*macros, "-w", "-isystem", made, "-MD", "-MF",
                          f"{made}/all.d", "-c", f"{made}/all.cpp", "-o", f"{made}/all.o"], log)
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
        self.macros = [f"-D{word}" for word in words if word != "/"]

    def source(self):
        return glob.glob(f"tb/*/{self.bench}.cpp")[0]

    def effort(self):
        """How hard the compiler works on it, as its head says."""
        with open(self.source(), encoding="utf-8") as f:
            said = re.search(r"^ \* Compiled with (-O.),", f.read().split("*/")[0], re.M)
        return said[1] if said else "-O1"

    def around(self, folder, verilate, macros=(), effort="-O1", begin=""):
        """The bench around what Verilator is told to read."""
        return self.compile(folder, verilate, self.source(),
                            [*macros, f'-DPROFILE="{self.configuration}"', *self.macros],
                            [*sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o")),
                             f"{self.build}/test/libhard.a"],
                            words_of("pkg-config", "--libs", "gmp", "mpfr", "expat"), effort, begin)

    def of_sources(self, folder, edited=()):
        """The bench of the sources, as tb/run_bench.sh makes it; folders of edited ones first."""
        top = next(n for d in (*edited, "rtl/*") for n in glob.glob(f"{d}/{self.top}.v"))
        return self.around(folder, ["--language", "1364-2005", "-Wall", "--x-assign", "unique",
                                    *folders(*edited), *(f"-G{n}={v}" for n, v in self.parameters),
                                    top], effort=self.effort())


def every(build, kind=Line):
    """The lines of tb/benches*.txt, as run_bench.sh has them."""
    found = subprocess.run(["awk", "-v", "pattern=/", "-v", "all=1", "-f", "tb/benches.awk",
                            "cmodel/machine/machine.def", *sorted(glob.glob("tb/benches*.txt"))],
                           check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()
    return [kind(line, build) for line in found]
