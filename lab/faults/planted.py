# planted.py - plants a fault of tests/faults into a private copy, builds it, and asks who notices
# SPDX-License-Identifier: Apache-2.0
"""A judge is asked with a fault's edits, and without any: the sound sources have to pass. What it
says is one of

    noticed   a comparison, a test or a proof failed, or the RTL itself stopped
    passed    nothing failed
    broken    it could not be built, it crashed, or took longer than PATIENCE: no verdict at all
"""
import contextlib
import glob
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

from .. import benches
from ..benches import Broken
from ..benches.run import make_tools
from . import programs
from .records import planted

PATIENCE = 1800     # seconds of one judge
SEED = ("--latency", "5", "--stall", "20", "--seed", "7")
CORES = {"core": {"EFFECTS": "all"}, "textured": {"EFFECTS": "auto"},
         "piped": {"EFFECTS": "auto", "PIPES": "3", "LEAF_UNITS": "1"},
         "agree": {"EFFECTS": "auto"}}
# objects of other simulators
HARNESS = r"/tb_(?!core)|simulate_(verilator|netlist|cxxrtl|host|stages)"
# What a comparison tells of the first difference, the most telling first.
HOW = (r"^  stage +(.*)", r"^(counter [^ ]*)", r"^(error bit [a-z_]*)", r"(no progress for .*)",
       r"^vvp ended .* time: .*u_core\.(.*)", r"^(not ok.*)", r"^ *PROVE [^:]*: (.*)",
       r"^\[  FAILED  \] (.*)", r"^(.*% wrong|.*Verilog \$finish)")
CRASH = re.compile("core dumped|Segmentation fault|Aborted|Killed")  # as make tells of it


def how(text):
    for pattern in HOW:
        if found := re.search(pattern, text, re.M):
            return found[1]
    return ""


def copied(name, to):
    """A folder once more, of links to the same files: whoever writes one makes it anew."""
    def link(source, target):
        try:
            os.link(source, target)
        except OSError:
            shutil.copy2(source, target)
    shutil.copytree(name, to, copy_function=link, symlinks=True)


class Shop:
    """Where faults are planted: a build folder with all that they have in common, a folder of its
    own for what is private, and programs that run."""

    def __init__(self, build):
        self.build = build
        self.sphaera = os.environ.get("SPHAERA", f"{build}/sphaera")
        if "TESTING" in os.environ:     # a suite: the same name each time, by which ccache knows it
            self.folder = os.path.relpath(os.environ["TMP"] + "/faults")
            os.makedirs(self.folder)
        else:
            self.folder = tempfile.mkdtemp(prefix="faults-", dir=build)
        self.lines = benches.every(build)
        self.running, self.closed, self.lock = set(), False, threading.Lock()

    def close(self):
        """Ends what still runs; nothing begins any more."""
        with self.lock:
            self.closed = True
            for pid in self.running:
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(pid, signal.SIGKILL)

    def remove(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def run(self, command, say, **environment):
        """Exit code, negative for a signal; what it prints goes to `say` and is returned."""
        seen = {k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")}
        with self.lock:
            if self.closed:
                raise Broken("is ended")
            ran = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, errors="replace",
                                   env={**seen, **environment}, process_group=0)
            self.running.add(ran.pid)
        with ran:
            try:
                text, _ = ran.communicate(timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                os.killpg(ran.pid, signal.SIGKILL)
                text = ran.communicate()[0]
                say(text)
                raise Broken(f"takes longer than {PATIENCE} seconds: {command[0]}") from None
            finally:
                with self.lock:
                    self.running.discard(ran.pid)
        say(text)
        return ran.returncode, text

    def must(self, command, say, **environment):
        rc, text = self.run(command, say, **environment)
        if rc:
            raise Broken(f"{os.path.basename(command[0])} failed")
        return text

    def make(self, *words):
        """Makes what the judges have in common; a build folder has one such make at a time."""
        self.must(["flock", f"{self.build}/.faults.lock", "make", "-s", "--no-print-directory",
                   f"B={self.build}", *words], lambda text: text and print(text, end=""))

    def prepare(self, judges):
        """Builds once what these judges need."""
        kinds = {judge.kind for judge in judges}
        goals = {f"{self.build}/libsphaera.a", f"{self.build}/sphaera"}
        os.makedirs(f"{self.build}/sim", exist_ok=True)
        if kinds & {"hard", "agree"}:
            goals.add(f"{self.build}/test/hard")
        if kinds & {"bench", "case", "top"}:
            goals.add(f"{self.build}/test/libhard.a")
        if "agree" in kinds:
            goals.add(f"{self.build}/test/naive-frame")
        goals |= {f"{self.build}/test/{j.words[0]}.o" for j in judges if j.kind == "test"}
        self.make(*sorted(goals))

        def say(text):
            print(text, end="")
        if kinds & {"bench", "case", "top"}:
            efforts = {line.effort() for judge in judges if judge.kind in ("bench", "case")
                       for line in self.matching(judge)} or {"-O1"}
            make_tools(self.build, efforts)
        if kinds & {"core", "textured", "piped", "agree"}:
            self.must(["sh", "sim/core.sh", "--help"], lambda text: None, BUILD=self.build)
        if "top" in kinds:
            goals = subprocess.run(
                ["make", "-s", "--no-print-directory", f"B={self.build}", "top-shell"], check=True,
                text=True, stdout=subprocess.PIPE,
                env={k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")})
            words = re.match(r"CORE=(\S+) MACHINES='(.*)'", goals.stdout)
            self.top = words[1], words[2].replace("build/", f"{self.build}/")

    def matching(self, judge):
        return [line for line in self.lines if judge.words[0] in line.name]


class Planting:
    """A fault in a private copy, or the sound sources; what is built of it, each thing once."""

    def __init__(self, shop, record, name):
        self.shop, self.record = shop, record
        self.folder = f"{shop.folder}/{name}"
        os.makedirs(self.folder)
        self.made = {}
        self.log = []

    def say(self, text):
        self.log.append(text)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def once(self, name, make):
        if name not in self.made:
            self.made[name] = make()
        return self.made[name]

    def texts(self, judge):
        """{path: text} that the judge sees in place of what stands there."""
        return planted(self.record.side(judge)) if self.record else {}

    def tree(self, judge, *names):
        """A folder with copies of some folders, the fault in them."""
        texts = {path: text for path, text in self.texts(judge).items()
                 if path.split("/")[0] in names}

        def make():
            tree = f"{self.folder}/tree{len(self.made)}"
            for name in names:
                copied(name, f"{tree}/{name}")
            for path, text in texts.items():
                os.remove(f"{tree}/{path}")
                with open(f"{tree}/{path}", "w", encoding="utf-8") as f:
                    f.write(text)
            return tree
        return self.once((names, *sorted(texts)), make)

    def ask(self, judge):
        """(what it says, what tells of it)"""
        try:
            return getattr(self, "by_" + judge.kind, self.by_core)(judge)
        except Broken as why:
            what, _, rest = str(why).partition("\n")
            for name in re.findall(r"failed: (\S+/log)$", what):
                with open(name, encoding="utf-8", errors="replace") as f:
                    rest = f.read()
            self.say(rest)
            return "broken", re.sub(r"failed: \S+/log$", "does not build it", what)

    # ---- the core and rt_top ----
    def simulation(self):
        """A build folder in which what is the same for all counts as built."""
        def make():
            here, build = f"{self.folder}/build", self.shop.build
            os.makedirs(here)
            copied(f"{build}/sim/obj", f"{here}/sim/obj")
            for name in ("sim/tb_core_icarus", "libsphaera.a"):
                if os.path.exists(f"{build}/{name}"):
                    os.link(f"{build}/{name}", f"{here}/{name}")
            return here
        return self.once("simulation", make)

    def machine(self, judge, *size):
        """The machine file of a judge's scene, and the words behind its `--`."""
        words = list(judge.words)
        cut = words.index("--") if "--" in words else len(words)
        machine = f"{self.folder}/scene.sph"
        self.shop.must([self.shop.sphaera, "build", words[0], "--profile", "draft", *size,
                        *words[1:cut], "-o", machine], lambda text: None)
        return machine, words[cut + 1:]

    def by_core(self, judge):
        machine, words = self.machine(judge, "--size", "25x19")
        rc, text = self.shop.run(
            ["sh", "sim/core.sh", "--machine", machine, "--stop", "--watchdog", "5000", *SEED,
             *words], self.say, BUILD=self.simulation(), RTL=f"{self.tree(judge, 'rtl')}/rtl",
            SIM="icarus", BUILT="tools", **CORES[judge.kind])
        return told_core(rc, text)

    def by_top(self, judge):
        data, layers, trees = (*judge.words, *("64", "0", "0")[len(judge.words):])
        core, machines = self.shop.top
        make = ["make", "-s", "--no-print-directory", "-f", "make/rt_top.mk",
                f"B={self.simulation()}", f"RTL={self.tree(judge, 'rtl')}/rtl", f"DATA={data}",
                f"LAYERS={layers}", f"TREES={trees}", f"CORE={core}", f"MACHINES={machines}",
                "BENCH=tb_shell", "SEED=1"]
        self.shop.must([*make, "top"], self.say)
        rc, text = self.shop.run([*make, "run"], self.say)
        if rc and re.search("^not ok", text, re.M) and not CRASH.search(text):
            return "noticed", how(text)
        return ("broken", f"ends with {rc}") if rc else ("passed", "")

    # ---- benches of modules ----
    def by_bench(self, judge, case=None):
        tree = self.edited(judge)
        for line in self.shop.matching(judge):
            folder = f"{self.folder}/{line.name.replace('/', '-')}"
            os.makedirs(f"{folder}/tb", exist_ok=True)  # tb_load writes a machine there
            program = self.once(line.name, lambda at=folder, one=line: one.of_sources(at, tree))
            rc, text = self.shop.run([program, "1"], self.say, BENCH_BUILD=folder,
                                     SPHAERA=self.shop.sphaera,
                                     **({"HARD_CASE": case} if case else {}))
            said = told_bench(rc, text)
            if said[0] == "noticed" and case and f"\n#   named case {case}, " not in text:
                return "passed", ""
            if said[0] != "passed":
                return said
        return "passed", ""

    def by_case(self, judge):
        return self.by_bench(judge, judge.words[2])

    def edited(self, judge):
        """Folders that a simulator looks into first: of edited files alone."""
        def make():
            found = []
            for path, text in self.texts(judge).items():
                name = f"{self.folder}/edited/{path}"
                found.append(os.path.dirname(name))
                os.makedirs(found[-1], exist_ok=True)
                with open(name, "w", encoding="utf-8") as f:
                    f.write(text)
            return found
        return self.once("edited", make)

    # ---- the model ----
    def objects(self, judge):
        return self.once(("objects", judge.kind == "agree"), lambda: [
            programs.compiled(self.folder, path, text) for path, text in self.texts(judge).items()
            if path.endswith(".c")])

    def program(self, judge, suite):
        return self.once(suite, lambda: programs.link(self.shop.build, self.folder, suite,
                                                   self.objects(judge)))

    def by_hard(self, judge):
        rc, text = self.shop.run([self.program(judge, "hard_named"), f"--named={judge.words[0]}"],
                                 self.say)
        if rc == 1 and re.search("^not ok", text, re.M):
            return "noticed", how(text)
        return ("broken", f"ends with {rc}") if rc else ("passed", "")

    def by_test(self, judge):
        rc, text = self.shop.run([self.program(judge, judge.words[0])], self.say,
                                 CMOCKA_MESSAGE_OUTPUT="TAP", BUILD=self.shop.build)
        if 0 < rc < 126 and re.search("^not ok", text, re.M):
            return "noticed", how(text)
        return ("broken", f"ends with {rc}") if rc else ("passed", "")

    def by_naive(self, judge):
        """The naive model's picture of the scene of `agree`, beside that of a faulty model."""
        machine, words = self.machine(self.record.agree() if self.record else judge, "--size",
                                      "12x9")
        pokes = [word for word in words if word.startswith("--poke=")]
        naive = self.once("naive", lambda: self.linked(
            "naive", [f"{self.shop.build}/test/obj/tests/reference/naive_frame.o",
                      *self.objects(judge)]))
        rc, text = self.shop.run([naive, *pokes, machine], self.say)
        return {0: ("passed", ""), 1: ("noticed", "a pixel of the naive model")}.get(
            rc, ("broken", f"ends with {rc}" + text[:0]))

    def linked(self, name, objects, *words):
        program = f"{self.folder}/{name}"
        self.shop.must(["g++", *objects, f"{self.shop.build}/libsphaera.a", *words,
                        *programs.libraries(), "-lm", "-lpthread", "-o", program], self.say)
        return program

    # ---- model and RTL alike ----
    def by_agree(self, judge):
        """Both have the fault and agree; what shares no code with them notices it."""
        machine, words = self.machine(judge, "--size", "12x9")
        core = re.search(r"^core *(.*)", self.shop.must(
            [self.shop.sphaera, "info", machine], lambda text: None), re.M)[1]
        folder = self.shop.must(
            ["sh", "sim/core.sh", "--machine", machine, "--folder"], self.say,
            BUILD=self.simulation(), RTL=f"{self.tree(judge, 'rtl')}/rtl", SIM="icarus",
            BUILT="tools", **CORES["agree"]).split()[-1]
        literal = f"{self.folder}/literal.o"
        self.shop.must([*programs.COMPILER, "-O1", "-Icmodel", "-c", "tests/faults/literal.c", "-o",
                        literal], self.say)
        harness = self.linked(
            "harness", [*(f"{self.shop.build}/sim/obj/{Path(n).stem}.o"
                          for n in sorted(glob.glob("tb/core/*.cpp"))
                          if not re.search(HARNESS, n)), *self.objects(judge), literal],
            "-Wl,--wrap=sph_render")
        built = self.shop.must(["sim/cores.py", "parameters", core], lambda text: None).strip()
        rc, text = self.shop.run(
            [harness, "--machine", machine, "--engine", f"{folder}/tb_core.vvp", "--core", core,
             "--built", built, "--watchdog", "5000", *SEED, *words], self.say)
        if rc or not self.record:
            return ("passed", "") if not rc else (
                "broken", "model and RTL do not agree: " + how(text) if rc == 1
                else f"ends with {rc}")
        other = self.record.oracle()
        what, why = self.ask(other)
        return what, f"model and RTL agree, {other}: {why or what}"

    # ---- proofs ----
    def by_proof(self, judge):
        tree = self.tree(judge, "rtl", "cmodel", "formal")
        rc, text = self.shop.run(["sh", f"{tree}/formal/prove.sh", "=" + judge.words[0]], self.say,
                                 BUILD=f"{tree}/build", NICE="",
                                 CBMC=os.environ.get("CBMC") or self.cbmc())
        return {0: ("passed", ""), 1: ("noticed", how(text))}.get(rc, ("broken", how(text)))

    def cbmc(self):
        return shutil.which("cbmc") or os.path.abspath(f"{self.shop.build}/cbmc/usr/bin/cbmc")

    def by_reset(self, judge):
        tree = self.tree(judge, "rtl", "lab", "sim", "formal")
        rc, text = self.shop.run(["env", "-C", tree, "python3", "-m", "lab", "reset", "build",
                                  *judge.words], self.say)
        if rc == 1 and re.search("^not ok.* is [x1] in clock", text, re.M):
            return "noticed", how(text)
        return ("broken", f"ends with {rc}") if rc else ("passed", "")

    def by_crossings(self, judge):
        rc, text = self.shop.run(["python3", "-m", "lab", "crossings", *judge.words, "--rtl",
                                  f"{self.tree(judge, 'rtl')}/rtl"], self.say)
        if rc == 1 and re.search("^not ok", text, re.M):
            return "noticed", how(text)
        return ("broken", f"ends with {rc}") if rc else ("passed", "")


def told_core(rc, text):
    """What the harness of the core says."""
    crashed = re.search(r"^.*vvp ended with status 0x(?!0 )[0-9a-f]+.*", text, re.M)
    if rc not in (0, 1, 4) or crashed:
        return "broken", crashed[0] if crashed else f"ends with {rc}"
    if rc and re.search(r" [1-9][0-9]* mismatches|^not ok|no progress for", text, re.M):
        return "noticed", how(text)
    return ("broken", f"ends with {rc}, without a mismatch") if rc else ("passed", "")


def told_bench(rc, text):
    """What a bench says; the RTL itself may have stopped it, which is no crash."""
    if rc in (0, 1) and re.search("^not ok", text, re.M):
        return "noticed", how(text)
    if rc == 0 and re.search("^ok", text, re.M):
        return "passed", ""
    if rc == 0 and "Verilog $finish" in text:
        return "noticed", "the RTL stops: " + next(iter(text.splitlines()), "")
    return "broken", f"ends with {rc}, without a verdict"
