# suites.py - faults of C and Python chosen while a program runs, tried by suites of tests/
# SPDX-License-Identifier: Apache-2.0
"""A clone of the tree has all faults of C in it: a function's body stands there once more for each
edit, and the number in RT_FAULT selects one. A fault of Python is written into the clone while it
is tried."""
import filecmp
import glob
import os
import re
import shutil
import subprocess

from .. import intact
from ..benches import Broken, text_of
from . import records
from .records import place
from .selected import code, nested_braces

HEAD = '''#include <stdlib.h>
static int rt_fault_number(void) {
    static int number = -1;
    if (number < 0) number = getenv("RT_FAULT") ? atoi(getenv("RT_FAULT")) : 0;
    return number;
}
'''
# Suites of a folder of sources, where they are not all of that name.
NEAR = {"engine": "core/test_model* core/test_layers* core/test_frame*",
        "validate": "machine/test_machine* core/test_malformed* core/test_limits*",
        "driver": "machine/test_driver* top/test_top.sh", "scene": "scene/*.c",
        "pixel": "pixel/*.c", "prim": "prim/*.c",     # their scripts simulate cores
        "tool": "tool/test_[eimnortw]*"}
# and of a file of lab
LAB = {"synth": "test_budget", "clocks.py": "test_clocks", "jobs": "test_jobs",
       "pages": "test_pages", "price.py": "test_price_page", "summary.py": "test_summary"}
THROUGH = ("test_model.c", "test_limits.c", "test_model_effects.c", "test_model_optics.c",
          "test_fast.c", "test_tool.sh", "test_hashes.sh", "test_hashes_naive.sh")
PATIENCE = 600      # seconds of a suite


def near(record):
    """Suites that look at the edited file first."""
    edit = record.edits[0]
    folder, name = edit.path.split("/")[-2:]
    if edit.side == "lab":
        wanted = LAB.get(name) or LAB.get(folder)
        return [n for n in glob.glob("tests/*/test_*") if os.path.basename(n).startswith(wanted)]
    found = [n for w in NEAR.get(folder, f"{folder}/test_*").split()
             for n in sorted(glob.glob(f"tests/{w}")) if n.endswith((".c", ".sh"))]
    stem = name[:-2].removeprefix("cmd_").split("_")[0]
    found.sort(key=lambda n: (stem not in n, n.endswith(".sh")))
    return found


def made(text, faults):
    """The text of a file of C with all of {number: edits} in it."""
    clean, bodies = code(text), {}
    for number, edits in faults.items():
        for edit in edits:
            begin, end = place(text, edit.old)[0]
            body = next((b for b in nested_braces(clean) if b[0] < begin and end < b[1]), None)
            if not body or not clean[:body[0]].rstrip().endswith(")"):
                raise records.Refused(f"{edit.path}: lies in no function: {edit.old}")
            bodies.setdefault(body, {}).setdefault(number, []).append((begin, end, edit.new))
    for body in sorted(bodies, reverse=True):
        was, pieces = text[body[0]:body[1]], []
        for number, edits in bodies[body].items():
            now = was
            for begin, end, new in sorted(edits, reverse=True):
                now = now[:begin - body[0]] + new + now[end - body[0]:]
            pieces.append(f"if (rt_fault_number() == {number}) {now} else ")
        text = text[:body[0]] + "{ " + "".join(pieces) + was + " }" + text[body[1]:]
    return HEAD + text


def others():
    """Suites that go through all of the model."""
    return [n for name in THROUGH for n in glob.glob(f"tests/*/{name}")]


class Tree:
    """The clone, and what its suites say."""

    def __init__(self, build, found):
        self.folder = f"{build}/designed/tree"
        self.number = {record.name: n for n, record in enumerate(found, 1)}
        self.sound = {}
        if not os.path.exists(self.folder):
            subprocess.run(["git", "clone", "-q", ".", self.folder], check=True)
        by_file = {}
        for record in found:
            for edit in record.edits:
                if edit.path.endswith(".c"):
                    by_file.setdefault(edit.path, {}).setdefault(
                        self.number[record.name], []).append(edit)
        for path in subprocess.run(["git", "ls-files"], check=True, text=True,
                                   stdout=subprocess.PIPE).stdout.split("\n"):
            there = f"{self.folder}/{path}"
            if path in by_file:
                self.put(path, made(text_of(path), by_file[path]))
            elif os.path.isfile(path) and not (os.path.exists(there) and filecmp.cmp(path, there)):
                os.makedirs(os.path.dirname(there), exist_ok=True)
                shutil.copy(path, there)

    def put(self, path, text):
        name = f"{self.folder}/{path}"
        if os.path.exists(name) and text_of(name) == text:
            return False
        intact.write(name, text)
        return True

    def run(self, suite, number):
        """Whether it passes; without a fault it is built first."""
        seen = {k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")}
        name = os.path.basename(suite)
        program = f"build/test/{name.removesuffix('.c')}"
        command = ["sh", "tests/run.sh", suite if suite.endswith(".sh") else program]
        if not number:      # by its whole name: a script may be called as a program is
            command = ["sh", "-c", 'make -s test ONLY="$0"', name] if suite.endswith(".sh") else [
                "sh", "-c", 'make -s "$1" && "$0" "$2" "$1"', *command[:1], program, command[1]]
        ran = subprocess.run(
            command, cwd=self.folder, check=False, text=True, errors="replace",
            env={**seen, "RT_FAULT": str(number), "JOBS": "1", "BUILD": "build",
                 "SUITE_LIMIT": str(PATIENCE)},
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return ran.returncode == 0 and not re.search("^not ok", ran.stdout, re.M)

    def ask(self, record, suite):
        """The verdict of a suite that passes without a fault."""
        if self.put(suite, text_of(suite)) or suite not in self.sound:
            self.sound[suite] = self.run(suite, 0)
        if not self.sound[suite]:
            raise Broken(f"{suite}: fails without a fault")
        number, edit = self.number[record.name], record.edits[0]
        if edit.path.endswith(".c"):
            return "survived" if self.run(suite, number) else "killed"
        was = text_of(edit.path)
        self.put(edit.path, records.planted(record.edits)[edit.path])
        try:
            return "survived" if self.run(suite, number) else "killed"
        finally:
            self.put(edit.path, was)
