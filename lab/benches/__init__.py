# __init__.py - benches of modules, built around their RTL or around what stands for it
# SPDX-License-Identifier: Apache-2.0
import glob
import os
import shutil
import subprocess
from collections import Counter

from . import lists

CELLS = "tb/board/[A-Z]*.v"     # models of a vendor's cells


class Broken(Exception):
    """What cannot be built or run, or fails without a fault."""


def shell(command, log):
    with open(log, "a", encoding="utf-8") as f:
        f.write(" ".join(command) + "\n")
        f.flush()
        if subprocess.run(command, check=False, stdout=f, stderr=f).returncode:
            raise Broken(f"{command[0]} failed: {log}")


def text_of(name):
    with open(name, encoding="utf-8") as f:
        return f.read()


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
        self.verilated(made)
        with open(f"{made}/all.cpp", "w", encoding="utf-8") as f:
            f.write(begin)
            f.flush()
            subprocess.run(["sh", "sim/at_once.sh", made, harness], check=True, stdout=f)
        compiler = text_of(f"{self.build}/sim/obj/compile{effort}").split()
        shell(compiler + [*macros, "-w", "-isystem", made, "-MD", "-MF",
                          f"{made}/all.d", "-c", f"{made}/all.cpp", "-o", f"{made}/all.o"], log)
        return self.link(folder, objects, libraries)

    def verilated(self, made):
        """What is done to the C++ that Verilator wrote."""

    def link(self, folder, objects, libraries):
        program = f"{folder}/made/bench"
        linker = text_of(f"{self.build}/sim/obj/link").split()
        shell([*linker, f"{folder}/made/all.o", *objects, f"{self.build}/libsphaera.a",
               "-Wl,--as-needed", *libraries, "-lm", "-lpthread", "-o", program], f"{folder}/log")
        return program


class Line(Built):
    """A line of tb/benches.txt: `configuration module bench parameters / the bench's own`."""

    def __init__(self, line, build):
        self.words = line.split()
        self.configuration, top, self.bench, *words = self.words
        cut = words.index("/") if "/" in words else len(words)
        super().__init__(f"{self.bench}/{self.configuration}", top,
                         [word.split("=") for word in words[:cut]], build)
        self.macros = [f"-D{word}" for word in words if word != "/"]

    def source(self):
        return glob.glob(f"tb/*/{self.bench}.cpp")[0]

    def effort(self):
        """How hard the compiler works on it."""
        return os.environ.get("BENCH_OPT") or lists.efforts().get(self.bench, "-O1")

    def others(self):
        """Objects and libraries that it is linked with."""
        return ([*sorted(glob.glob(f"{self.build}/sim/obj/bench_*.o")),
                 f"{self.build}/test/libhard.a"],
                words_of("pkg-config", "--libs", "gmp", "mpfr", "expat", "zlib"))

    def around(self, folder, verilate, macros=(), effort="-O1", begin=""):
        """The bench around what Verilator is told to read."""
        return self.compile(folder, verilate, self.source(),
                            [*macros, f'-DPROFILE="{self.configuration}"', *self.macros],
                            *self.others(), effort, begin)

    def of_sources(self, folder, edited=()):
        """The bench of the sources; folders of edited ones first."""
        top = next(n for d in (*edited, "rtl/*") for n in glob.glob(f"{d}/{self.top}.v"))
        rules = glob.glob(f"tb/*/{self.top}_rules.sv")
        return self.around(folder, ["--language", "1364-2005", "-Wall", "--x-assign", "unique",
                                    *folders(*edited), *(f"-G{n}={v}" for n, v in self.parameters),
                                    *(["+1800-2017ext+sv", "-Iformal", *rules] if rules else []),
                                    top], effort=self.effort())

    def kept(self):
        """The bench of the sources, made anew as far as it is old."""
        folder = f"{self.build}/tb/{self.name.replace('/', '-')}"
        made, line = f"{folder}/made", f"{folder}/line"
        os.makedirs(folder, exist_ok=True)
        wanted = " ".join([*self.words, self.effort(), text_of(f"{self.build}/sim/obj/versions")])
        if not os.path.exists(line) or text_of(line) != wanted or older(
                f"{made}/all.o", *sources(f"{made}/all.d", f"{made}/V{self.top}__ver.d")):
            shutil.rmtree(folder)
            os.makedirs(folder)
            with open(line, "w", encoding="utf-8") as f:
                f.write(wanted)
            return self.of_sources(folder)
        objects, libraries = self.others()
        program = f"{made}/bench"
        if older(program, *objects, f"{made}/all.o", f"{self.build}/libsphaera.a"):
            self.link(folder, objects, libraries)
        return program


# ---- what is old ----
def sources(*rules):
    """Files that compilers' rules for make name; nothing of a rule that is not there."""
    for rule in rules:
        yield rule
        if os.path.exists(rule):
            yield from text_of(rule).partition(":")[2].replace("\\\n", " ").split()


def older(result, *files):
    """Than one of the files, or one of all is not there."""
    def time_of(name):
        return os.stat(name).st_mtime_ns
    try:
        return time_of(result) < max(map(time_of, files))
    except FileNotFoundError:
        return True


def every(build, kind=Line, whole=True):
    lines = [kind(line, build) for line in lists.listed(whole)]
    for name, times in Counter(line.name for line in lines).items():
        if times > 1:   # both would share a folder
            raise Broken(f"{name} stands twice in tb/benches.txt")
    return lines
