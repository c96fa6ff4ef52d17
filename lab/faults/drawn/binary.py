# binary.py - faults of one netlist, tried one after another with the program around it
# SPDX-License-Identifier: Apache-2.0
import os
import subprocess

from ...benches import Broken

PATIENCE, SLACK = 4.0, 1.0  # a fault may take PATIENCE times the sound netlist's, and SLACK seconds


def attempt(bench, program, number, words, limit):
    """survived, killed or timeout, and processor's seconds."""
    environment = dict(os.environ, MUTANT=str(number), BENCH_FIRST="1")
    began = os.times()
    verdict = "timeout"
    try:
        # The machine may be shared: the limit is of the processor's time, a wide one of time.
        ran = subprocess.run(["prlimit", f"--cpu={int(limit) + 1}", program, *words], check=False,
                             text=True, timeout=20 * limit, stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, errors="replace", env=environment)
        if ran.returncode not in (-9, -24):
            sound = ran.returncode == 0 and bench.passed(ran.stdout)
            verdict = "survived" if sound else "killed"
    except subprocess.TimeoutExpired:
        pass
    now = os.times()
    return verdict, now.children_user + now.children_system - (
        began.children_user + began.children_system)


class Unsound(Broken):
    """A netlist that fails while no fault in it is selected."""


def run(bench, faults, found):
    """{fault: (verdict, seconds)} of those that fit into the netlist `found`. Where the tools do
    not get a netlist with so many faults right, each half has one of its own."""
    try:
        return together(bench, faults, found)
    except Unsound:
        half = len(faults) // 2
        if not half:
            raise
        return {**run(bench, faults[:half], found), **run(bench, faults[half:], found)}


def together(bench, faults, found):
    verilog = f"{bench.folder}/faults.v"
    fitting = found.write(faults, verilog)
    if not fitting:
        return {}
    program = bench.make(verilog)
    left, results = dict(enumerate(fitting, 1)), {}
    for words in bench.runs:
        verdict, sound = attempt(bench, program, 0, words, 600)
        if verdict != "survived":
            raise Unsound(f"{bench.name}: the netlist without a fault is {verdict}: {words}")
        for number, fault in list(left.items()):
            verdict, took = attempt(bench, program, number, words, PATIENCE * sound + SLACK)
            results[fault] = verdict, round(results.get(fault, ("", 0))[1] + took, 2)
            if verdict != "survived":
                del left[number]
    return results


