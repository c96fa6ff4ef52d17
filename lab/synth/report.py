# report.py - tables of synthesised cores: report.md, report.json, and a short one to print
# SPDX-License-Identifier: Apache-2.0
import json
import os

from .. import intact
from . import results

# sizes that have a variable of their own
VARIABLES = "PIPES", "LEAF_UNITS", "SHADES", "ROOT_STEP", "QUOTIENT_STEP"
PRODUCTS = "Products are of LUTs: Yosys 0.23 maps none to multipliers of the family."
FILES = "The family has no memory in LUTs: slot files are of flip-flops."
NOTE = {
    "gowin": PRODUCTS,
    "ice40": f"{FILES} {PRODUCTS}",
    "nexus": "LUT4, and CCU2 of two LUT4 each.",
    "gatemate": FILES,
    "efinix": f"{FILES} {PRODUCTS}",
    "ecp5": "LUT4eq = LUT4 + 2 CCU2C; `LUT places` adds 6 for each TRELLIS_DPR16X4.",
    "xc7": "LUT counts functions of up to 6 inputs; `LUT as RAM` are LUTs that hold memory or shift"
           " registers.",
    "generic": "Gates have one or two inputs, or are multiplexers of two. Multipliers are not"
               " broken into gates: `product bits` is the sum of operand widths multiplied, one"
               " AND gate and about one full adder each. Memories are counted in bits.",
}


def times(ratio):
    """A ratio of times in two digits: 0.37, 4.2, 130."""
    digits = f"{ratio:.1e}"
    return f"{float(digits):.{max(0, 1 - int(digits[4:]))}f}"


def table(head, rows, left=1):
    """Markdown; all but the first `left` columns to the right."""
    widths = [max(len(str(row[i])) for row in [head] + rows) for i in range(len(head))]

    def line(row):
        cells = [str(c).ljust(w) if i < left else str(c).rjust(w)
                 for i, (c, w) in enumerate(zip(row, widths))]
        return "| " + " | ".join(cells) + " |"
    rule = "|" + "|".join("-" * (w + 1) + ("-" if i < left else ":")
                          for i, w in enumerate(widths)) + "|"
    return "\n".join([line(head), rule] + [line(row) for row in rows])


def effects(run):
    text = run["list"]
    if run["parameters"].get("ENGINES", 1) > 1:
        text += f", {run['parameters']['ENGINES']} engines"
    for name, value in run["sizes"].items():
        text += f", {name.lower()} {value}"
    return text + (", flat" if run["flat"] else "")


def depth(run):
    """40 (33): cells on the longest path, carry cells among them (ecp5 names its cells)."""
    return f"{run['depth']} ({run['depth_carry']})" if run["target"] == "ecp5" else run["depth"]


def cores(runs, target):
    """One line a core."""
    columns = results.columns(target)
    rows = [[r["profile"], effects(r)] + [r["core"][c] for c, _ in columns]
            + [depth(r), r["seconds"]] for r in runs if r["target"] == target]
    return table(["profile", "effects"] + [h for _, h in columns] + ["depth", "s"], rows)


def modules(run):
    """One line a module, largest own part first."""
    columns = results.columns(run["target"])
    size = results.SIZE.get(run["target"], "lut")
    whole = max(1, run["core"][size])
    ordered = sorted(run["modules"].items(),
                     key=lambda m: (-m[1]["own"][size], -m[1]["own"]["ff"], m[0]))
    heads = dict(columns)
    rows = [[name, m["instances"]] + [m["own"][c] for c, _ in columns]
            + [f"{100 * m['own'][size] / whole:.1f} %", m["total"][size], m["total"]["mult"]]
            for name, m in ordered]
    return table(["module", "n"] + [h for _, h in columns]
                 + ["share", "with children " + heads[size], heads["mult"]], rows)


def blocks(run):
    """Blocks of an ECP5 core with what is inside them, all instances together; places of one
    instance and of what each pipe has of them in the mean; those of a hundredth of the core."""
    pipes = run["parameters"].get("PIPES", 1) * run["parameters"].get("ENGINES", 1)
    columns = "places", "lut4eq", "dpr", "ff", "mult", "bram"
    heads = dict(results.columns("ecp5"))
    ordered = sorted(run["modules"].items(), key=lambda m: (-m[1]["total"]["places"], m[0]))
    rows = [[name, m["instances"], *(m["total"][c] for c in columns),
             round(m["total"]["places"] / m["instances"]), round(m["total"]["places"] / pipes)]
            for name, m in ordered if 100 * m["total"]["places"] >= run["core"]["places"]]
    return table(["block", "n", *(heads[c] for c in columns), "places of one", "a pipe"], rows)


def markdown(runs, command):
    text = ["# Area", "", f"`{command}`, {runs[0]['yosys']}; no place and route.", ""]
    for target in results.COLUMNS:
        if any(r["target"] == target for r in runs):
            text += [f"## {target}", "", NOTE[target], "", cores(runs, target), ""]
    for run in runs:
        if not run["flat"]:
            widths = ", ".join(f"{n} {v}" for n, v in run["parameters"].items())
            text += [f"## {run['profile']} on {run['target']}: modules", "", widths + ".", "",
                     modules(run), ""]
            if run["target"] == "ecp5":
                text += ["Blocks, with what is inside them:", "", blocks(run), ""]
    return "\n".join(text)


def main(folder, *keys):
    runs = [results.read(os.path.join(folder, key)) for key in keys]
    command = "make synth PROFILE={} TARGET={}".format(
        *("all" if len({r[name] for r in runs}) > 1 else runs[0][name]
          for name in ("profile", "target")))
    if runs[0]["list"] != "all":
        command += " EFFECTS=" + runs[0]["list"]
    if runs[0]["parameters"]["ENGINES"] > 1:
        command += f" ENGINES={runs[0]['parameters']['ENGINES']}"
    sizes = dict(runs[0]["sizes"])
    command += "".join(f" {name}={sizes.pop(name)}" for name in VARIABLES if name in sizes)
    if sizes:
        command += " SIZES=" + ",".join(f"{name.lower()}={n}" for name, n in sizes.items())
    if runs[0]["flat"]:
        command += " FLAT=1"
    intact.write(os.path.join(folder, "report.md"), markdown(runs, command))
    intact.write(os.path.join(folder, "report.json"),
                 json.dumps({"command": command, "yosys": runs[0]["yosys"], "runs": runs}, indent=1)
                 + "\n")
    for target in results.COLUMNS:
        if any(r["target"] == target for r in runs):
            print(f"\n{target}\n{cores(runs, target)}")
    if len(runs) == 1 and runs[0]["target"] == "ecp5" and not runs[0]["flat"]:
        print(f"\nblocks, with what is inside them\n{blocks(runs[0])}")
    for run in runs:
        if results.too_much(run):
            print(f"\n{run['key']} does not fit {results.too_much(run)}")
    print(f"\nmodules: {folder}/report.md, {folder}/report.json")
