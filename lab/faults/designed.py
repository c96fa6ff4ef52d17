# designed.py - faults as a designer makes them: each is tried by the nearest bench, then by others
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab designed BUILD [PATTERN]
       python3 -m lab designed BUILD --tell
The lists tests/faults/designed/*.txt are those of tests/faults (python3 -m lab faults --help)
without judges: `rule` is what somebody may have thought, and `same TEXT` says why nothing can
notice the fault. They were written before the checks of their modules were read. PATTERN: faults
whose name or file has it in it.

A fault of the RTL meets the lines of the bench of its module, or of the next module above which
has one: all faults of these modules stand in one program, and a number selects one. What is left
meets a bench above, proofs of its file, and frames of the core. A fault of the model, of the tool,
driver or lab meets the suites of its folder. Results are kept in BUILD/designed; what is known of
the same fault in the same sources is not asked again."""
import glob
import hashlib
import json
import os
import re
import shutil
import subprocess

from .. import intact
from ..benches import Broken, folders, text_of
from ..pages import place
from . import records, selected
from .drawn import benches, binary, plan

LISTS = "tests/faults/designed/*.txt"
PAGE = "docs/results/verification.md"
HARNESS = {"rtl": ("tb", "formal"), "model": ("tests",), "driver": ("tests",), "lab": ("tests",)}


class Selected(benches.DrawnLine):
    """A line of tb/benches.txt around its module, all faults in it."""

    def __init__(self, line, build):
        super().__init__(line, build)
        self.folder = f"{build}/designed/{self.name.replace('/', '-')}"

    def make(self, texts):
        shutil.rmtree(self.folder, ignore_errors=True)
        edited = []
        for path, text in texts.items():
            name = f"{self.folder}/{path}"
            edited.append(os.path.dirname(name))
            os.makedirs(edited[-1], exist_ok=True)
            intact.write(name, text)
        top = next(n for d in (*edited, "rtl/*") for n in glob.glob(f"{d}/{self.top}.v"))
        return self.around(self.folder, [
            *benches.LOOSE, "--language", "1800-2017", *folders(*edited),
            *(f"-G{n}={v}" for n, v in self.parameters), top], effort=self.effort(),
            begin=benches.NUMBER)


class Kept:
    """What is known of each fault, in a file of its own: so runs may share a folder."""

    def __init__(self, build):
        self.folder = f"{build}/designed/results"
        self.known = {}
        os.makedirs(self.folder, exist_ok=True)

    def of(self, record):
        """[[judge, verdict, seconds]...] of those that tried this fault in these sources."""
        if record.name not in self.known:
            seen = repr([(e.path, e.old, e.new) for e in record.edits])
            seen += "".join(text_of(e.path) for e in record.edits)
            digest, name = hashlib.sha256(seen.encode()).hexdigest()[:12], self.name(record)
            row = json.loads(text_of(name)) if os.path.exists(name) else {}
            self.known[record.name] = row if row.get("of") == digest else {
                "of": digest, "tried": []}
        return self.known[record.name]["tried"]

    def name(self, record):
        return f"{self.folder}/{record.name}.json"

    def add(self, record, judge, verdict, seconds):
        tried = self.of(record)
        tried[:] = [row for row in tried if row[0] != judge] + [[judge, verdict, seconds]]
        intact.write(self.name(record), json.dumps(self.known[record.name]))
        print(f"{record.name}: {judge}: {verdict}", flush=True)

    def alive(self, record):
        return all(row[1] in ("survived", "broken") for row in self.of(record))


def module(record):
    return os.path.basename(record.edits[0].path)[:-2]


def near(name, tops, above):
    """Modules with a bench, the nearest above one module or it itself."""
    level, seen = {name}, set()
    while level and not level & tops:
        seen |= level
        level = set().union(*(above[m] for m in level)) - seen
    return sorted(level & tops)


def at_bench(kept, line, faults):
    """Tries faults that this line has not met."""
    left = dict(enumerate([r for r in faults if kept.alive(r) and not any(
        row[0] == line.name for row in kept.of(r))], 1))
    if not left:
        return
    by_file = {}
    for number, record in left.items():
        for edit in record.edits:
            by_file.setdefault(edit.path, {}).setdefault(number, []).append(edit)
    texts, alone = {}, set()
    for path, edits in by_file.items():
        with open(path, encoding="utf-8") as f:
            texts[path], some = selected.made(f.read(), edits)
        alone |= some
    groups = [(texts, {n: r for n, r in left.items() if n not in alone})] + [
        (records.planted(left[n].edits), {0: left[n]}) for n in sorted(alone)]
    words, sound = ["1"], 60
    for texts, group in groups:
        if not group:
            continue
        try:
            program = line.make(texts)
            if 0 not in group:
                verdict, sound = binary.attempt(line, program, 0, words, 600)
                if verdict != "survived":
                    raise Broken(f"without a fault it is {verdict}")
        except Broken as why:
            print(f"{line.name}: {why}", flush=True)
            for record in group.values():
                kept.add(record, line.name, "broken", 0)
            continue
        for number, record in group.items():
            kept.add(record, line.name, *binary.attempt(
                line, program, number, words, binary.PATIENCE * sound + binary.SLACK))
    shutil.rmtree(line.folder, ignore_errors=True)


def rtl(kept, found, build):
    lines = benches.benches.every(build, Selected)
    quick = {line.name for line in benches.benches.every(build, Selected, False)}
    lines.sort(key=lambda line: line.name not in quick)
    tops, above, homes = {line.top for line in lines}, plan.parents(), {}
    for record in found:
        homes.setdefault(tuple(near(module(record), tops, above)), []).append(record)
    for names, faults in homes.items():
        for line in lines:
            if line.top in names:
                at_bench(kept, line, faults)


def main(build, pattern="", tell=False):
    found = records.read(sorted(glob.glob(LISTS)), judged=False)
    picked = [r for r in found if any(pattern in text 
                                      for text in (r.name, *(e.path for e in r.edits)))]
    kept = Kept(build)
    if not tell:
        rtl(kept, [r for r in picked if r.edits[0].side == "rtl"], build)
    left = [r for r in picked if kept.alive(r)]
    print(f"{len(picked)} faults, {len(picked) - len(left)} noticed", *(r.name for r in left), sep="\n  ")
