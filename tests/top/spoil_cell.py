# spoil_cell.py - a netlist with a fault: a setting of a cell, or of some, is changed
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 tests/top/spoil_cell.py NETLIST.json TYPE SETTING VALUE|- OUTPUT.json [NAME]
The cell is that of TYPE which is nearest to the port pix_frame_o, going from outputs of cells to
their inputs; with NAME, a regular expression, all cells in whose name it is found. -: all bits of a
setting are inverted. Prints the cell, or the first of them, and what was changed."""
import json
import re
import sys
from collections import deque


def nearest(module, kind, setting):
    """The name of the cell."""
    drivers = {
        bit: name
        for name, cell in module["cells"].items()
        for port, bits in cell["connections"].items()
        if cell["port_directions"][port] == "output"
        for bit in bits
    }
    waiting, seen = deque(module["ports"]["pix_frame_o"]["bits"]), set()
    while waiting:
        name = drivers.get(waiting.popleft())
        if name is None or name in seen:
            continue
        seen.add(name)
        cell = module["cells"][name]
        if cell["type"] == kind and setting in cell["parameters"]:
            return name
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] == "input":
                waiting.extend(bits)
    raise SystemExit(f"no {kind} with {setting} drives pix_frame_o")


def main():
    """Reads, changes, writes."""
    source, kind, setting, value, target, *pattern = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        whole = json.load(file)
    module = whole["modules"]["rt_core"]
    names = [nearest(module, kind, setting)] if not pattern else [
        name for name, cell in module["cells"].items() if cell["type"] == kind
        and setting in cell["parameters"] and re.search(pattern[0], name)]
    if not names:
        raise SystemExit(f"no {kind} with {setting} is called {pattern[0]}")
    for name in names:
        settings = module["cells"][name]["parameters"]
        old = settings[setting]
        settings[setting] = old.translate(str.maketrans("01", "10")) if value == "-" else value
    with open(target, "w", encoding="utf-8") as file:
        json.dump(whole, file)
    print(f"{name}: {setting} {settings[setting]}, not {old}")


main()
