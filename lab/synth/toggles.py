# toggles.py - what switches in the netlist of a core, while it draws a frame and behind it
# SPDX-License-Identifier: Apache-2.0
"""Draws a scene on the cells that Yosys maps a core to for ecp5 (tb/netlist) and counts, a clock,
while the core is busy and in 1000 clocks behind the frame: nets that change, those inside of
multipliers as if these were rows of adders; flip-flops whose enable is high; ports of block RAM
that are enabled. No delays, so no glitches; no wires, so no joules: a figure says how two states of
the sources compare. --record puts the row into the table toggles of docs/results/data, in the place
of one of the same core, frame and commit."""
import os
import re
import subprocess
import sys
from pathlib import Path

from .. import intact, tasks
from ..pages import data, measured
from . import results, report

TABLE = "toggles"
KINDS = "toggles", "clocked", "RAM ports"
HEAD = ["frame", "commit", "core", "cycles", "LUT4eq", "FF"] + [
    f"{when}: {kind}" for when in ("busy", "idle") for kind in KINDS] + [
        "tools", "date"]
BLOCKS = 12  # rows of modules that are printed


def instances(rtl):
    """{module: {instance, or generate block.instance: module}} of the sources."""
    found = {}
    for path in Path(rtl).rglob("*.v"):
        module = kind = block = ""
        for line in path.read_text(encoding="utf-8").splitlines():
            for pattern, what in ((r"module (\w+)", "module"), (r".*begin : (g_\w+)", "block"),
                                  (r"\s*(rt_\w+)\s+(?:#\(|u_\w+)", "kind")):
                match = re.match(pattern, line)
                if match and what == "module":
                    module = match[1]
                elif match and what == "block":
                    block = match[1]
                elif match:
                    kind = match[1]
            for name in re.findall(r"\b(u_\w+)\s*\(", line):
                found.setdefault(module, {}).update({name: kind, f"{block}.{name}": kind})
    return found


def module_of(path, tree, module="rt_core"):
    """The module of an instance, named from the core down."""
    block = ""
    for name in path.split("."):
        if name.startswith("g_"):
            block = name.split("[")[0]
        elif name:
            below = tree.get(module, {})
            module, block = below.get(f"{block}.{name}") or below.get(name) or name, ""
    return module


def read(path):
    """(clocks busy and idle, {instance: [toggles, clocked, RAM ports] of both})"""
    first, *lines = Path(path).read_text(encoding="utf-8").splitlines()
    rows = {name: [int(n) for n in numbers] for name, *numbers in
            (line.split("\t") for line in lines)}
    return [int(n) for n in first.split()], rows


def a_clock(numbers, clocks):
    return [number / clocks[i // len(KINDS)] for i, number in enumerate(numbers)]


def summed(rows):
    return [sum(column) for column in zip(*rows)]


def modules(rows, tree):
    """{module: its numbers}"""
    found = {}
    for path, numbers in rows.items():
        found.setdefault(module_of(path, tree), []).append(numbers)
    return {name: summed(several) for name, several in found.items()}


def table(rows, clocks, tree):
    """Modules, those first that have the largest part of what toggles busy or idle."""
    whole = summed(rows.values())
    found = modules(rows, tree)
    ordered = sorted(found, key=lambda m: -found[m][0] / (whole[0] or 1)
                     - found[m][3] / (whole[3] or 1))
    lines = [[name] + [f"{n:.1f}" for n in a_clock(numbers, clocks)] for name, numbers in
             [("all", whole)] + [(name, found[name]) for name in ordered[:BLOCKS]]]
    return report.table(["module"] + HEAD[6:12], lines)


def cells(stat):
    """LUT4eq, FF of what Yosys counted last."""
    counts = {}
    for line in Path(stat).read_text(encoding="utf-8").splitlines():
        word = line.split()
        if "Number of cells" in line:
            counts = {}
        elif len(word) == 2 and word[1].isdecimal():
            counts[word[0]] = int(word[1])
    columns = {name: weights for name, weights, _ in results.COLUMNS["ecp5"]}
    return [sum(weight * counts.get(kind, 0) for kind, weight in columns[name].items())
            for name in ("lut4eq", "ff")]


def core_sh(options, env):
    done = subprocess.run(["sh", "sim/core.sh", *options], env=env, check=False, text=True,
                          stdout=subprocess.PIPE)
    if done.returncode:
        sys.exit(done.stdout + f"toggles: the frame was not drawn, exit code {done.returncode}")
    return done.stdout


def main(tool, build, scene, profile, effects, size, accel, record=False):
    """A frame of a scene on a core, profile auto: standard; accel as of sphaera build."""
    folder = Path(build) / "toggles"
    folder.mkdir(parents=True, exist_ok=True)
    source = subprocess.run(["sim/scene.py", scene], check=True, text=True,
                            stdout=subprocess.PIPE).stdout.strip()
    profile = "standard" if profile == "auto" else profile
    machine, counts = folder / "frame.sph", folder / "counts.tsv"
    subprocess.run([tool, "build", source, "--profile", profile, "--size", size, "--accel",
                    accel, "-o", machine], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    env = dict(tasks.clean(), BUILD=build, SIM="ecp5", EFFECTS=effects, OPT="-O0")
    netlist = Path(core_sh(["--folder", "--machine", str(machine)], env).strip())
    said = core_sh(["--machine", str(machine), "--toggles", str(counts)], env)
    clocks, rows = read(counts)
    print(said + table(rows, clocks, instances(os.environ.get("RTL") or "rtl")))
    if not record:
        return
    yosys = subprocess.run(["yosys", "-V"], check=True, text=True, stdout=subprocess.PIPE).stdout
    cycles = re.search(r"(\d+) cycles", said)[1]
    commit, day = measured.commit()
    row = [f"{Path(source).stem} {size} {accel}", commit,
           netlist.name.removesuffix("-O0").replace("-", "-ecp5-", 1), cycles,
           *map(str, cells(netlist / "ecp5.stat"))]
    row += [f"{n:.1f}" for n in a_clock(summed(rows.values()), clocks)]
    row += [" ".join(yosys.split()[:2]), day]
    path = data.FOLDER / f"{TABLE}.tsv"
    kept = data.read(TABLE)[1] if path.exists() else []
    kept = [old for old in kept if old[:3] != row[:3]]
    intact.write(path, data.of_rows([HEAD] + kept + [row]))
