# run.py - one scene on the core of its list and on the whole core, in turn
# SPDX-License-Identifier: Apache-2.0
"""Reads NAME.sph, NAME.forced.sph and NAME.build.json of FOLDER, writes NAME.json. Speed is
processor time of the simulation alone, the best of ROUNDS, both cores in turn; every run must be
without a mismatch."""
import json
import os
import re
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from .. import intact
from ..tasks import Task, make_all

ROUNDS, EFFORT = 3, "-O1"  # as make sim has it
SOURCES = ["lab/effects/run.py", "sim/core.sh", "make/core.mk", "sim/cores.py"] + sorted(
    str(path) for root in ("rtl", "tb/core") for path in Path(root).rglob("*")
    if path.suffix in (".v", ".vh", ".cpp", ".h"))


def core(effects, machine):
    """Builds the core; the folder of its harness."""
    ran = subprocess.run(["sh", "sim/core.sh", "--machine", machine, "--folder"], check=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                         env=dict(os.environ, EFFECTS=effects, OPT=EFFORT, JOBS="1"))
    return ran.stdout.decode().strip()


def simulate(folder, machine):
    """Counters of the core, and the processor seconds that its simulation took."""
    with tempfile.TemporaryDirectory() as own:
        out = Path(own, "report.json")
        ran = subprocess.run([f"{folder}/tb_core", "--machine", machine, "--latency", "20",
                              "--json", out], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             check=False)
        if ran.returncode:
            sys.exit(f"effects: {machine} on {folder}:\n{ran.stdout.decode()}")
        report = json.loads(out.read_text(encoding="utf-8"))
    return report["cold"]["counters"], report["cpu_seconds"]


def code_bytes(folder):
    """Code and constants of the verilated model, and of the few lines that feed its pins."""
    lines = subprocess.run(["size", f"{folder}/core.o"], check=True,
                           stdout=subprocess.PIPE).stdout.decode().splitlines()
    return sum(int(re.split(r"\s+", line.strip())[0]) for line in lines[1:])


def model(tool, machine, folder, name):
    """Counters of the golden model."""
    made = subprocess.run([tool, "render", machine, "--threads", "1", "--json", "-", "-o",
                           f"{folder}/{name}.png"], check=True, stdout=subprocess.PIPE)
    return json.loads(made.stdout)["counters"]


def main(tool, folder, name):
    base = f"{folder}/{name}"
    result = json.loads(Path(base + ".build.json").read_text(encoding="utf-8"))
    machine = base + ".sph"
    cores = {"own": core(result["list"], machine), "all": core(result["whole"], machine)}
    runs = {}
    for _ in range(ROUNDS):
        for which, where in cores.items():
            counters, cpu = simulate(where, base + ".sph")
            best = min(cpu, runs[which]["cpu"]) if which in runs else cpu
            runs[which] = {"counters": counters, "cpu": best, "bytes": code_bytes(where)}
    runs["forced"] = {"counters": simulate(cores["all"], base + ".forced.sph")[0]}
    result.update(runs=runs, model=model(tool, base + ".sph", folder, name),
                  model_forced=model(tool, base + ".forced.sph", folder, name))
    intact.write(base + ".json", json.dumps(result, indent=1))


def every(tool, folder):
    """Those of all scenes that are older than their machine or the RTL."""
    make_all([Task(f"{folder}/{name}.json",
                   [f"{folder}/{name}.sph", f"{folder}/{name}.forced.sph", *SOURCES],
                   partial(main, tool, folder, name), f"SIM {name}")
              for name in Path(folder, "scenes").read_text(encoding="utf-8").split()])
