# placed.py - the summary of a report of nextpnr that is made up
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.placed FOLDER"""
import json
import os
import subprocess
import sys

CORE = "u_core.g_engine[0].u_engine."


def step(kind, delay, cell):
    return {"type": kind, "delay": delay, "from": {"cell": "x", "port": "Q"},
            "to": {"cell": cell, "port": "A"}}


long = [step("clk-to-q", 0.5, CORE + "u_leaf.q_TRELLIS_FF"),
        step("routing", 2.25, CORE + "u_leaf.a"), step("logic", 0.25, CORE + "u_leaf.b"),
        step("routing", 3.0, CORE + "u_root.c"), step("routing", 0.0, "merged"),
        step("setup", 0.0, CORE + "u_root.d")]
report = {"fmax": {"$glbnet$clk": {"achieved": 41.239, "constraint": 60.0}},
          "utilization": {"TRELLIS_FF": {"used": 7, "available": 83640},
                          "DCUA": {"used": 0, "available": 2}},
          "critical_paths": [{"from": "posedge clk", "to": "posedge clk", "path": long[:2]},
                             {"from": "posedge clk", "to": "posedge clk", "path": long},
                             {"from": "posedge clk", "to": "posedge clk", "path": long[:1]},
                             {"from": "<async>", "to": "posedge clk", "path": long + long}]}
path = sys.argv[1] + "/report.json"


log = sys.argv[1] + "/log"
with open(log, "w", encoding="utf-8") as out:
    for mhz in "10.00", "63.24":
        out.write(f"Info: Max frequency for clock '$glbnet$clk': {mhz} MHz (PASS at 60.00 MHz)\n")
    out.write("Info: \t          TRELLIS_FF:       9/  83640     0%\nInfo: 9/ 10 5%\n")


def summary(routed="1"):
    if report:
        with open(path, "w", encoding="utf-8") as f:
            json.dump(report, f)
    else:
        os.remove(path)
    ran = subprocess.run([sys.executable, "-m", "lab", "placed", path, log, routed, "77", "0.1"],
                         check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return json.loads(ran.stdout) if ran.returncode == 0 else ran.stderr.decode()


got = summary()
assert got["fmax"] == 41.24 and got["routed"] == 1 and got["seconds"] == 77, got
assert got["used"] == {"TRELLIS_FF": [7, 83640]}, got
assert got["path"] == {"ns": 6.0, "logic_ns": 0.75, "steps": 1,
                       "through": ["u_core.u_engine.u_leaf", "u_core.u_engine.u_root"]}, got
early = dict(report, fmax={}, critical_paths=[])
report, late = early, report
got = summary("0")
assert got["fmax"] == 63.24 and got["routed"] == 0 and got["path"] is None, got
report = None  # routing was broken off
got = summary("0")
assert got["fmax"] == 63.24 and got["used"] == {"TRELLIS_FF": [9, 83640]}, got
report = late
# of rt_top: the core's counts
report["fmax"]["$glbnet$pix_clk$TRELLIS_IO_IN"] = {"achieved": 300.0}
assert summary()["fmax"] == 41.24
report["fmax"] = {"other": {"achieved": 1.0}}
assert "clocks" in summary()

# ---- the registers around a core: every port once, none of another module ----
NETLIST = r"""
module \other
  wire width 9 input 1 \foreign_i
end
attribute \top 1
module \rt_core
  wire width 3 \inner
  wire input 1 \clk
  wire input 5 \pix_clk
  wire width 8 input 2 \data_i
  wire input 3 \rst
  attribute \src "x"
  wire width 4 output 4 \sum_o
end
"""


def registers(text):
    netlist = sys.argv[1] + "/netlist.il"
    with open(netlist, "w", encoding="utf-8") as f:
        f.write(text)
    return subprocess.run([sys.executable, "-m", "lab", "placed-between", netlist], check=False,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


made = registers(NETLIST).stdout
for line in ("(input wire clk, input wire pix_clk,", ".clk(clk),", ".pix_clk(pix_clk)",
             ".data_i(in_q[0 +: 8]),", ".rst(in_q[8 +: 1]),", ".sum_o(core[0 +: 4])",
             "reg  [8:0] in_q;", "reg  [3:0] out_q, fold_q;"):
    assert line in made, (line, made)
assert "foreign" not in made and "inner" not in made, made
assert registers("module \\other\nend\n").returncode == 1
