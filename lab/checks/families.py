# families.py - the slow paths of a file of delays that is made up
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.families FOLDER"""
import json
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

# ---- a netlist: register, look-up table, a sum of a pair of carries, register ----
FF = {"Q": "output", "DI": "input"}
SUMS = {"A0": "input", "COUT": "output", "CIN": "input", "S0": "output", "S1": "output"}


def element(kind, ways, **bits):
    return {"type": kind, "parameters": {}, "port_directions": ways,
            "connections": {pin: [bit] for pin, bit in bits.items()}}


path = sys.argv[1] + "/netlist.json"
with open(path, "w", encoding="utf-8") as out:
    json.dump({"modules": {"LUT4": {"attributes": {"blackbox": "1"}}, "top": {
        "attributes": {}, "cells": {
            "a_q_TRELLIS_FF_Q": element("TRELLIS_FF", FF, Q=2, DI=6),
            "b_LUT4_Z": element("LUT4", {"A": "input", "Z": "output"}, A=2, Z=3),
            "c_CCU2C_S0": element("CCU2C", SUMS, A0=3, COUT=4, CIN="0", S0=8, S1=9),
            "d_CCU2C_S0": element("CCU2C", SUMS, A0="0", COUT=10, CIN=4, S0=5, S1=7),
            "e_q_TRELLIS_FF_Q": element("TRELLIS_FF", FF, Q=6, DI=5)}}}}, out)
told = subprocess.run([sys.executable, "-m", "lab", "slow-paths", path], check=True, text=True,
                      stdout=subprocess.PIPE).stdout.splitlines()
# 400, wire 580, LUT 140, wire 580, into the chain 250, out of it 200, to the register 100, 50
wanted = ["0 of 2 end points are later than 8 ns",
          "  2.30  a_q > b > c > d > e_q", "  0.55  e_q > a_q"]
if told != wanted:
    sys.exit("\n".join(told))
