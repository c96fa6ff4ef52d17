# model.py - faults in the arithmetic of the golden model, and what notices them
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab mutants-c BUILD COUNT SEED MINUTES [COMPILER OPTION...]

An operator or number of a file of cmodel/ becomes another one (EDITS): COUNT of all these places,
drawn by SEED, as many as are begun within MINUTES; an edit elsewhere leaves the draw as it is. The
file is compiled and linked in front of the library's own, into one suite of tests/ after the other
until one fails, hangs or crashes: those of its name first, then the quickest, of those that gcov
says run its line and that take at most LONGEST seconds. What all of them let pass the quick ones
try once more under the sanitizers, as `make test` does. What compiles to the same instructions is
no fault. JOBS are tried at once. A kill is kept as long as the model and the suite that it fell to
stay, what is left as long as all suites do. survivors_c.py beside this tries in one suite those
that the page lists as left."""
import functools
import glob
import hashlib
import json
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from ... import intact
from ...benches import Broken
from ...jobs import store
from ...pages import data, place
from .. import programs
from . import equivalent

FOLDERS = ("core", "engine", "fast", "machine", "math", "pixel", "prim", "render", "shade",
           "texture", "trace", "validate")      # of cmodel/
PAGE = "docs/results/verification.md"
EDITS = ((r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" << ", " >> "), (r" >> ", " << "),
         (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "),
         (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "), (r" & ", " | "),
         (r" \| ", " & "), (r"(?<=[ (,])-(?=[a-z(])", ""), (r"(?<=[ (])!(?=[a-z(])", ""),
         (r"(?<=[ (\[])(\d+)(?=[;,) \]])", None), (r" \+= ", " -= "), (r" -= ", " += "))
TESTS = "builder core fast machine math pixel prim reference shade texture trace".split()
MORE = ("test_library",)     # suites that are linked with more than the model
LONGEST = float(os.environ.get("LONGEST", "40"))    # seconds of a suite that is tried at all
QUICK = 3                   # and of one that is tried once more under the sanitizers
PATIENCE, SLACK = 2, 2      # a suite may take PATIENCE times what it takes without one, and SLACK
MODEL = ["cmodel/**/*.[ch]", "tests/*.h"]


@functools.cache
def source(name):
    with open(name, encoding="utf-8") as f:
        return f.read()


def places():
    """[(file, offset, length, text that comes there)], but for comments and what is not code."""
    found = []
    for name in sorted(n for f in FOLDERS for n in glob.glob(f"cmodel/{f}/*.c")):
        text = source(name)
        if re.search(r"gen_|_neon", name):
            continue        # makes a table; nothing on this machine
        code = re.sub(r'/\*.*?\*/|//[^\n]*|^#[^\n]*|"[^"\n]*"', lambda m: " " * len(m[0]), text,
                      flags=re.S | re.M)
        for pattern, to in EDITS:
            for m in re.finditer(pattern, code):
                found.append((name, m.start(), len(m[0]),
                              str(int(m[0]) + 1) if to is None else to))
    return sorted(found)


@functools.cache
def sources(suite):
    """Digest of a suite's own sources."""
    return store.digest(["tests/hard/*.c"] if suite in programs.HARD else [f"tests/*/{suite}.c"])


def suites(build):
    """Programs of tests."""
    found = [os.path.basename(n)[:-2] for t in TESTS for n in sorted(glob.glob(f"tests/{t}/*.c"))]
    return [t for t in found if t.startswith("test_") and t not in MORE
            and os.path.exists(f"{build}/test/{t}.o")] + (
        list(programs.HARD) if os.path.exists(f"{build}/test/hard") else [])


class Trial:
    def __init__(self, build, compiler, survey=True):
        self.build, self.compiler = build, compiler
        self.linker = [w for w in compiler if not w.startswith("-")][-1]  # behind a ccache
        self.suites = self.survey() if survey else {}

    def compiled(self, folder, name, text, how=("-O1",)):
        """The object file of a text in place of a file, and its instructions; None: none."""
        try:
            made = programs.compiled(folder, name, text, how, self.compiler)
        except Broken:
            return None, b""
        return made, subprocess.run(["objdump", "-d", "-s", made], check=True,
                                    stdout=subprocess.PIPE).stdout

    def link(self, folder, suite, objects, sanitized=False):
        return programs.link(self.build, folder, suite, objects, sanitized, self.linker)

    def run(self, program, seconds):
        """What a suite returns; 0 if it passes within so many seconds of a processor."""
        return subprocess.run(
            [program, *programs.HARD.get(os.path.basename(program), [])], check=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds)),
            env={**os.environ, "BUILD": self.build}).returncode

    def survey(self):
        """{suite: [seconds, {file: [[line, whether it runs]]}]} of the suites that pass and are no
        longer than LONGEST. Kept until the model or the suite changes."""
        cache, digest, found = f"{self.build}/mutants/suites.json", store.digest(MODEL), {}
        if os.path.exists(cache):
            with open(cache, encoding="utf-8") as f:
                kept = json.load(f)
            if kept["digest"] == [digest, LONGEST]:
                found = kept["suites"]
        wanted = {s: sources(s) for s in suites(self.build)}
        found = {s: seen for s, seen in found.items() if seen[2] == wanted.get(s)}
        if len(found) < len(wanted):
            print("running suites once, with gcov", flush=True)
        with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
            objects = []
            for name in sorted({n for n, *_ in places()} if len(found) < len(wanted) else ()):
                objects.append(f"{folder}/{name[7:-2].replace('/', '-')}.o")
                subprocess.run([*self.compiler, "-w", *programs.options(name), "-O1",
                                "--coverage", "-c", name, "-o", objects[-1]], check=True)
            for suite in wanted:
                if suite in found:
                    continue
                program = self.link(folder, suite, objects)
                began = os.times()
                failed = self.run(program, int(LONGEST) + 1)
                now = os.times()
                seconds = now.children_user + now.children_system - (
                    began.children_user + began.children_system)
                counts = glob.glob(f"{folder}/*.gcda")
                found[suite] = [round(seconds, 2), {} if failed else self.lines(counts),
                                wanted[suite]]
                if failed and seconds < LONGEST:
                    print(f"{suite} fails without a fault")
                for name in counts + [program]:
                    os.remove(name)
        os.makedirs(os.path.dirname(cache), exist_ok=True)
        with open(cache, "w", encoding="utf-8") as f:
            json.dump({"digest": [digest, LONGEST], "suites": found}, f)
        return found

    @staticmethod
    def lines(counts):
        """{file: [[line, 1 if it ran]]}"""
        told = subprocess.run(["gcov", "--json-format", "--stdout", *counts], check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
        found = {}
        for text in told.splitlines():
            for file in json.loads(text)["files"]:
                if file["file"].endswith(".c"):
                    ran = {}
                    for line in file["lines"]:
                        ran[line["line_number"]] = ran.get(line["line_number"], 0) | (
                            line["count"] > 0)
                    found[file["file"]] = sorted([n, int(r)] for n, r in ran.items())
        return found

    def near(self, name, line):
        """Suites that run a line of a file, in the order in which they are tried."""
        (folder, stem), found = os.path.split(name[7:-2]), []
        for suite, (seconds, files, _) in self.suites.items():
            lines = files.get(name)
            if not lines:
                continue
            before = [ran for number, ran in lines if number <= line] or (
                [any(ran for _, ran in lines)])     # a constant above all functions
            if before[-1] and seconds <= LONGEST:
                found.append((stem not in suite and folder not in suite, seconds, suite))
        return [suite for *_, suite in sorted(found)]

    def verdict(self, name, at, length, to, first=None):
        """(verdict, suite, digest of its sources or of all); `first`: the suite to begin with"""
        text = source(name)
        fault = text[:at] + to + text[at + length:]
        with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
            whole, sound = self.compiled(folder, name, text)
            if whole is None:
                sys.exit(f"mutants: {name} does not compile")
            made, code = self.compiled(folder, name, fault)
            if made is None or code == sound:
                return "none", "-", ""
            tried = self.near(name, text.count("\n", 0, at) + 1)
            tried.sort(key=lambda suite: suite != first)
            for suite in tried:
                program = self.link(folder, suite, [made])
                if self.run(program, int(PATIENCE * self.suites[suite][0] + SLACK)):
                    return "killed", suite, sources(suite)
                os.remove(program)
            made, _ = self.compiled(folder, name, fault, programs.SANITIZE)
            for suite in tried:
                if suite in programs.HARD or self.suites[suite][0] > QUICK:
                    continue
                program = self.link(folder, suite, [made], True)
                # too long is no answer here: without sanitizers it was in time
                if self.run(program, 10 * QUICK) not in (0, -9, -24):
                    return "killed", suite + " sanitized", sources(suite)
                os.remove(program)
        return "left", f"{len(tried)} suites", "".join(sorted(map(sources, tried)))


def name_of(name, at, length, to):
    """A fault's name: file, the line as it stands, what becomes of the place, which one of them;
    which of equal lines, but for the first."""
    text = source(name)
    start = text.rfind("\n", 0, at) + 1
    line = text[start:text.index("\n", at)]
    old = text[at:at + length]
    nth = line[:at - start].count(old) + 1
    same = [" ".join(other.split()) for other in text[:start].splitlines()].count(
        " ".join(line.split()))
    return (f"{name[7:]}: {' '.join(line.split())}: {old.strip()} to "
            f"{to.strip() or 'nothing'} {nth}" + (f" of line {same + 1}" if same else ""))


def drawn(found, count, seed):
    """COUNT places: those with the smallest digests of their names and the seed."""
    def rank(place_of):
        return hashlib.sha256(f"{seed} {name_of(*place_of)}".encode()).hexdigest()
    return sorted(found, key=rank)[:count]


def main(build, count, seed, minutes, *compiler):
    found, kept = places(), f"{build}/mutants/model.json"
    chosen = drawn(found, int(count), seed)
    trial = Trial(build, list(compiler) or ["gcc", "-std=c11"])
    end, done = time.time() + 60 * int(minutes), {"digest": store.digest(MODEL), "tried": {}}
    hints = {row[0]: row[2].split()[0] for row in data.read("verification.model_faults")[1]}
    if os.path.exists(kept):
        with open(kept, encoding="utf-8") as f:
            before = json.load(f)
        hints.update({name: was[1].split()[0] for name, was in before["tried"].items()})
        if before["digest"] == done["digest"]:
            done = before

    def valid(place_of):
        verdict, suite, digest = done["tried"].get(name_of(*place_of), ("", "", ""))
        name, at, *_ = place_of
        if verdict == "left":
            return digest == "".join(sorted(
                map(sources, trial.near(name, source(name).count("\n", 0, at) + 1))))
        return verdict == "none" or verdict and digest == sources(suite.split()[0])

    def one(place_of):
        if valid(place_of) or time.time() > end:
            return None
        return trial.verdict(*place_of, hints.get(name_of(*place_of)))

    with ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        for place_of, result in zip(chosen, pool.map(one, chosen)):
            if result is None:
                continue
            done["tried"][name_of(*place_of)] = result
            intact.write(kept, json.dumps(done, indent=0))
            if result[0] != "none":
                print(*result[:2], name_of(*place_of), flush=True)
    tried = {name_of(*c): done["tried"][name_of(*c)] for c in chosen if valid(c)}
    told(tried, seed, len(found))


def told(tried, seed, found, none=0, rest=False):
    """The tables of the page; `none`: faults that are none, and not among those tried; rest: some
    verdicts alone are new."""
    known, counts, why, rows = equivalent.model(), Counter(), Counter(), []
    for name, (verdict, suite, *_) in sorted(tried.items()):
        if verdict == "left" and name in known:
            verdict, suite = "equivalent", known[name]
        if verdict == "equivalent":     # one whose place is gone by now keeps its reason
            why[suite] += 1
        counts[name.split("/")[0], verdict] += 1
        counts["**all**", verdict] += 1
        if verdict != "none":
            rows.append([name, verdict, suite])
    for name, verdict, suite in rows:
        if verdict == "left":
            print("left:", name, suite)
    table = []
    for folder in (*FOLDERS, "**all**"):
        killed, same, left = (counts[folder, v] for v in ("killed", "equivalent", "left"))
        if killed + same + left:
            table.append([folder, *map(str, (killed + same + left, killed, same, left)),
                          f"{100 * killed / max(1, killed + left):.1f}"])
            print(*table[-1])
    none += counts["**all**", "none"]
    run = [[seed, str(found), str(len(tried) - counts["**all**", "none"] + none), str(none),
            store.digest(["cmodel/**/*.[ch]"])[:8]]]
    place.place(PAGE, "make campaign-c", {
        "model_faults": [["fault", "verdict", "by"], *rows],
        "model": [["cmodel/", "faults", "killed", "equivalent", "left", "killed, %"], *table],
        "model_reasons": [["faults", "why nothing can notice them"],
                          *([str(n), w] for w, n in why.most_common())],
        "model_run": [["seed", "places", "tried", "same instructions", "digest of cmodel/"], *run]
    }, rest=rest)
