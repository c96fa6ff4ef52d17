# survivors_c.py - the faults in the model that the page lists as left, tried again in some suites
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab mutants-c-left BUILD SUITE[=FILE]...
       python3 -m lab mutants-c-left BUILD again
Each SUITE (test_leaf, hard_named, test_leaf.sanitized) tries the faults that are left in
docs/results/data, those whose name begins with FILE, of cmodel/, if it is given. `again`: each that
was killed is tried once more in the suite that noticed it, after a change of the model or of tests.
A fault whose line the source has no more keeps what is known of it, with `again` it is no longer
counted. The tables of docs/results/verification.md are made anew. JOBS are tried at once."""
import json
import os
import re
import tempfile
from concurrent.futures import ThreadPoolExecutor

from ... import intact
from ...jobs import store
from ...pages import data
from .. import programs
from . import equivalent, model

COMPILER = ["gcc", "-std=c11"]
SECONDS = 60    # of a processor; a suite that is quick and not sanitized gets QUICK
QUICK = 12


def noticed(trial, place_of, suite, quick=False):
    """Whether a suite, "NAME" or "NAME sanitized", notices a fault."""
    name, at, length, to = place_of
    plain, _, sanitized = suite.partition(" ")
    text = model.source(name)
    with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
        made, _ = trial.compiled(folder, name, text[:at] + to + text[at + length:],
                                 programs.SANITIZE if sanitized else ("-O1",))
        program = trial.link(folder, plain, [made], bool(sanitized))
        return trial.run(program, quick and not sanitized and plain not in programs.HARD and QUICK
                         or SECONDS) != 0


def again(build, trial, pool, where, found):
    """Tries all that were killed once more; what was tried on these sources is kept."""
    kept, done = f"{build}/mutants/again.json", {}
    if os.path.exists(kept):
        with open(kept, encoding="utf-8") as f:
            done = json.load(f)
    model_digest = store.digest(model.MODEL)

    def one(fault):
        suite = found[fault][1]
        key = f"{model_digest} {model.sources(suite.split()[0])} {suite}"
        if done.get(fault, [""])[0] != key:
            done[fault] = [key, noticed(trial, where[fault], suite, True)]
        return done[fault][1]

    killed = [fault for fault, was in found.items() if was[0] == "killed"]
    for fault, still in zip(killed, pool.map(one, killed)):
        if not still:
            print("no more", *found[fault], fault, flush=True)
            found[fault] = ["left", found[fault][1]]
        intact.write(kept, json.dumps(dict(done), indent=0))


def main(build, *suites):
    trial = model.Trial(build, COMPILER, survey=False)
    known = equivalent.model()
    found = {row[0]: ["left", "-"] if row[0] in known else row[1:]
             for row in data.read("verification.model_faults")[1]}
    where = {model.name_of(*p): p for p in model.places()}
    with ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        if suites == ("again",):
            found = {fault: was for fault, was in found.items() if fault in where}
            again(build, trial, pool, where, found)
            suites = ()
        for suite, _, file in (s.partition("=") for s in suites):
            suite = suite.replace(".", " ")
            left = [fault for fault, was in found.items()
                    if was[0] == "left" and fault not in known and fault in where
                    and fault.startswith(file)]
            for fault, killed in zip(left, pool.map(
                    lambda fault, suite=suite: noticed(trial, where[fault], suite), left)):
                if killed:
                    found[fault] = ["killed", suite]
                print(suite, found[fault][0], fault, flush=True)
    with open(model.PAGE, encoding="utf-8") as f:
        run = re.search(r"<!-- model_run -->\n.*\n.*\n\| (.*) \|", f.read())[1].split(" | ")
    model.told(found, run[0], len(where), int(run[3]), rest=True)
