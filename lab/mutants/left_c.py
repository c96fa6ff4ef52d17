# left_c.py - the faults in the model that the page lists as left, tried again in some suites
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.mutants.left_c BUILD SUITE[=FILE]...
Each SUITE (test_leaf, hard_named) tries the faults that are left in docs/results/data, those of
FILE of cmodel/ alone if it is given. The tables of docs/results/mutants.md are made anew. A fault
whose line the source has no more keeps what is known of it."""
import re
import sys
import tempfile

from ..pages import data
from . import model

COMPILER = ["gcc", "-std=c11"]
SECONDS = 60    # of a processor


def main(build, *suites):
    trial = model.Trial(build, COMPILER, survey=False)
    known = model.reasons()
    found = {row[0]: ["left", "-"] if row[0] in known else row[1:]
             for row in data.read("mutants.model_faults")[1]}
    where = {model.name_of(*p): p for p in model.places()}
    for suite, _, file in (s.partition("=") for s in suites):
        for fault, (verdict, _) in found.items():
            if (verdict != "left" or fault in known or fault not in where
                    or not fault.startswith(file)):
                continue
            name, at, length, to = where[fault]
            with open(name, encoding="utf-8") as f:
                text = f.read()
            with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
                made, _ = trial.compiled(folder, name, text[:at] + to + text[at + length:])
                program = trial.link(folder, suite, [made], f"{build}/libsphaera.a")
                if not trial.run(program, SECONDS):
                    found[fault] = ["killed", suite]
            print(suite, found[fault][0], fault, flush=True)
    with open(model.PAGE, encoding="utf-8") as f:
        run = re.search(r"<!-- model_run -->\n.*\n.*\n\| (.*) \|", f.read())[1].split(" | ")
    model.told(found, run[0], len(where), int(run[3]))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
