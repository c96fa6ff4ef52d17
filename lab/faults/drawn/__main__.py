# __main__.py - the mutation campaign as jobs: lists of them, one of them, what came of all
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab mutants plan BUILD COUNT SEED ROUND LIST
       python3 -m lab mutants one BUILD KEY
       python3 -m lab mutants tell BUILD COUNT SEED
Round 0 tries each fault in the home of its module; a later round tries what is left in one more
bench. A job whose result counts is not run again: break it off whenever you like. `tell` writes
the tables of docs/results/verification.md."""
import fcntl
import os
import shutil
import sys
import time

from ...benches import Broken
from ...jobs import plan as jobs
from ...jobs import store
from . import benches, binary, page, plan
from .netlist import Fault

GUESS = 60.0  # seconds of a job


def results(build):
    return f"{build}/mutants/results"


def sources(bench, found):
    return [f"rtl/*/{m}.v" for m in sorted(found.variants)] + ["rtl/*/*.vh", "tool:yosys"] \
        + bench.sources()


def keys(build, count, seed, number):
    if number == 0:
        return [f"mutants round=0 bench={bench} seed={seed} faults="
                + ",".join(f"{m}:{n}" for m, n in has.items())
                for bench, has in plan.counts(count, build).items()]
    groups = plan.next_benches(build, number, state(build, count, seed, number))
    return [f"mutants round={number} bench={bench} seed={seed} count={count} of={plan.name(faults)}"
            for bench, faults in groups.items()]


def state(build, count, seed, rounds):
    """{fault: [(bench, verdict, seconds) of each round]} of what was run in the first rounds."""
    tried = {}
    for number in range(rounds):
        for key in keys(build, count, seed, number):
            result, _ = store.look(results(build), key)
            for row in (result or {"rows": []})["rows"]:
                fault = Fault(*row[:-2])
                tried.setdefault(fault, []).append((result["bench"], row[-2], row[-1]))
    return tried


def write(build, count, seed, number, name):
    command = ["python3", "-m", "lab", "mutants", "one", build]
    jobs.write(name, results(build),
               [jobs.job(results(build), k, [*command, k], GUESS)
                for k in keys(build, count, seed, number)], f"mutants, round {number}")


def one(build, key):
    word = dict(w.split("=", 1) for w in key.split()[1:])
    bench = benches.named(word["bench"], build)
    os.makedirs(os.path.dirname(bench.folder), exist_ok=True)
    with open(bench.folder + ".lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)    # another may be at work with that bench
        if store.look(results(build), key)[1]:
            attempt(build, key, word, bench)


def attempt(build, key, word, bench):
    number, seed = int(word["round"]), int(word["seed"])
    began = time.monotonic()
    found = bench.netlist()
    if number == 0:
        counts = dict(w.split(":") for w in word["faults"].split(","))
        faults = found.choose({m: int(n) for m, n in counts.items()}, seed)
    else:
        count = int(word["count"])
        groups = plan.next_benches(build, number, state(build, count, seed, number))
        faults = groups[bench.name]
        if plan.name(faults) != word["of"]:
            sys.exit(f"mutants: {key}: other faults are left now; make the list anew")
    try:
        came = binary.run(bench, faults, found)
    except Broken as e:
        sys.exit(f"mutants: {e}")
    rows = [[*fault, verdict, took] for fault, (verdict, took) in came.items()]
    store.save(results(build), key, sources(bench, found),
               {"bench": bench.name, "rows": rows}, time.monotonic() - began)
    shutil.rmtree(bench.folder, ignore_errors=True)


def main(command, build, *rest):
    if command == "plan":
        write(build, int(rest[0]), int(rest[1]), int(rest[2]), rest[3])
    elif command == "one":
        one(build, rest[0])
    else:
        count, seed = int(rest[0]), int(rest[1])
        page.write(state(build, count, seed, plan.ROUNDS), count, seed)
