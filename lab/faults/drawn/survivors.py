# survivors.py - the faults that the page lists as left, tried again where checks are new
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab mutants-left BUILD [BENCH...]
Each BENCH (tb_leaf/tiny, core/EFFECTS, proof/run) tries all faults that are left in
docs/results/data and fit into its netlist; without one, entries of tests/faults/equivalent are
looked at alone. The tables of docs/results/verification.md are made anew, and told to be as old as
before. A fault whose line has moved gets the new one; if the source has it no more, what is known
of it stays."""

from . import benches, binary, equivalent, page


def main(build, *names):
    found = page.known()
    for name in names:
        bench = benches.named(name, build)
        netlist = bench.netlist()
        left = {netlist.again(f): f for f, (verdict, *_) in found.items() if verdict == "survived"}
        tried = [f for f in left if f and (f == left[f] or f not in found)]
        for fault, (verdict, seconds) in binary.run(bench, tried, netlist).items():
            before = found.pop(left[fault])
            found[fault] = [verdict, name, f"{float(before[2]) + seconds:.2f}"]
            print(verdict, page.text(fault), flush=True)
    told = {}
    for fault, (verdict, bench, seconds) in found.items():
        why = ""
        if verdict in ("survived", "equivalent"):
            why = (equivalent.rtl(page.text(fault)) or verdict == "equivalent" and
                   equivalent.rtl(page.text(fault), True) or ("", ""))[1]
            verdict = "equivalent" if why else "survived"
        told[fault] = verdict, bench, why, seconds
    page.tables(told, rest=True)
