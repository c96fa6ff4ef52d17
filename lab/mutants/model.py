# model.py - faults in the arithmetic of the golden model, and what notices them
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.mutants.model BUILD COUNT SEED MINUTES [COMPILER OPTION...]

An operator or number of a file of cmodel/ becomes another one (EDITS): COUNT of all these places,
drawn by SEED, as many as are begun within MINUTES. The file is compiled and linked in front of the
library's own, into one suite of tests/ after the other, those of its folder first, until one fails,
hangs or crashes. What compiles to the same instructions is no fault. JOBS are tried at once."""
import glob
import os
import random
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

from ..jobs import store

FOLDERS = ("math", "pixel", "prim", "shade", "texture", "trace")    # of cmodel/
BELOW = {"math": "shade prim trace core", "pixel": "core", "prim": "trace core",
         "shade": "core reference", "texture": "core reference",
         "trace": "builder machine core prim"}
EDITS = ((r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" << ", " >> "), (r" >> ", " << "),
         (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "),
         (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "), (r" & ", " | "),
         (r" \| ", " & "), (r"(?<=[ (,])-(?=[a-z(])", ""), (r"(?<=[ (])!(?=[a-z(])", ""),
         (r"(?<=[ (\[])(\d+)(?=[;,) \]])", None), (r" \+= ", " -= "), (r" -= ", " += "))
SECONDS = 100   # of a processor, for a suite: longer is a hang


def places():
    """[(file, offset, length, text that comes there)], but for comments and what is not code."""
    found = []
    for name in sorted(n for f in FOLDERS for n in glob.glob(f"cmodel/{f}/*.c")):
        with open(name, encoding="utf-8") as f:
            text = f.read()
        if re.search(r"gen_|_build|_scene|build\.c|scene\.c", name):
            continue        # programs that make tables, and the builder's part of a kind
        code = re.sub(r'/\*.*?\*/|//[^\n]*|^#[^\n]*|"[^"\n]*"', lambda m: " " * len(m[0]), text,
                      flags=re.S | re.M)
        for pattern, to in EDITS:
            for m in re.finditer(pattern, code):
                found.append((name, m.start(), len(m[0]),
                              str(int(m[0]) + 1) if to is None else to))
    return sorted(found)


def suites(build, name):
    """Programs that are tried for a file, the nearest first."""
    folder, stem = name.split("/")[1], os.path.basename(name)[:-2]
    folders = [folder, *BELOW[folder].split()]
    found = [os.path.basename(t)[:-2] for f in folders for t in sorted(glob.glob(f"tests/{f}/*.c"))
             if os.path.basename(t).startswith("test_")]
    found.sort(key=lambda t: stem not in t)
    return [t for t in dict.fromkeys(found) if os.path.exists(f"{build}/test/{t}.o")]


class Trial:
    def __init__(self, build, compiler):
        self.build, self.compiler, self.sound = build, compiler, {}
        self.linker = [w for w in compiler if not w.startswith("-")][-1]  # behind a ccache
        self.libraries = subprocess.run(
            ["pkg-config", "--libs", "cmocka", "expat", "gmp", "mpfr"], check=True, text=True,
            stdout=subprocess.PIPE).stdout.split()

    def compiled(self, folder, name, text):
        """The object file of a text in place of a file, and its instructions; None: none."""
        source, made = f"{folder}/{os.path.basename(name)}", f"{folder}/fault.o"
        with open(source, "w", encoding="utf-8") as f:
            f.write(text)
        ran = subprocess.run([*self.compiler, "-w", "-Icmodel", f"-I{os.path.dirname(name)}", "-O1",
                              "-g0", "-c", source, "-o", made], check=False,
                             stderr=subprocess.DEVNULL)
        if ran.returncode:
            return None, b""
        return made, subprocess.run(["objdump", "-d", "-s", made], check=True,
                                    stdout=subprocess.PIPE).stdout

    def run(self, folder, suite, objects):
        """Whether a suite passes with these objects in front of the library."""
        program = f"{folder}/{suite}"
        subprocess.run([self.linker, "-fopenmp", f"{self.build}/test/{suite}.o", *objects,
                        f"{self.build}/libsphaera.a", *self.libraries, "-lm", "-o",
                        program], check=True)
        return subprocess.run(
            [program], check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS)),
            env={**os.environ, "BUILD": self.build}).returncode == 0

    def passes(self, suite):
        """Whether it passes as it is; what does not is not asked."""
        if suite not in self.sound:
            with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
                self.sound[suite] = self.run(folder, suite, [])
            if not self.sound[suite]:
                print(f"{suite} fails without a fault")
        return self.sound[suite]

    def verdict(self, name, at, length, to):
        """(verdict, suite)"""
        with open(name, encoding="utf-8") as f:
            text = f.read()
        with tempfile.TemporaryDirectory(prefix="sphaera-fault-") as folder:
            whole, sound = self.compiled(folder, name, text)
            if whole is None:
                sys.exit(f"mutants: {name} does not compile")
            made, code = self.compiled(folder, name, text[:at] + to + text[at + length:])
            if made is None or code == sound:
                return "none", "-"
            for suite in suites(self.build, name):
                if self.passes(suite) and not self.run(folder, suite, [made]):
                    return "killed", suite
        return "left", "-"


def main(build, count, seed, minutes, *compiler):
    found, rows, done = places(), [], 0
    chosen = random.Random(int(seed)).sample(found, min(int(count), len(found)))
    trial = Trial(build, list(compiler) or ["gcc", "-std=c11"])
    end = time.time() + 60 * int(minutes)

    def one(place_of):
        return trial.verdict(*place_of) if time.time() < end else None

    with ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        for (name, at, length, to), result in zip(chosen, pool.map(one, chosen)):
            done += result is not None
            if result is None or result[0] == "none":
                continue
            with open(name, encoding="utf-8") as f:
                text = f.read()
            line, start = text.count("\n", 0, at) + 1, text.rfind("\n", 0, at)
            rows.append([f"{name[7:]}:{line}.{at - start}",
                         f"{text[at:at + length].strip()} to {to.strip() or 'nothing'}", *result])
            print(*rows[-1], flush=True)
    told(sorted(rows), seed, len(found), done)


def told(rows, seed, found, done):
    """How many were noticed in each folder."""
    counts = Counter((row[0].split("/")[0], row[2]) for row in rows)
    for folder in (*FOLDERS, "all"):
        killed, left = (sum(n for (f, v), n in counts.items() if v == verdict
                            and folder in (f, "all")) for verdict in ("killed", "left"))
        if killed + left:
            print(f"{folder}: {killed} of {killed + left} killed")
    print(f"seed {seed}, {done} of {found} places, cmodel {store.digest(['cmodel/*/*.[ch]'])[:8]}")


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
