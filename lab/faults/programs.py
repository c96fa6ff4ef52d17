# programs.py - a file of the golden model with a fault, linked into a program that may notice it
# SPDX-License-Identifier: Apache-2.0
import glob
import os
import subprocess

from ..benches import Broken

COMPILER = ("gcc", "-std=c11", "-D_GNU_SOURCE")
SANITIZE = "-O1 -fsanitize=address,undefined -fno-sanitize-recover=all".split()
# The program `hard` as suites: its named cases, some generated ones.
HARD = {"hard_named": ["--named"], "hard_cases": ["--cases", "20000", "--exhaustive", "100"]}


def options(name):
    """What the compiler is told of one file, as make/objects.mk has it."""
    return ["-Icmodel", f"-I{os.path.dirname(name)}",
            *(["-mavx2"] if name.endswith("_avx2.c") else [])]


def compiled(folder, name, text, how=("-O1",), compiler=COMPILER):
    """The object file of a text in place of a file of the model."""
    written = f"{folder}/{os.path.basename(name)}"
    made = written[:-2] + ".o"
    with open(written, "w", encoding="utf-8") as f:
        f.write(text)
    ran = subprocess.run([*compiler, "-w", *options(name), *how, "-g0", "-c", written, "-o", made],
                         check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ran.returncode:
        raise Broken(f"{name} does not compile\n{ran.stdout}")
    return made


def own(build, suite, sanitized=False):
    """Object files of a suite itself."""
    if suite in HARD:
        sources = sorted(glob.glob("tests/hard/*.c"))
        return [*(f"{build}/test/obj/{name[:-2]}.o" for name in sources),
                f"{build}/obj/cmodel/tool/progress.o"]
    return [f"{build}/test/{suite}{'.sanitized' if sanitized else ''}.o"]


def libraries(found=[]):    # pylint: disable=dangerous-default-value
    if not found:
        found += subprocess.run(
            ["pkg-config", "--libs", "cmocka", "expat", "gmp", "jansson", "libpng", "mpfr", "zlib"],
            check=True, text=True, stdout=subprocess.PIPE).stdout.split()
    return found


def link(build, folder, suite, objects, sanitized=False, linker="gcc"):
    """A suite's program with these objects in front of the library."""
    program = f"{folder}/{suite}"
    library = f"{build}/{'asan/' if sanitized else ''}libsphaera.a"
    ran = subprocess.run([linker, *(SANITIZE if sanitized else ()), *own(build, suite, sanitized),
                          *objects, library, *libraries(), "-lm", "-lgcov", "-o", program],
                         check=False, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if ran.returncode:
        raise Broken(f"{suite} cannot be linked\n{ran.stdout}")
    return program
