# families.py - the slow paths of a file of delays that is made up
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.families FOLDER"""
import subprocess
import sys


def cell(name, *lines):
    return f"  (CELL\n    (INSTANCE {name})\n" + "".join(f"        ({x})\n" for x in lines)


def flip_flop(name, setup):
    return cell(name, "IOPATH CLK Q (200:250:300) (200:250:300)",
                f"SETUPHOLD (posedge D) (posedge CLK) (0:0:{setup}) (0:0:0)")


def wires(*pins):
    return "".join(f"  (INTERCONNECT {one} {two} ({ps}:{ps}:{ps}) ({ps}:{ps}:{ps}))\n"
                   for one, two, ps in pins)


AT = "u_core.g_engine\\[0\\].u_engine."
A, B = AT + "u_a.first_q_TRELLIS_FF_Q_", AT + "u_b.second_q_TRELLIS_FF_Q_"
SUM = AT + "u_a.sum_LUT4_Z"
path = sys.argv[1] + "/delays.sdf"
with open(path, "w", encoding="utf-8") as out:
    out.write(wires((A + "0/Q", SUM + "/A", 3000), (A + "1/Q", SUM + "/B", 4000),
                    (SUM + "/F", B + "0/D", 2000), (SUM + "/F", B + "1/D", 3700),
                    (B + "0/Q", A + "0/D", 1000)))
    for name in A, B:
        out.write(flip_flop(name + "0", 5) + flip_flop(name + "1", 50))
    out.write(cell(SUM, "IOPATH A F (1:2:140) (1:2:140)", "IOPATH B F (1:2:100) (1:2:100)"))
told = subprocess.run([sys.executable, "-m", "lab", "slow-paths", path], check=True, text=True,
                      stdout=subprocess.PIPE).stdout.splitlines()
wanted = ["1 of 3 end points are later than 8 ns",
          "  8.15  u_a: first_q > sum > u_b: second_q", "  1.30  u_b: second_q > u_a: first_q"]
if told != wanted:
    sys.exit("\n".join(told))
