# placed.py - what nextpnr says of a placed core, in short
# SPDX-License-Identifier: Apache-2.0
"""Prints JSON: Fmax in MHz, the critical path of the clock with the instances that it passes and
its delays in ns, and what of the device is used. Before routing the report has no clocks: then what
the log estimates, and no path; a routing that was broken off has no report, and the log has it
all."""
import json
import os
import re
import sys


def instance(cell):
    """u_core.u_engine.u_leaf of u_core.g_engine[0].u_engine.u_leaf.disc_q_TRELLIS_FF; "" of a name
    without an instance."""
    parts = [p for p in re.split(r"\.", cell) if re.match(r"u_|g_", p)]
    return ".".join(re.sub(r"\[\d+\]$", "", p) for p in parts if not p.startswith("g_"))


def path_of(report):
    """The slowest path between two registers of the clock, of those that are reported: the one
    whose delays sum up to the most."""
    best = {"ns": 0.0, "logic_ns": 0.0, "steps": 0, "through": []}
    for path in report["critical_paths"]:
        if re.search(r"<async>|_clk\b", path["from"] + path["to"]):
            continue
        kinds = {"logic": 0.0, "routing": 0.0, "setup": 0.0, "clk-to-q": 0.0}
        through, steps = [], 0
        for step in path["path"]:
            kinds[step["type"]] = kinds.get(step["type"], 0.0) + step["delay"]
            steps += step["type"] == "logic"
            where = instance(step["to"]["cell"])
            if where and through[-1:] != [where]:
                through.append(where)
        total = sum(kinds.values())
        if total > best["ns"]:
            best = {"ns": round(total, 2), "logic_ns": round(total - kinds["routing"], 2),
                    "steps": steps, "through": through}
    return best


def estimated(log):
    """Clocks as the log of a placement has them, the last word of each."""
    with open(log, encoding="utf-8") as f:
        return {m[1]: float(m[2]) for m in
                re.finditer(r"Max frequency for clock '(.*)': *([0-9.]+) MHz", f.read())}


def used_of(log):
    """What is used of the device, as a log has it, in the shape of a report."""
    with open(log, encoding="utf-8") as f:
        return {m[1]: {"used": int(m[2]), "available": int(m[3])} for m in
                re.finditer(r"^Info: \s+([A-Z0-9_]+): +([0-9]+)/ *([0-9]+) +[0-9]+%$", f.read(),
                            re.M)}


def main(path, log, routed, seconds, version):
    report = {"utilization": used_of(log)}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as f:
            report = json.load(f)
    clocks = estimated(log) if routed == "0" else \
        {name: c["achieved"] for name, c in report["fmax"].items()}
    own = [mhz for name, mhz in clocks.items() if re.search(r"(^|\$)clk(\$|$)", name)]
    if len(own) != 1:
        sys.exit(f"placed: {path}: of the clocks {clocks} one is clk")
    used = {k: [v["used"], v["available"]] for k, v in report["utilization"].items() if v["used"]}
    json.dump({"fmax": round(own[0], 2), "routed": int(routed),
               "path": path_of(report) if routed != "0" else None, "used": used,
               "seconds": int(seconds), "nextpnr": version}, sys.stdout, indent=1)
    print()
