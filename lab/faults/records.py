# records.py - the lists of planted faults, tests/faults/*.txt: read, checked, and put into texts
# SPDX-License-Identifier: Apache-2.0
"""A list has records, one line a field:

    fault  NAME                    of small letters, digits and hyphens; no other has it
    rule   TEXT                    what the fault breaks
    model  FILE of cmodel/         or rtl FILE of rtl/, formal FILE of formal/: what is edited;
    from   TEXT                    stands there exactly once; a space stands for one or more blanks
    to     TEXT                    replaces it; may be empty
    by     JUDGE                   who must notice it; `more by JUDGE`: in the longer target alone
    agree  SCENE [OPTION...]       planted in model and RTL alike, both draw the scene (options of
                                   `sphaera build`) and agree, and what `by` names notices it

There may be several files in a record, each with its from and to, and several judges:

    core SCENE [OPTION...] [-- OPTION...]   the core in Icarus against the sound model: options of
                                   `sphaera build`, of the harness; textured: a core of just what
                                   the scene asks for; piped: with three pipes
    bench PATTERN [case N]         lines of tb/benches.txt; of a named hard case the vectors alone
    top [WIDTH [LAYERS [TREES]]]   rt_top around the sound model, under its driver; TREES: spheres
                                   that it builds trees of
    hard N                         the model, in a named case of build/test/hard
    test NAME                      the model, in a test of tests/
    naive                          the naive model draws the scene of `agree` otherwise
    proof NAME                     a proof of formal/proofs.txt
    reset MODULE                   lab.reset: what is quiet after a clock of reset
    crossings MODULE               lab.ip.crossings: paths between clocks of its netlist
"""
import difflib
import glob
import os
import re
from dataclasses import dataclass, field

from .. import benches
from ..ip import crossings

LISTS = "tests/faults/*.txt"
DESIGNED = "tests/faults/designed/*.txt"    # read without judges
FOLDERS = {"model": "cmodel", "rtl": "rtl", "formal": "formal", "driver": "driver", "lab": "lab"}
KEYS = ("fault", "rule", *FOLDERS, "from", "to", "by", "more", "agree", "same")
# judge: the groups that `--by` takes, sides that it is planted in
JUDGES = {"core": ("core", "rtl"), "textured": ("core", "rtl"), "piped": ("core", "rtl"),
          "bench": ("bench", "rtl"), "case": ("case", "rtl"), "top": ("top", "rtl"),
          "hard": ("hard", "model"), "test": ("test", "model"), "naive": ("agree", "model"),
          "agree": ("agree", "model rtl"), "proof": ("proof", ""), "reset": ("reset", "rtl"),
          "crossings": ("crossings", "rtl")}
GROUPS = tuple(dict.fromkeys(group for group, _ in JUDGES.values()))


@dataclass
class Edit:
    side: str
    file: str
    line: int
    old: str = ""
    new: str = ""

    @property
    def path(self):
        return f"{FOLDERS[self.side]}/{self.file}"


@dataclass(frozen=True)
class Judge:
    """A line that says who must notice: its kind, what follows, in the longer target alone."""
    kind: str
    words: tuple
    more: bool
    line: int

    @property
    def group(self):
        return JUDGES[self.kind][0]

    def __str__(self):
        return " ".join(("bench" if self.kind == "case" else self.kind, *self.words))


@dataclass
class Record:
    name: str
    file: str
    line: int
    rule: str = ""
    same: str = ""
    edits: list = field(default_factory=list)
    judges: list = field(default_factory=list)

    def side(self, judge):
        """The edits that a judge sees."""
        sides = JUDGES[judge.kind][1] or proof_side(judge.words[0])
        return [edit for edit in self.edits if edit.side in sides.split()]

    def agree(self):
        return next((judge for judge in self.judges if judge.kind == "agree"), None)

    def oracle(self):
        """Who notices what model and RTL agree on."""
        found = [judge for judge in self.judges if judge.kind in ("naive", "hard")]
        return max(found, key=lambda judge: judge.kind == "naive", default=None)


class Refused(Exception):
    """Lists that are not as they have to be: one message a line."""


def place(text, old):
    """Begin and end of what stands in a text, and how often it does."""
    pattern = "[ \\n]+".join(re.escape(word) for word in re.split(" +", old))
    found = re.findall(f"(?={pattern})", text)
    at = re.search(pattern, text)
    return (at.start(), at.end()) if at else (0, 0), len(found)


def edited(path, old, new, text=None):
    """The text of a file with an edit."""
    if text is None:
        with open(path, encoding="utf-8") as f:
            text = f.read()
    (begin, end), times = place(text, old)
    if times != 1:
        raise Refused(f"from: stands {times} times in {path}, not once: {old}")
    made = text[:begin] + new + text[end:]
    if made == text:
        raise Refused(f"to: is what stands in {path} already: {old}")
    return made


def planted(edits):
    """{path: text} of the files with edits in them."""
    texts = {}
    for edit in edits:
        texts[edit.path] = edited(edit.path, edit.old, edit.new, texts.get(edit.path))
    return texts


def proofs():
    """{proof: its top} of formal/proofs.txt."""
    with open("formal/proofs.txt", encoding="utf-8") as f:
        rows = [line.split("|") for line in f if line.count("|") >= 2 and line[0] != "#"]
    return {row[0].strip(): row[1].strip() for row in rows}


def proof_side(name, known={}):  # pylint: disable=dangerous-default-value
    """What a proof reads: a module, functions of the model, or lemmas of its own."""
    known.update(known or proofs())
    top = known.get(name, "")
    return "formal" if top.endswith(".smt2") else "model formal" if top.endswith(".c") else (
        "rtl formal")


def named_cases():
    with open("tests/hard/named_table.c", encoding="utf-8") as f:
        return len(re.findall(r"^ *\{", f.read().split("hard_named[]")[1].split("\n};")[0], re.M))


def nearest(word, known):
    found = difflib.get_close_matches(word, list(known), 1, 0.5)
    return f"; {found[0]} is meant?" if found else ""


class Reader:
    """Reads lists; `wrong` has what is not as it has to be."""

    def __init__(self, judged=True):
        self.records, self.wrong, self.judged = [], [], judged
        self.known = {
            "bench": [bench.name for bench in benches.every("build")],
            "proof": proofs(),
            "test": {os.path.basename(n)[:-2] for n in glob.glob("tests/*/test_*.c")},
            "reset": {os.path.basename(n)[:-2] for n in glob.glob("rtl/*/*.v")},
            "crossings": crossings.TOPS,
            "cases": named_cases()}

    def say(self, file, line, what):
        self.wrong.append(f"{file}:{line}: {what}")

    def read(self, name):
        record = Record("", name, 0)
        with open(name, encoding="utf-8") as f:
            for number, line in enumerate(f, 1):
                line = line.strip()
                if not line or line[0] == "#":
                    continue
                key, _, value = line.partition(" ")
                value = value.strip()
                if key == "fault":
                    record = Record(value, name, number)
                    self.records.append(record)
                elif not record.name:
                    self.say(name, number, f"{key}: stands before the first fault")
                else:
                    self.field(record, key, value, number)

    def field(self, record, key, value, number):
        edit = record.edits[-1] if record.edits else Edit("", "", 0)
        if key in FOLDERS:
            record.edits.append(Edit(key, value, number))
        elif key in ("from", "to"):
            name = "old" if key == "from" else "new"
            if not edit.side or getattr(edit, name) or name == "new" and not edit.old:
                self.say(record.file, number, f"{key}: stands behind no "
                         + ("from" if name == "new" else "model, rtl or formal"))
            setattr(edit, name, value)
        elif key == "rule":
            if record.rule:
                self.say(record.file, number, "rule: has the record already")
            record.rule = value
        elif key == "same" and not self.judged:
            record.same = value
        elif key in ("by", "more", "agree") and self.judged:
            self.judge(record, key, value, number)
        else:
            self.say(record.file, number, f"{key}: is no field{nearest(key, KEYS)}")

    def judge(self, record, key, value, number):
        more = key == "more"
        if more:
            key, _, value = value.partition(" ")
        words = value.split()
        kind = "agree" if key == "agree" else words.pop(0) if words else ""
        if kind not in JUDGES or key != ("agree" if kind == "agree" else "by"):
            self.say(record.file, number, f"{key}: {kind or 'nothing'} is no judge"
                     + nearest(kind, JUDGES))
            return
        if kind == "bench" and "case" in words:
            kind = "case"
        judge = Judge(kind, tuple(words), more, number)
        if (kind, judge.words) in [(other.kind, other.words) for other in record.judges]:
            self.say(record.file, number, f"by: {judge} has the record already")
        record.judges.append(judge)
        why = self.unfit(judge)
        if why:
            self.say(record.file, number, f"by: {why}")

    def unfit(self, judge):
        """Why a judge cannot be; empty: it can."""
        kind, words = judge.kind, judge.words
        counts = {"top": (0, 3), "naive": (0, 0), "bench": (1, 1), "case": (3, 3)}
        least, most = counts.get(kind, (1, 1 if JUDGES[kind][0] not in ("core", "agree") else 99))
        if not least <= len(words) <= most:
            return f"{judge}: {len(words)} words behind it, not {least}" + (
                f" to {most}" if most > least else "")
        if kind in ("core", "textured", "piped", "agree"):
            there = os.path.exists(words[0]) or os.path.exists(words[0].rpartition(":")[0])
            return "" if there else f"there is no scene {words[0]}"
        if kind in ("bench", "case"):
            if kind == "case" and not self.number(words[2], self.known["cases"]):
                return f"{words[2]} is no named case, 1 to {self.known['cases']}"
            found = any(words[0] in name for name in self.known["bench"])
            return "" if found else f"there is no bench {words[0]}" + nearest(
                words[0], self.known["bench"])
        if kind == "hard":
            return "" if self.number(words[0], self.known["cases"]) else (
                f"{words[0]} is no named case, 1 to {self.known['cases']}")
        if kind == "top":
            fits = re.fullmatch("((64|128)( 1| [01] (16|64))?)?", " ".join(words))
            return "" if fits else f"{judge}: WIDTH is 64 or 128, LAYERS is 1, TREES 16 or 64"
        if kind in self.known and words[0] not in self.known[kind]:
            return f"there is no {kind} {words[0]}" + nearest(words[0], self.known[kind])
        return ""

    @staticmethod
    def number(word, most):
        return re.fullmatch("[1-9][0-9]*", word) and int(word) <= most

    def whole(self, record, names, texts):
        """Checks a record for itself and beside those before it."""
        def say(line, what):
            self.say(record.file, line, what)
        if not re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", record.name):
            say(record.line, f"fault: {record.name}: not of small letters, digits and hyphens")
        if record.name in names:
            say(record.line, f"fault: {record.name} stands in {names[record.name]}, too")
        names[record.name] = f"{record.file}:{record.line}"
        for what in ("rule", "edits", "judges")[:3 if self.judged else 2]:
            if not getattr(record, what):
                say(record.line, f"fault: {record.name} has no " + {
                    "edits": "model, rtl or formal", "judges": "by"}.get(what, what))
        for judge in record.judges:
            sides = {edit.side for edit in record.side(judge)}
            asked = set(JUDGES[judge.kind][1].split())
            if judge.kind == "naive" and not record.agree():
                say(judge.line, "by: naive: draws the scene of an agree, which there is not")
            elif "model" in asked and any(edit.side == "model" and edit.file[-2:] != ".c"
                                          for edit in record.side(judge)):
                say(judge.line, f"by: {judge}: links one file of the model, no header")
            elif not sides or asked - sides:
                say(judge.line, f"by: {judge}: the record edits nothing that it sees: "
                    + (" and ".join(sorted(asked - sides)) or proof_side(judge.words[0])))
        if record.agree() and not record.oracle():
            say(record.agree().line, "agree: needs a by naive or by hard")
        for edit in record.edits:
            if not os.path.isfile(edit.path):
                say(edit.line, f"{edit.side}: there is no {edit.path}" + nearest(
                    edit.path, glob.glob(f"{FOLDERS[edit.side]}/*/*")))
            elif not edit.old:
                say(edit.line, f"{edit.side}: {edit.file} has no from")
            else:
                self.fits(record, edit, texts)

    def fits(self, record, edit, texts):
        try:
            text = " ".join(planted([edit])[edit.path].split())
        except Refused as why:
            self.say(record.file, edit.line, str(why))
            return
        other = texts.setdefault((edit.path, text), record.name)
        if other != record.name:
            self.say(record.file, edit.line,
                     f"{edit.side}: is edited as in {other}: one record has both judges")


def read(names=(), judged=True):
    """All records, or those of some files; raises Refused with what is wrong in them. Without
    `judged` they name nobody who must notice them."""
    reader, known, texts = Reader(judged), {}, {}
    for name in sorted(names or glob.glob(LISTS)):
        reader.read(name)
    for record in reader.records:
        reader.whole(record, known, texts)
    if not reader.records:
        reader.wrong.append(f"{LISTS}: no record")
    if reader.wrong:
        raise Refused("\n".join(reader.wrong))
    return reader.records
