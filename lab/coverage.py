# coverage.py - lines, branches and bits of every module that benches and frames meet
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab coverage [--least] [--so-far] BUILD [PROGRAM...]
Verilator sees whether a line is reached, a branch taken, and each bit of ports, wires and registers
changes. Programs are frames of the core, rt_top and boards around the golden model, and benches of
tb/benches.txt (VECTORS vectors, of small modules all): the first line of each, then more, MOST at
most, of those whose module is not met whole. What any program meets in any instance counts. What
each has met is kept in BUILD/coverage, so that a run that was ended goes on. tb/coverage.txt names
what nothing can meet, with the reason.
Without PROGRAMs the table goes into docs/results/verification.md, with --so-far that of the
programs that have run; with --least PROGRAMs fail if they leave anything of their own module."""
import fnmatch
import glob
import os
import re
import shutil
import subprocess
import sys
import time
from collections import defaultdict

from . import benches, intact
from .faults import designed
from .faults.drawn import boards, page, plan
from .faults.drawn import benches as drawn
from .jobs import store
from .pages import place

MOST = 3            # lines of a bench
SMALL = 60          # lines of a module whose bench runs as long as it does
VECTORS = "5000"    # of others
WAIVED = "tb/coverage.txt"
KINDS = ("line", "branch", "toggle")
NAMES = {"line": "lines", "branch": "branches", "toggle": "bits"}
# Counts lie in the model, so they are written before it goes; a harness may make several. The
# context of the last one may be gone when the program ends, unless the model is still there.
BEGIN = '''#pragma push_macro("N")    // a parameter of a bench, and a macro of Verilator's
#include <verilated_cov.cpp>
#pragma pop_macro("N")
#include <cstdlib>
#include <string>
static VerilatedCovContext *counting;
static void covered(VerilatedCovContext *counts) {
    static int n;
    const std::string name = std::string(std::getenv("COVERAGE")) + "." + std::to_string(n++);
    counts->write(name.c_str());
    counts->clear();
    if (counts == counting) counting = nullptr;
}
static void count(VerilatedCovContext *counts) {
    counting = counts;
    static int end = std::atexit([] {
        if (counting) covered(counting);
    });
    (void)end;
}
'''


class Covered:
    """Of a program with counters in it; its folder is that of what it has met."""
    under = "coverage"
    effort_of = "-O0"

    def compile(self, folder, verilate, harness, macros, objects, libraries, effort="",
                begin=""):
        return super().compile(folder, [*verilate, "-Wno-fatal", "--coverage-line",
                                        "--coverage-toggle"],
                               harness, macros, objects, libraries, self.effort_of, BEGIN + begin)

    def verilated(self, made):
        for name in glob.glob(f"{made}/V*"):    # whether is asked, not how often: a plain store
            text = benches.text_of(name)
            plain = text.replace(".fetch_add(1, std::memory_order_relaxed);", " = 1;").replace(
                "std::atomic<uint32_t>", "uint32_t")
            if plain != text:
                intact.write(name, plain)
        name = f"{made}/V{self.outer}.cpp"
        text = re.sub(r"(::final\(\) \{|::~V\w+\(\) \{)",
                      r"\1 covered(contextp()->coveragep());", benches.text_of(name))
        text, found = re.subn(r"addModel\(this\);", r"\g<0> count(contextp()->coveragep());", text)
        if not found:
            raise benches.Broken(f"{name}: Verilator registers no model in it")
        intact.write(name, text)

    def program(self):
        return self.make({})    # without a fault


class Line(Covered, benches.Line):
    def __init__(self, line, build):
        super().__init__(line, build)
        self.folder = f"{build}/coverage/{self.name.replace('/', '-')}"
        self.runs = [["1"] if plan.modules()[self.top] <= SMALL else ["1", VECTORS]]

    def program(self):
        return self.of_sources(self.folder)


class Core(Covered, designed.Core):
    """It counts modules without a bench, and of those what is no arithmetic or memory: it has so
    many instances of them, all in benches too, that it would be built for half an hour."""
    OTHERS = ("math", "memory", "prim", "trace")    # folders
    effort_of = "-O1"

    def verilate(self, edited):
        found = [*(f"*/{name}/*" for name in self.OTHERS),
                 *(f"*/{top}.v" for top in sorted({line.top for line in benches.every("")}))]
        name = f"{self.folder}/others.vlt"
        intact.write(name, "`verilator_config\n" + "".join(
            f'coverage_off -file "{pattern}"\n' for pattern in found))
        return [name, *super().verilate(edited)]


class Top(Covered, designed.Top):
    effort_of = "-O1"

    def __init__(self, build, layers=0, trees=0):
        super().__init__(build, layers)
        self.parameters.append(["BUILD", str(trees)])
        self.name += "-trees" * (trees > 0)
        self.folder += "-trees" * (trees > 0)


class RamBoard(Covered, designed.Board):
    pass


class SdramBoard(Covered, designed.Whole, boards.SdramBoard):
    effort_of = "-O1"

    def pins(self):
        return self.PINS


def sizes():
    """{module: lines of it and of those below}"""
    above, total = plan.parents(), defaultdict(int)
    for module, lines in plan.modules().items():
        found, left = set(), {module}
        while left:
            found |= left
            left = set().union(*(above[name] for name in left)) - found
        for name in found:
            total[name] += lines
    return total


def programs(build):
    """Every program: core and rt_top, a line of each bench, the smallest module first, boards,
    second lines, third ones."""
    tops = {}
    for line in benches.every(build, Line):
        tops.setdefault(line.top, []).append(line)
    tops = {top: tops[top] for top in sorted(tops, key=sizes().get)}
    yield Core(drawn.CORES[0], build)
    yield Top(build, layers=1)
    yield from (lines[0] for lines in tops.values())
    yield SdramBoard(build)
    yield RamBoard(build)
    yield Top(build, trees=64)
    for number in range(1, MOST):
        yield from (lines[number] for lines in tops.values() if number < len(lines))


# ---- what was met ----
def read(name):
    """{(module, kind, line, what): times} of Verilator's file."""
    found = defaultdict(int)
    with open(name, encoding="latin-1") as f:
        for line in f:
            if not line.startswith("C '"):
                continue
            key, count = line[3:].rsplit("' ", 1)
            word = dict(w.split("\2", 1) for w in key.split("\1") if "\2" in w)
            module = os.path.basename(word["f"])[:-2]
            kind = word["page"].split("/")[0].removeprefix("v_")
            if "rtl/" in word["f"] and kind in KINDS and not word["o"].startswith("unused"):
                what = word["o"] if kind == "toggle" else f"{word.get('n', '')} {word['o']}"
                found[module, kind, word["l"], what.strip()] += int(count)
    return found


def digest(program, files):
    return f"{store.digest(files)} {program.name} {program.runs}"


def kept(program):
    """What a program has met, if it ran since its sources changed."""
    name = f"{program.folder}.points"
    if os.path.exists(name):
        text, files, *rows = benches.text_of(name).splitlines()
        if text == digest(program, files.split()):
            return [line.split("\t") for line in rows]
    return None


def made_of(program):
    """Files of the project that Verilator and the compiler read."""
    made = f"{program.folder}/made"
    files = benches.sources(f"{made}/all.d", f"{made}/V{program.outer}__ver.d")
    return sorted({n for n in files if not n.startswith(("/", program.build)) and
                   os.path.isfile(n)})


def met(program):
    """What a program meets, kept as long as its sources stay."""
    shutil.rmtree(program.folder, ignore_errors=True)
    os.makedirs(program.folder)
    begin = time.monotonic()
    bench = program.program()
    print(f"{program.name}: built in {time.monotonic() - begin:.0f} s", flush=True)
    files, found = made_of(program), defaultdict(int)
    for number, run in enumerate(program.runs):
        begin, points = time.monotonic(), f"{program.folder}/points{number}"
        ran = subprocess.run([bench, *run], check=False, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, encoding="utf-8", errors="replace",
                             env={**os.environ, "COVERAGE": points, "SPHAERA":
                                  f"{program.build}/sphaera"})
        if ran.returncode:
            raise benches.Broken(f"{program.name} {' '.join(run)} ends with {ran.returncode}\n"
                                 + ran.stdout[-2000:])
        for name in glob.glob(points + ".*"):
            for point, times in read(name).items():
                found[point] += times
            os.remove(name)
        print(f"{program.name}: run {number} in {time.monotonic() - begin:.0f} s", flush=True)
    shutil.rmtree(program.folder)
    rows = [[*point, str(int(times > 0))] for point, times in sorted(found.items())]
    intact.write(f"{program.folder}.points", "\n".join(
        [digest(program, files), " ".join(files), *("\t".join(row) for row in rows)]) + "\n")
    return rows


# ---- what nothing can meet ----
def waivers():
    """[(line of the file, module, kind, pattern)]; the reason is for who reads it."""
    found = []
    with open(WAIVED, encoding="utf-8") as f:
        for number, line in enumerate(f, 1):
            if line.startswith("#") or not line.strip():
                continue
            words = line.split(None, 3)
            if len(words) < 4 or words[1] not in NAMES.values():
                sys.exit(f"{WAIVED}:{number}: no module, kind ({', '.join(NAMES.values())}), name "
                         "and reason")
            kind = next(k for k, v in NAMES.items() if v == words[1])
            found.append((number, words[0], kind, words[2]))
    return found


def named(patterns, what, line):
    """Whether a waiver's patterns, a bit's name or a line's number, name a point."""
    name, _, bit = what.rstrip("]").partition("[")
    for pattern in patterns.split(","):
        if pattern == f"line{line}" or fnmatch.fnmatchcase(what, pattern.replace("[", "[[]")):
            return True
        span = re.fullmatch(r"([\w?*]+)\[(\d+):(\d+)(?:/(\d+))?\]", pattern)
        if span and bit and fnmatch.fnmatchcase(name, span[1]) and \
                int(span[3]) <= int(bit) % int(span[4] or sys.maxsize) <= int(span[2]):
            return True
    return False


class Points:
    """Of all programs: {module: {(kind, line, what): whether it was met}}."""
    def __init__(self):
        self.of, self.lists, self.used = defaultdict(dict), defaultdict(list), set()
        for number, module, *waiver in waivers():
            self.lists[module].append((number, *waiver))

    def add(self, rows):
        for module, *point, times in rows:
            mine = self.of[module]
            mine[tuple(point)] = mine.get(tuple(point)) or times == "1"

    def judged(self, module):
        """[(kind, line, what, whether it was met)] but for what is waived."""
        for (kind, line, what), was_met in self.of[module].items():
            waiver = not was_met and next((number for number, k, pattern
                                           in self.lists[module] + self.lists["*"]
                                           if k == kind and named(pattern, what, line)), None)
            if waiver:
                self.used.add(waiver)
            else:
                yield kind, line, what, was_met

    def whole(self, module):
        return all(was_met for *_, was_met in self.judged(module))


def gather(chosen, so_far, every):
    """(points of all programs, lines of benches of each top, programs that are not met, and why,
    programs that have nothing left to meet). every: those too."""
    points, tops, broken, idle = Points(), defaultdict(int), {}, set()
    for program in chosen:
        if not every and tops[program.top] and points.whole(program.top):
            idle.add(program.name)
            continue
        rows = kept(program)
        try:
            if rows is None and so_far:
                raise benches.Broken("has not run")
            points.add(rows if rows is not None else met(program))
            tops[program.top] += 1
        except benches.Broken as why:
            broken[program.name] = why
            if not so_far:
                print(f"not ok {program.name}: {why}", flush=True)
    return points, tops, broken, idle


def table(points, modules, tops):
    """(rows of modules, {kind: [met, all]}, what is not met)"""
    points.used.clear()
    rows, total, holes = [], {kind: [0, 0] for kind in KINDS}, []
    for module in modules:
        mine = {kind: [0, 0] for kind in KINDS}
        for kind, line, what, was_met in points.judged(module):
            if not was_met:
                holes.append((module, kind, line, what))
            for count in (mine[kind], total[kind]):
                count[0] += was_met
                count[1] += 1
        rows.append([module, str(tops.get(module, 0)), *cells(mine)])
    return rows, total, sorted(holes)


def cells(counts):
    return [word for kind in KINDS for word in (
        f"{counts[kind][0]} of {counts[kind][1]}", share(counts[kind]))]


def main(build, *names, least=False, so_far=False):
    chosen = [p for p in programs(build) if not names or p.name in names or p.top in names]
    if names and not chosen:
        sys.exit(f"coverage: there is no program {' '.join(names)}")
    points, tops, broken, idle = gather(chosen, so_far, bool(names))
    modules = sorted(tops if names else points.of)
    rows, total, holes = table(points, modules, tops)
    for row in rows:
        print(*row)
    for module, kind, line, what in holes:
        print(f"    never: {module}.v:{line} {NAMES[kind]} {what}")
    if names:
        bad = broken or (least and holes)
        print("not ok" if bad else "ok", "coverage of", *names)
        return int(bool(bad))
    for number, module, kind, pattern in waivers():
        if number not in points.used and not broken:
            print(f"{WAIVED}:{number}: nothing is left of {module} {NAMES[kind]} {pattern}")
    all_of = len(chosen) - len(idle)
    ran = f"{all_of - len(broken)} of {all_of} programs"
    rows.append(["**all**", ran, *cells(total)])
    print(*rows[-1])
    if not broken or so_far:
        command = f"python3 -m lab coverage --so-far {build}" if broken else "make coverage"
        place.place(page.PAGE, command, {"coverage": [
            ["module", "lines of its bench", "lines", "%", "branches", "%", "bits", "%"], *rows]})
    return int(bool(broken) and not so_far)


def share(count):
    return f"{100 * count[0] / count[1]:.1f}" if count[1] else "-"
