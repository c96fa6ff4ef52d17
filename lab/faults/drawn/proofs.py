# proofs.py - faults that a proof of formal/proofs.txt must notice: those behind 2^32 clocks
# SPDX-License-Identifier: Apache-2.0
import glob
import os
import shutil

from . import benches, netlist

SCRIPT = '''#!/bin/sh
cd {tree} || exit 2
number=${{MUTANT:-0}}
sed "/import .DPI-C/d; /initial mutsel/d; s/reg \\(.*\\) mutsel;/wire \\1 mutsel = $number;/" \\
    faults.v >{source}
BUILD=build NICE= sh formal/prove.sh ={proof}
rc=$?
[ "$number" = 0 ] && exit $rc
[ $rc != 1 ] # no verdict is none
'''


def listed():
    """{module: (its proof, memories that the proof has models of)}: of one module without
    parameters, which takes seconds."""
    found = {}
    with open("formal/proofs.txt", encoding="utf-8") as f:
        for line in f:
            word = [w.strip() for w in line.split("|")]
            if len(word) == 7 and word[2] == "-" and word[6] == "quick":
                module = os.path.basename(word[3])[:-2]
                memories = [f"rt_{name}" for name in word[4].split() if name != "-"]
                if word[1] == f"f_{word[0]}" and module == f"rt_{word[0]}" and all(
                        glob.glob(f"rtl/memory/{name}.v") for name in memories):
                    found[module] = word[0], memories
    return found


class Proof(benches.Drawn):
    """A proof of a module, of a copy of the tree in which its netlist stands."""

    def __init__(self, module, proof, memories, build):
        super().__init__(f"proof/{proof}", module, [], build)
        self.proof, self.memories, self.runs = proof, memories, [[]]

    def netlist(self):
        return netlist.Netlist(self.folder, self.top, self.parameters, self.memories)

    def sources(self):
        return [f"formal/f_{self.proof}.v", "formal/prove.sh"]

    def make(self, verilog):
        tree, [source] = f"{self.folder}/tree", glob.glob(f"rtl/*/{self.top}.v")
        shutil.rmtree(tree, ignore_errors=True)
        for name in ("rtl", "formal"):
            shutil.copytree(name, f"{tree}/{name}")
        shutil.copy(verilog, f"{tree}/faults.v")
        with open(f"{tree}/run.sh", "w", encoding="utf-8") as f:
            f.write(SCRIPT.format(tree=tree, source=source, proof=self.proof))
        os.chmod(f"{tree}/run.sh", 0o755)
        return f"{tree}/run.sh"

    @staticmethod
    def passed(text):
        del text
        return True     # its exit code says all
