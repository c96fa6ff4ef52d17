# run.py - builds benches of modules as far as they are old, and runs them
# SPDX-License-Identifier: Apache-2.0
"""PATTERN selects lines of tb/benches.txt by bench/configuration, such as tb_leaf or
tb_leaf/standard; of all lines (/, the default) those that are for ALL=1 are left out without it.
--show prints them; --tools builds what all benches have in common, and no more. SEED is a number
(1), VECTORS how many (as many as the bench takes).

  BENCH_BUILD  build folder (build); all that is made here lies in its folder tb
  BENCH_JOBS   benches at once (1)
  BENCH_OPT    compiler's effort (-O1, or what tb/benches.txt says of a bench)
  HARD_CASE    number of a named case: these vectors and no others (tb/hard.h)"""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from . import Broken, every, text_of


def make_models(build):
    environment = {k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")}
    made = subprocess.run(["make", "--no-print-directory", f"B={build}",
                           f"{build}/test/libhard.a", f"{build}/libsphaera.a"], check=False,
                          env=environment, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    if made.returncode:
        raise Broken(f"the model cannot be made\n{made.stdout}")


def make_tools(build, efforts):
    """What all benches have in common."""
    os.makedirs(f"{build}/sim", exist_ok=True)
    for effort in sorted(efforts):
        subprocess.run(["flock", f"{build}/sim/.tools.lock", "env", "-u", "MAKEFLAGS", "-u",
                        "MFLAGS", "make", "-s", "--no-print-directory", "-f", "make/verilated.mk",
                        f"B={build}", f"OPT={effort}", "bench-tools"], check=True)


def run(line, words):
    """(whether it is well, what it says)"""
    name = line.name.replace("/", "-")
    try:
        program = line.kept()
    except Broken as why:
        log = f"{line.build}/tb/{name}/log"
        return False, (text_of(log) if os.path.exists(log) else "") + f"{why}\n" \
            f"not ok {name}: does not build\n"
    ran = subprocess.run([program, *words], check=False, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    text = ran.stdout.decode(errors="replace")
    # $finish in the RTL ends a bench with status 0, but without its last line
    well = ran.returncode == 0 and bool(re.search("^ok", text, re.M))
    if not well and not re.search("^not ok", text, re.M):
        text += f"not ok {name}: ended early\n"
    return well, text


def main(pattern="/", seed="1", vectors=None, tools=False, show=False):
    try:
        return run_all(pattern, [seed] + [vectors] * bool(vectors), tools, show)
    except (Broken, ValueError) as why:
        print(f"not ok benches: {why}")
        return 1


def run_all(pattern, words, tools, show):
    build = os.environ.get("BENCH_BUILD") or "build"
    whole = pattern != "/" or bool(os.environ.get("ALL"))
    lines = [line for line in every(build, whole=whole) if pattern in line.name]
    if show:
        print(*(" ".join(line.words) for line in lines), sep="\n")
        return 0
    if not lines:
        raise Broken(f"nothing matches {pattern}")
    make_models(build)
    make_tools(build, {"-O0", "-O1"} if tools else {line.effort() for line in lines})
    if tools:
        return 0
    os.environ["BENCH_BUILD"], failed = build, 0
    with ThreadPoolExecutor(int(os.environ.get("BENCH_JOBS") or 1)) as pool:
        for line, (well, text) in zip(lines, pool.map(lambda line: run(line, words), lines)):
            with open(f"{build}/tb/{line.name.replace('/', '-')}.log", "w", encoding="utf-8") as f:
                f.write(text)
            sys.stdout.write(text)
            sys.stdout.flush()
            failed += not well
    return int(failed > 0)
