# state.py - how far each block of the RTL is, by what the tree holds of it: the table of state.md
# SPDX-License-Identifier: Apache-2.0
"""Stages as the checklists of open chip projects have them (OpenTitan: D0 to D3, V0 to V3), cut to
what a repository can show. Each needs those before it."""
import json
import re
from pathlib import Path

from . import blocks, cores, data, markdown, verilog

SHELL = ("rt_top", "rt_core")           # are tried by harnesses of their own
HEAD = ["block", "what it does", "design", "verification", "benches", "proofs",
        "faults drawn, left", "branches, %", "least MHz alone"]
KILLED = 95.0                           # of the faults drawn, %


def proofs():
    """{module: how many}: the module that a proof is of, or the first file that it reads."""
    found = {}
    text = Path("formal/proofs.txt").read_text(encoding="utf-8").replace("\\\n", " ")
    for line in text.splitlines():
        files = [word.strip() for word in line.split("|")]
        if len(files) < 6 or line[0] in "#=":
            continue
        named = re.match(r"\w+/(rt_\w+)", files[3])
        if named:
            found[named[1]] = found.get(named[1], 0) + 1
    return found


def measured(name, column, key="module"):
    """{module: cell} of a table of verification.md."""
    head, rows = data.read(f"verification.{name}")
    at = column(head) if callable(column) else head.index(column)
    return {row[head.index(key)].strip("`"): row[at] for row in rows}


def behind(word):
    """The column behind the one whose head begins with the word: of its per cent."""
    return lambda head: next(i for i, name in enumerate(head) if name.startswith(word)) + 1


def alone():
    """{module: MHz} of synth/clock_budget.txt."""
    rows = [line.split("#")[0].split() for line in
            Path("synth/clock_budget.txt").read_text(encoding="utf-8").splitlines()]
    return {words[0]: words[1] for words in rows if len(words) > 1}


def design(module, synthesised, budget):
    """D1: its ports are told, and tools are silent; D2: it is whole, and its cells are measured in
    a core; D3: its clock is held by a budget."""
    return "D3" if module in budget else "D2" if module in synthesised else "D1"


def verification(module, has, proved, faults, left):
    """V1: a bench or a harness compares it with the model; V2: of the faults drawn in it nearly all
    are noticed; V3: every one, or it is shown that nothing can notice it, and something of it is
    proved for all inputs."""
    if module not in has and module not in SHELL and module not in faults:
        return "V0"
    if float(faults.get(module, 0)) < KILLED:
        return "V1"
    return "V3" if left.get(module) == "0" and module in proved else "V2"


def purpose(path):
    """What the first line of a module's header says."""
    line = path.read_text(encoding="utf-8").split("\n", 1)[0]
    return line.partition(" - ")[2]


def cells():
    """The rows of the table, a list of cells each."""
    has, proved, budget = blocks.benches(), proofs(), alone()
    killed, left = measured("modules", "killed, %"), measured("modules", "left")
    drawn, branches = measured("modules", "faults"), measured("coverage", behind("branches"))
    record = json.loads(cores.RECORD.read_text(encoding="utf-8"))
    synthesised = {m for core in record.values() for m in core["modules"]} | {"rt_top"}
    rows = []
    for module, path in verilog.files().items():
        if "board" in path.parts:
            continue
        of = f"{drawn[module]}, {left[module]}" if module in drawn else "-"
        rows.append([f"`{module}`", purpose(path), design(module, synthesised, budget),
                     verification(module, has, proved, killed, left),
                     len(has[module]) if module in has else "harness" if module in SHELL else "-",
                     proved.get(module, "-"), of, branches.get(module, "-"),
                     budget.get(module, "-")])
    return rows


def table():
    return markdown.table(HEAD, cells())


def counts():
    """In words: how many blocks are at which stage."""
    rows, said = cells(), []
    for column in (HEAD.index("design"), HEAD.index("verification")):
        stages = [row[column] for row in rows]
        said += [f"{stages.count(s)} {s}" for s in sorted(set(stages))]
    return f"{len(rows)} blocks: {', '.join(said)}"
