# results.py - reads what synth/core.sh left in a folder
# SPDX-License-Identifier: Apache-2.0
"""A run is a dictionary of plain values; its rows are modules, all parameter sets of one together:
own is what the instances hold themselves, total includes what is instantiated inside them."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from .. import tasks

# columns of each target: name, {cell type pattern: weight}, heading
COLUMNS = {
    "ecp5": [
        ("mult", {r"MULT18X18D": 1}, "MULT18X18D"),
        ("lut4", {r"LUT4": 1}, "LUT4"),
        ("carry", {r"CCU2C": 1}, "CCU2C"),
        ("lut4eq", {r"LUT4": 1, r"CCU2C": 2}, "LUT4eq"),
        ("dpr", {r"TRELLIS_DPR16X4": 1}, "DPR16X4"),
        # nextpnr lets nothing else into the three slices of a memory
        ("places", {r"LUT4": 1, r"CCU2C": 2, r"TRELLIS_DPR16X4": 6}, "LUT places"),
        ("ff", {r"TRELLIS_FF": 1}, "FF"),
        ("bram", {r"DP16KD|PDPW16KD": 1}, "DP16KD"),
    ],
    "xc7": [
        ("mult", {r"DSP48E1": 1}, "DSP48E1"),
        ("lut", {r"LUT[1-6]|INV": 1}, "LUT"),
        ("carry", {r"CARRY4": 1}, "CARRY4"),
        ("lutram", {r"RAM(32|64)M": 4, r"RAM(32|64)X1D": 2, r"RAM128X1D": 4,
                    r"RAM(32|64)X1S": 1, r"SRL(16E|C32E)": 1}, "LUT as RAM"),
        ("ff", {r"FD[A-Z]+(_1)?": 1}, "FF"),
        ("ramb18", {r"RAMB18E1": 1}, "RAMB18"),
        ("ramb36", {r"RAMB36E1": 1}, "RAMB36"),
    ],
    "gowin": [
        ("mult", {r"MULT\d+X\d+": 1}, "MULT"),
        ("lut", {r"LUT[1-4]": 1}, "LUT"),
        ("carry", {r"ALU": 1}, "ALU"),
        ("lutram", {r"RAM16SDP4": 1}, "RAM16SDP4"),
        ("ff", {r"DFF[A-Z]*": 1}, "FF"),
        ("bram", {r"SDPX?9B?|SDPB": 1}, "SDPB"),
    ],
    "ice40": [
        ("mult", {r"SB_MAC16": 1}, "SB_MAC16"),
        ("lut", {r"SB_LUT4": 1}, "SB_LUT4"),
        ("carry", {r"SB_CARRY": 1}, "SB_CARRY"),
        ("ff", {r"SB_DFF[A-Z]*": 1}, "FF"),
        ("bram", {r"SB_RAM40_4K[A-Z]*": 1}, "SB_RAM40_4K"),
    ],
    "nexus": [
        ("mult", {r"MULT(9X9|18X18|18X36|36X36)|MULTADDSUB.*": 1}, "MULT"),
        ("lut", {r"LUT4": 1}, "LUT4"),
        ("carry", {r"CCU2": 1}, "CCU2"),
        ("lutram", {r"DPR16X4": 1}, "DPR16X4"),
        ("ff", {r"FD1P3[A-Z]+": 1}, "FF"),
        ("bram", {r"PDPS?C?16K": 1}, "PDP16K"),
    ],
    "gatemate": [
        ("mult", {r"CC_MULT": 1}, "CC_MULT"),
        ("lut", {r"CC_(LUT[1-4]|L2T[45]|MX[248])": 1}, "LUT, MX"),
        ("carry", {r"CC_ADDF": 1}, "CC_ADDF"),
        ("ff", {r"CC_DFF": 1}, "FF"),
        ("bram", {r"CC_BRAM_20K": 1, r"CC_BRAM_40K": 2}, "BRAM of 20K"),
    ],
    "efinix": [
        ("mult", {r"EFX_MULT": 1}, "EFX_MULT"),
        ("lut", {r"EFX_LUT4": 1}, "EFX_LUT4"),
        ("carry", {r"EFX_ADD": 1}, "EFX_ADD"),
        ("ff", {r"EFX_FF": 1}, "FF"),
        ("bram", {r"EFX_RAM_5K": 1}, "EFX_RAM_5K"),
    ],
    "generic": [
        ("gates", {r"\$_(AND|OR|XOR|NOT|MUX|NAND|NOR|XNOR|ANDNOT|ORNOT)_": 1}, "gates"),
        ("ff", {r"\$_[A-Z]*DFF[A-Z]*_.*": 1}, "FF"),
        ("mult", {r"\$mul": 1}, "$mul"),
    ],
}
# not from cell counts
EXTRA = {target: [("pp_bits", "product bits")] * (target == "generic") + [("bits", "RAM bits")]
         for target in COLUMNS}
SIZE = {"ecp5": "places", "generic": "gates"}  # else lut
# the largest part of a family in which a core may not fit: its name, {column: how many}
LARGEST = {"ice40": ("iCE40HX8K", {"lut": 7680, "ff": 7680, "bram": 32})}


def too_much(run):
    """Where a core does not fit, and what it exceeds there, in words; empty: it may fit."""
    name, has = LARGEST.get(run["target"], ("", {}))
    heads = {column: head for column, _, head in COLUMNS[run["target"]]}
    over = [f"{run['core'][column]} of {most} {heads[column]}"
            for column, most in has.items() if run["core"][column] > most]
    return f"{name}: {', '.join(over)}" if over else ""


def key(profile, cores, target="ecp5", engines="1", root="1", quotient="2"):
    """The name of a synthesised core, as sim/cores.py has it."""
    ran = subprocess.run(["sim/cores.py", "key", profile, cores, target], check=False,
                         stdout=subprocess.PIPE, text=True, env=dict(
                             os.environ, ENGINES=engines, ROOT_STEP=root, QUOTIENT_STEP=quotient))
    return ran.stdout.strip() if ran.returncode == 0 else sys.exit(1)


def synthesise(build, lists, **variables):
    """Cores for ecp5, as make/area.mk keeps them; variables of it: PROFILES, PIPES..."""
    done = subprocess.run(
        ["make", "--no-print-directory", f"-j{tasks.jobs()}", "-f", "make/area.mk", "results",
         f"B={build}", f"V={os.environ.get('V') or 0}", f"EFFECTS={' '.join(lists)}",
         *(f"{name}={value}" for name, value in variables.items())],
        env=tasks.clean(), check=False)
    if done.returncode:
        sys.exit(done.returncode)


def columns(target):
    """Keys and headings of a target's columns, left to right."""
    return [(key, head) for key, _, head in COLUMNS[target]] + EXTRA[target]


def _stat(path):
    """Modules of `stat -json`; Yosys 0.23 prints the hierarchy as text into the middle of it."""
    text = path.read_text()
    end = text.find("\n   },\n")
    data = json.loads(text[:end] + "\n}}" if end > 0 else text)
    return data["creator"], {name.lstrip("\\"): m for name, m in data["modules"].items()}


def _short(module):
    r"""rt_fifo of $paramod$0123...\rt_fifo or $paramod\rt_fifo\WIDTH=..."""
    return re.sub(r"^\$paramod(\$[0-9a-f]+)?\\", "", module).lstrip("\\").split("\\")[0]


def _products(path):
    """Partial product bits, A_WIDTH * B_WIDTH summed, of the $mul of each module."""
    bits, module, width = {}, None, 0
    for line in path.read_text().splitlines() if path.exists() else []:
        word = line.split()
        if line.startswith("module "):
            module = word[1].lstrip("\\")
        elif word[:2] == ["parameter", "\\A_WIDTH"]:
            width = int(word[2])
        elif word[:2] == ["parameter", "\\B_WIDTH"]:
            bits[module] = bits.get(module, 0) + width * int(word[2])
    return bits


def _depth(path):
    """Cells of the longest path, and how many of them are carry cells (by their names)."""
    steps = re.findall(r"^ *[1-9][0-9]*: .*\(via (.*)\)$", path.read_text(), re.M)
    kinds = [re.findall(r"(LUT[1-6]|MUXF[78]|CCU2C|CARRY4)(?=_)", step)[-1:] for step in steps]
    return len(steps), sum(kind in (["CCU2C"], ["CARRY4"]) for kind in kinds)


def read(folder):
    """The run whose folder it is; `sizes` are those that it has besides its engines."""
    folder = Path(folder)
    key = folder.name
    profile, target, variant = key.split("-", 2)
    name, *widths = profile.split("_")
    if widths:  # NAME_pq12_ng0: sim/cores.py
        profile = name + ":" + ",".join(re.sub(r"(\d)", r"=\1", w, count=1) for w in widths)
    parameters = dict(p.split("=") for p in (folder / "parameters").read_text().split())
    parameters = {name: int(value) for name, value in parameters.items()}
    seconds = parameters.pop("SECONDS")
    creator, mapped = _stat(folder / "stat.json")
    _, declared = _stat(folder / "rtl.json")
    products = _products(folder / "multiply")
    flat = variant.endswith("-flat")
    cores, own_sizes = variant.removesuffix("-flat").rsplit("-engines", 1)
    named = [re.sub(r"\d+$", "", size).upper() for size in own_sizes.split("-")[1:]]
    named = [name + "_STEP" if name in ("ROOT", "QUOTIENT") else name for name in named]

    def own(name):
        cells = mapped.get(name, {"num_cells_by_type": {}})["num_cells_by_type"]
        counts = {}
        for column, weights, _ in COLUMNS[target]:
            counts[column] = sum(weight * n for pattern, weight in weights.items()
                                 for cell, n in cells.items() if re.fullmatch(pattern, cell))
        counts["bits"] = declared.get(name, {"num_memory_bits": 0})["num_memory_bits"]
        if target == "generic":
            counts["pp_bits"] = products.get(name, 0)
        return counts

    def children(name, tree):
        for cell, n in tree[name]["num_cells_by_type"].items():
            if cell.lstrip("\\") in tree:
                yield cell.lstrip("\\"), n

    def add(into, counts, n=1):
        for column, value in counts.items():
            into[column] = into.get(column, 0) + n * value

    totals, rows = {}, {}

    def total(name):
        if name not in totals:
            totals[name] = own(name)
            for child, n in children(name, mapped):
                add(totals[name], total(child), n)
        return totals[name]

    def walk(name, n):
        row = rows.setdefault(_short(name), {"instances": 0, "own": {}, "total": {}})
        row["instances"] += n
        add(row["own"], own(name), n)
        add(row["total"], total(name), n)
        for child, m in children(name, mapped):
            walk(child, n * m)

    def memory(name):
        return (declared[name]["num_memory_bits"]
                + sum(n * memory(child) for child, n in children(name, declared)))

    top = next(name for name in mapped if _short(name) == "rt_core")
    walk(top, 1)
    if flat:
        for counts in rows["rt_core"]["own"], rows["rt_core"]["total"]:
            counts["bits"] = memory(next(name for name in declared if _short(name) == "rt_core"))
    depth, carry = _depth(folder / "depth")
    return {"key": key, "profile": profile, "target": target, "flat": flat,
            "list": cores, "sizes": {name: parameters[name] for name in named},
            "yosys": creator, "seconds": seconds, "parameters": parameters,
            "depth": depth, "depth_carry": carry,
            "core": rows["rt_core"]["total"], "modules": rows}
