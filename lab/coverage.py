# coverage.py - lines and bits of small modules that their benches run and toggle
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab coverage BUILD [MODULE...]
Verilator counts how often a branch of a module is taken and each bit of its ports and registers
changes. A module's bench runs with 3000 vectors in its first MOST lines of tb/benches.txt; what
any of them meets counts. Without MODULEs those of at most LINES lines of code. The table goes into
docs/results/verification.md."""
import glob
import os
import re
import shutil
import subprocess
import sys
from collections import defaultdict

from . import benches
from .faults.drawn import page, plan
from .pages import place

LINES = 115     # of code, of a small module
MOST = 3        # lines of its bench
VECTORS = "3000"
WRITE = '::final() { VerilatedCov::write(std::getenv("COVERAGE"));'


def program(bench, folder, compiler):
    """The bench of a line, which writes $COVERAGE at its end."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    log = f"{folder}/log"
    sources = glob.glob(f"rtl/*/{bench.top}.v")
    benches.shell(["verilator", "--cc", "--top-module", bench.top, "--coverage-line",
                   "--coverage-toggle", "--x-assign", "unique", "--x-initial", "unique",
                   *benches.folders(),
                   *[f"-G{n}={v}" for n, v in bench.parameters], "-Mdir", folder, *sources], log)
    model = f"{folder}/V{bench.top}.cpp"
    with open(model, encoding="utf-8") as f:
        text = f.read()
    text, found = re.subn(r"::final\(\) \{", lambda m: WRITE, text)
    if not found:
        sys.exit(f"coverage: {model} has no final()")
    with open(model, "w", encoding="utf-8") as f:
        f.write("#include <cstdlib>\n#include <verilated_cov.h>\n" + text)
    with open(f"{folder}/all.cpp", "w", encoding="utf-8") as f:
        subprocess.run(["sh", "sim/at_once.sh", folder, bench.source()], check=True, stdout=f)
        f.write("#include <verilated_cov.cpp>\n")
    benches.shell([*compiler, "-O0", f'-DPROFILE="{bench.configuration}"', *bench.macros, "-w",
                   "-DVM_COVERAGE=1", "-isystem", folder, "-c", f"{folder}/all.cpp", "-o",
                   f"{folder}/all.o"], log)
    benches.shell(["g++", f"{folder}/all.o",
                   *sorted(glob.glob(f"{bench.build}/sim/obj/bench_*.o")),
                   f"{bench.build}/test/libhard.a", f"{bench.build}/libsphaera.a",
                   "-Wl,--as-needed",
                   *benches.words_of("pkg-config", "--libs", "gmp", "mpfr", "expat", "zlib"), "-lm",
                   "-lpthread", "-o", f"{folder}/bench"], log)
    return f"{folder}/bench"


def points(name, module):
    """{(kind, place): times} of a module's own points in Verilator's file."""
    found = defaultdict(int)
    with open(name, encoding="latin-1") as f:
        for line in f:
            if not line.startswith("C '"):
                continue
            key, count = line[3:].rsplit("' ", 1)
            word = dict(w.split("\2", 1) for w in key.split("\1") if "\2" in w)
            if os.path.basename(word["f"]) == module + ".v" and word["o"] != "unused":
                kind = "toggle" if "toggle" in word["page"] else "line"
                found[kind, word["l"], word.get("n", ""), word["o"]] += int(count)
    return found


def main(build, *names):
    with open(f"{build}/sim/obj/compile-O1", encoding="utf-8") as f:
        compiler = [w for w in f.read().split() if w != "-O1"]
    cut = compiler.index("-include-pch") if "-include-pch" in compiler else None
    if cut is not None:
        del compiler[cut:cut + 2]
    lists, lines = benches.every(build), plan.modules()
    rows = []
    for module in sorted({bench.top for bench in lists}):
        mine = [bench for bench in lists if bench.top == module][:MOST]
        with open(mine[0].source(), encoding="utf-8") as f:
            whole = re.search(r"bench::Bench<.* b\(", f.read())     # calls final()
        if not (module in names if names else whole and lines[module] <= LINES):
            continue
        met = defaultdict(int)
        for bench in mine:
            folder = f"{build}/coverage/{bench.name.replace('/', '-')}"
            ran = program(bench, folder, compiler)
            subprocess.run([ran, "1", VECTORS], check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "COVERAGE": f"{folder}/points"})
            for point, times in points(f"{folder}/points", module).items():
                met[point] += times
            shutil.rmtree(folder)
        row = [module, str(len(mine))]
        for kind in ("line", "toggle"):
            times = [n for point, n in met.items() if point[0] == kind]
            hit = sum(n > 0 for n in times)
            row += [f"{hit} of {len(times)}", f"{100 * hit / max(1, len(times)):.1f}"]
        rows.append(row)
        print(*row, flush=True)
        for kind, line, name, what in sorted(p for p, n in met.items() if not n)[:12]:
            print(f"    never: {module}.v:{line} {kind} {name} {what}", flush=True)
    if not names:
        place.place(page.PAGE, "make coverage", {"coverage": [
            ["module", "lines of its bench", "branches taken", "%", "bits toggled", "%"],
            *rows]})
