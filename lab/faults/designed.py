# designed.py - faults as a designer makes them: each is tried by the nearest bench, then by others
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab designed BUILD [PATTERN]
       python3 -m lab designed BUILD --told
The lists tests/faults/designed/*.txt are those of tests/faults (python3 -m lab faults --help)
without judges: `rule` is what somebody may have thought, and `same TEXT` says why nothing can
notice the fault. They were written before the checks of their modules were read. PATTERN: faults
whose name or file has it in it.

A fault of the RTL meets the lines of the bench of its module, or of the next module above which
has one: all faults of these modules stand in one program, and a number selects one. What is left
meets a bench above, proofs of its file, and frames of the core. A fault of the model, of the tool,
driver or lab meets the suites of its folder. Results are kept in BUILD/designed; what is known of
the same fault in the same sources is not asked again."""
import collections
import glob
import hashlib
import json
import os
import re
import shutil
import time

from .. import intact
from ..benches import Broken, folders, text_of
from ..pages import place
from . import records, selected, suites
from .drawn import benches, binary, boards, plan

PATIENCE, SLACK, LONGEST = 2.0, 3.0, 60     # a fault may take so many times the sound one, and more
MOST = int(os.environ.get("LINES", 99))
PAGE = "docs/results/verification.md"
HOMES = {"rt_boxes": {"rt_trace"}}     # the bench of rt_traverse has no boxes


class Selecting:
    """Around sources with faults of which a number selects one, in the place of a netlist."""
    def edited(self, texts):
        """Folders of the edited files."""
        shutil.rmtree(self.folder, ignore_errors=True)
        for path, text in texts.items():
            os.makedirs(os.path.dirname(f"{self.folder}/{path}"), exist_ok=True)
            intact.write(f"{self.folder}/{path}", text)
        return [f"{self.folder}/{name}" for name in sorted({os.path.dirname(p) for p in texts})]

    def verilate(self, edited):
        """What Verilator is told."""
        top = next(n for d in (*edited, "rtl/*") for n in glob.glob(f"{d}/{self.top}.v"))
        return [*benches.LOOSE, "--language", "1800-2017", *folders(*edited),
                *(f"-G{n}={v}" for n, v in self.parameters), top]


class Selected(Selecting, benches.DrawnLine):
    """A line of tb/benches.txt around its module."""

    def __init__(self, line, build):
        super().__init__(line, build)
        self.folder = f"{build}/designed/{self.name.replace('/', '-')}"
        self.runs = [["1"]]

    def make(self, texts):
        return self.around(self.folder, self.verilate(self.edited(texts)), effort=self.effort(),
                           begin=benches.NUMBER)


class Whole(Selecting):
    """A core or rt_top, as the campaign of drawn faults has them."""
    under = "designed"

    def __init__(self, *words):
        super().__init__(*words)
        was = self.folder
        self.folder = f"{self.build}/{self.under}/{self.name.replace('/', '-')}"
        for words in (*self.runs, *self.parameters):
            words[:] = [str(word).replace(was, self.folder) for word in words]

    def make(self, texts):
        self.here = self.edited(texts)
        os.makedirs(self.folder, exist_ok=True)
        self.prepare()
        return super().make(None)

    def prepare(self):
        """What must be there before the RTL is read."""

    def compiled(self, verilog, harness, macros, objects, libraries, more=()):
        return self.compile(self.folder, [*self.verilate(self.here), *more], harness, macros,
                            objects, libraries, begin=benches.NUMBER)


class Core(Whole, benches.Core):
    @staticmethod
    def source():
        return "tb/core/compare.cpp"


class Top(Whole, benches.Shell):
    seen = ("+define+TOP_VIEW", "-Iformal", "tb/top/rt_top_rules.sv")

    def __init__(self, build, layers=0):
        super().__init__(build)
        self.parameters.append(f"LAYERS={layers}".split("="))
        self.name += "-layers" * layers
        self.folder += "-layers" * layers

    @staticmethod
    def source():
        return "tb/top/tb_shell.cpp"


class Board(Whole, boards.RamBoard):
    def prepare(self):
        boards.RamBoard.prepare(self)

    @staticmethod
    def source():
        return "tb/board/tb_ulx3s_ram.cpp"


def digest(source):
    """Digest of a file."""
    return hashlib.sha256(text_of(source).encode()).hexdigest()[:12] if source else ""


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
            seen_of, name = hashlib.sha256(seen.encode()).hexdigest()[:12], self.name(record)
            row = json.loads(text_of(name)) if os.path.exists(name) else {}
            self.known[record.name] = row if row.get("of") == seen_of else {
                "of": seen_of, "tried": []}
        return self.known[record.name]["tried"]

    def name(self, record):
        return f"{self.folder}/{record.name}.json"

    def met(self, record, judge, source=""):
        """Whether this judge has tried it, as the judge is now."""
        return any(row[0] == judge and row[3:] in ([], [digest(source)]) for row in self.of(record))

    def add(self, record, judge, verdict, seconds, source=""):
        tried = self.of(record)
        tried[:] = [row for row in tried if row[0] != judge] + [
            [judge, verdict, round(seconds, 2), digest(source)]]
        intact.write(self.name(record), json.dumps(self.known[record.name]))
        print(f"{record.name}: {judge}: {verdict}", flush=True)

    def alive(self, record):
        return all(row[1] in ("survived", "broken") for row in self.of(record))


def module(record):
    return os.path.basename(record.edits[0].path)[:-2]


def near(name, tops, above):
    """Modules with a bench, the nearest above one module or it itself."""
    level, seen = HOMES.get(name, {name}), set()
    while level and not level & tops:
        seen |= level
        level = set().union(*(above[m] for m in level)) - seen
    return sorted(level & tops)


def at_bench(kept, line, faults):
    """Tries faults that this line has not met."""
    left = dict(enumerate([r for r in faults if kept.alive(r) and not kept.met(
        r, line.name, line.source())], 1))
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
    for texts, group in groups:
        if not group:
            continue
        try:
            program = line.make(texts)
            limits = [LONGEST] * len(line.runs) if 0 in group else []
            for words in line.runs if 0 not in group else ():
                verdict, took = binary.attempt(line, program, 0, words, 600)
                if verdict != "survived":
                    raise Broken(f"without a fault it is {verdict}: {words}")
                limits.append(PATIENCE * took + SLACK)
        except Broken as why:
            print(f"{line.name}: {why}", flush=True)
            for record in group.values():
                kept.add(record, line.name, "broken", 0, line.source())
            continue
        for number, record in group.items():
            total = 0
            for words, limit in zip(line.runs, limits):
                verdict, took = binary.attempt(line, program, number, words, limit)
                total += took
                if verdict != "survived":
                    break
            kept.add(record, line.name, verdict, total, line.source())
    shutil.rmtree(line.folder, ignore_errors=True)


def whole(name, build):
    """What stands for the bench of a module that none above has one: core, rt_top, a board."""
    folder = glob.glob(f"rtl/*/{name}.v")[0].split("/")[1]
    if folder in ("top", "bus", "video"):
        return [Top(build), Top(build, 1)]
    if folder == "board":
        return [Board(build)]
    return [Core(benches.CORES[0], build)]


def rtl(kept, found, build, others):
    """The nearest bench, or others: the quickest line of those above, then the core or rt_top."""
    lines = benches.benches.every(build, Selected)
    quick = {line.name for line in benches.benches.every(build, Selected, False)}
    lines.sort(key=lambda line: line.name not in quick)
    tops, above, homes = {line.top for line in lines}, plan.parents(), {}
    for record in found:
        homes.setdefault(tuple(near(module(record), tops, above)), []).append(record)
    for names, faults in homes.items():
        if others:
            wanted = set().union(*(near(n, tops - set(names), above) for n in names))
            for top in sorted(wanted):
                at_bench(kept, next(line for line in lines if line.top == top), faults)
            continue
        for line in [line for line in lines if line.top in names][:MOST]:
            at_bench(kept, line, faults)
    last = {}
    for names, faults in homes.items():
        for record in faults if others or not names else ():
            for at in whole(module(record), build)[:MOST]:
                last.setdefault(at.name, (at, []))[1].append(record)
    for at, faults in last.values():
        at_bench(kept, at, faults)


def programs(kept, found, picked, build):
    """Faults of C and Python: suites of their folder, then those that go through all."""
    tree = None
    for others in (False, True):
        for record in picked:
            for suite in suites.others() if others else suites.near(record):
                if not kept.alive(record):
                    break
                name = ("" if others else "near ") + os.path.basename(suite)
                if kept.met(record, name, suite):
                    continue
                tree = tree or suites.Tree(build, found)
                began = time.monotonic()
                try:
                    verdict = tree.ask(record, suite)
                except Broken as why:
                    print(why, flush=True)
                    continue
                kept.add(record, name, verdict, time.monotonic() - began, suite)


HEAD = ["faults", "noticed by the nearest", "by others", "equivalent", "left", "not tried",
        "noticed, %", "by the nearest, %"]


def verdicts(kept, found, build):
    """[(record, verdict, judge)]: nearest, others, equivalent, left, or not tried."""
    lines = {line.name: line.top for line in benches.benches.every(build, Selected)}
    tops, above = set(lines.values()), plan.parents()
    told = []
    for record in found:
        killed = [row[0] for row in kept.of(record) if row[1] not in ("survived", "broken")]
        if not killed:
            told.append((record, "equivalent" if record.same else
                         "left" if kept.of(record) else "not tried", ""))
            continue
        close = killed[0].startswith("near ")
        if record.edits[0].side == "rtl":
            names = near(module(record), tops, above)
            close = lines.get(killed[0]) in names if names else killed[0] not in lines
        told.append((record, "nearest" if close else "others", killed[0].removeprefix("near ")))
    return told


def row(name, count):
    alive = count["nearest"] + count["others"] + count["left"]
    return [name, str(sum(count.values())), *(str(count[word]) for word in (
        "nearest", "others", "equivalent", "left", "not tried")), *(
            f"{100 * part / max(1, alive):.1f}" for part in (
                count["nearest"] + count["others"], count["nearest"]))]


def tell(kept, found, build):
    """The tables of the page."""
    told = verdicts(kept, found, build)
    by = collections.defaultdict(collections.Counter)
    for record, verdict, _ in told:
        edit = record.edits[0]
        folder = "/".join(edit.path.split("/")[:2]) if edit.side in ("rtl", "model") else edit.side
        by[folder][verdict] += 1
    place.place(PAGE, "make designed", {
        "designed": [["folder", *HEAD], *(row(name, by[name]) for name in sorted(by)),
                     row("**all**", sum(by.values(), collections.Counter()))],
        "designed_faults": [["fault", "file", "verdict", "by"], *(
            [record.name, record.edits[0].path, verdict, judge or record.same or "-"]
            for record, verdict, judge in told)]})
    print(*(f"{record.name}: {verdict}" for record, verdict, _ in told
            if verdict in ("left", "not tried") or record.same and verdict != "equivalent"),
          sep="\n")


def main(build, pattern="", told=False, others=False):
    found = records.read(glob.glob(records.DESIGNED), judged=False)
    picked = [r for r in found if any(pattern in text
                                      for text in (r.name, r.file, *(e.path for e in r.edits)))]
    kept = Kept(build)
    if not told:
        for later in (False, True)[:1 + others]:
            rtl(kept, [r for r in picked if r.edits[0].side == "rtl"], build, later)
        programs(kept, [r for r in found if r.edits[0].side != "rtl"],
                 [r for r in picked if r.edits[0].side != "rtl"], build)
    else:
        tell(kept, found, build)
    left = [r for r in picked if kept.alive(r)]
    print(f"{len(picked)} faults, {len(picked) - len(left)} noticed", *(r.name for r in left),
          sep="\n  ")
