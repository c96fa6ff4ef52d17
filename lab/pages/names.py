# names.py - what comments and pages name must exist: files, modules, functions, targets, variables
# SPDX-License-Identifier: Apache-2.0
"""Each rule takes the text of a comment or page and yields (position, name, what it should be)."""
import re
import subprocess
from functools import lru_cache
from pathlib import Path

from .. import table
from . import measured

TOPS = ("cmodel", "docs", "formal", "lab", "make", "rtl", "scenes", "sim", "synth", "tb", "tests")
COMMENTS = {
    (".v", ".vh", ".c", ".h", ".cpp", ".vlt"): re.compile(r"//[^\n]*|/\*.*?\*/", re.S),
    (".sh", ".mk", ".awk", ".txt", ".def", "Makefile"): re.compile(r"(?<!\S)#[^\n]*"),
    (".py",): re.compile(r'(?<!\S)#[^\n]*|""".*?"""', re.S),
    (".md",): re.compile(r".*", re.S),
}
# a word in capitals, a star or a digit to fill in stands for many names
OPEN = re.compile(r"[*<>{}$%]|(?<![A-Za-z0-9])[A-Z][A-Z_0-9]*(?![a-z])|\.\.\.")
ENDINGS = r"(?:v|vh|vlt|c|h|cpp|sh|mk|awk|py|def)"


@lru_cache(maxsize=None)
def files():
    """Every file of the tree, as git has them, or as they lie there without git."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listed.returncode == 0 and listed.stdout:
        paths = [Path(line) for line in listed.stdout.decode().splitlines()]
    else:
        paths = [path for top in TOPS for path in Path(top).rglob("*")] + list(Path().glob("*"))
    return [path for path in paths if path.is_file()]


@lru_cache(maxsize=None)
def basenames():
    return {path.name for path in files()}


@lru_cache(maxsize=None)
def code(path):
    """A file without its comments."""
    text = path.read_text(encoding="utf-8", errors="replace")
    for endings, pattern in COMMENTS.items():
        if path.name.endswith(endings):
            return pattern.sub(" ", text)
    return text


@lru_cache(maxsize=None)
def words(*endings):
    """All words of the code of the files with these endings."""
    found = set()
    for path in files():
        if path.name.endswith(endings):
            found.update(re.findall(r"\w+", code(path)))
    return found


@lru_cache(maxsize=None)
def begins(name, *endings):
    """Does a word of them begin like this?"""
    return any(word.startswith(name) for word in words(*endings))


@lru_cache(maxsize=None)
def included():
    """Headers of the system."""
    return {name for path in files() if path.name.endswith((".c", ".h", ".cpp"))
            for name in re.findall(r"#include <([\w.]+)>", code(path))}


@lru_cache(maxsize=None)
def exists(name, folder):
    """A path from the root, from cmodel or from a folder; a star stands for what there is."""
    roots = [Path(), Path("cmodel"), folder]
    return any(any(root.glob(name)) if "*" in name else (root / name).exists() for root in roots)


@lru_cache(maxsize=None)
def makefiles():
    return "\n".join(path.read_text() for path in files()
                     if path.suffix == ".mk" or path.name == "Makefile")


@lru_cache(maxsize=None)
def targets():
    found = {row.name for row in table.EXPERIMENTS}
    for line in re.findall(r"^([a-z][\w -]*):(?!=)", makefiles(), re.M):
        found.update(line.split())
    return found


@lru_cache(maxsize=None)
def functions(path):
    """Names that a C file defines or declares at the left margin."""
    return set(re.findall(r"^[a-z][\w *]*[ *](\w+)\(", code(path), re.M))


@lru_cache(maxsize=None)
def stems():
    return {path.stem for path in files()} | {path.parent.name for path in files()}


def paths(text, page):
    """A path from the root, from cmodel, or from the page."""
    for match in re.finditer(r"(?<![\w/.$(){}@:-])((?:\.\./)*(?:[\w.-]+/)+[\w.*-]*)", text):
        name = match[1].rstrip(".")
        top = name.split("/")[0]
        if OPEN.search(name.replace("*", "")) or top not in TOPS + ("..",):
            continue
        if re.search(r"https?:\S*$", text[:match.start()]):
            continue
        if not exists(name, page.parent):
            yield match.start(), name, "a file or folder"


def plain_files(text, page):
    """A file name without its folder."""
    del page
    pattern = rf"(?<![\w/.*$){{}}@<-])([A-Za-z][\w-]+\.{ENDINGS})(?![\w/*.(])"
    for match in re.finditer(pattern, text):
        if not OPEN.search(match[1]) and match[1] not in basenames() | included():
            yield match.start(), match[1], "a file"


def modules(text, page):
    del page
    for match in re.finditer(r"\brt_[a-z0-9_]+\b(?!\.)", text):
        name = match[0]
        if name in words(".v", ".vh") or name + ".vh" in basenames():
            continue
        if not (name.endswith("_") and begins(name, ".v", ".vh")):
            yield match.start(), name, "a module or function of rtl/"


def signals(text, page):
    """Ports and registers; of a bench's or a proof's own, in their own files."""
    if page.suffix not in (".v", ".md"):
        return
    pattern = r"\b[a-z]\w*_[ioq]\b" if page.suffix == ".v" else r"(?<=`)[a-z]\w*_[ioq](?=`)"
    for match in re.finditer(pattern, text):
        if match[0] not in words(".v", ".vh"):
            yield match.start(), match[0], "a port or register"


def c_functions(text, page):
    del page
    for match in re.finditer(r"\bsph_[a-z0-9_]+\b", text):
        name = match[0]
        if name not in words(".c", ".h") and not (name.endswith("_")
                                                  and begins(name, ".c", ".h")):
            yield match.start(), name, "a name of cmodel/"


def model_lines(text, page):
    """f(), g() in FILE; in a page also `f`, `g`, `FILE`."""
    del page
    told = re.compile(r"((?:`?\w+\(\)`?(?:,| and| in)?\s+(?://\s+)?)+)`?([\w/]+\.[ch])\b"
                      r"|((?:`\w+(?:\(\))?`, )+)`([\w/]+\.[ch])`")
    for match in told.finditer(text):
        name = match[2] or match[4]
        path = next((p for p in (Path(name), Path("cmodel") / name) if p.is_file()), None)
        for function in re.findall(r"\w+", match[1] or match[3]) if path else ():
            if function not in ("and", "in") and function not in functions(path):
                yield match.start(), f"{function}() in {name}", "a function of that file"


def benches(text, page):
    del page
    for match in re.finditer(r"(?<![\w/.])(tb|test)_[a-z0-9_]+\b(?!\.)", text):
        name = match[0]
        if not any(stem.startswith(name) for stem in stems()) and name not in words(
                ".v", ".cpp", ".c", ".h", ".mk", ".sh"):
            yield match.start(), name, "a bench or test"


def commands(text, page):
    """make TARGET VARIABLE=value, in a line of its own or between backquotes."""
    margin = r"^(?: {4}|## |# +|usage: )" if page.suffix == ".md" else r"^# {2,}"
    for match in re.finditer(rf"(?:{margin}|`)make((?: [\w=:.,/+*-]+)*)", text, re.M):
        for word in match[1].split():
            name, equals, _ = word.partition("=")
            if equals:
                if not re.search(rf"\b{name}\b", makefiles()) and name not in words(".sh"):
                    yield match.start(), word, "a variable of make"
            elif re.fullmatch(r"[a-z][a-z-]*", word) and word not in targets():
                yield match.start(), f"make {word}", "a target of make"
        only = re.search(r"ONLY=(\w+)", match[1])
        if only and not only[1].isupper() and not any(
                only[1] in name for name in basenames() if name.startswith("test_")):
            yield match.start(), only[0], "a test"


def of_lab(text, page):
    """python3 -m lab COMMAND."""
    del page
    for match in re.finditer(r"python3 -m lab ([a-z][a-z-]*)", text):
        if match[1] not in table.COMMANDS and match[1] not in targets():
            yield match.start(), match[0], "a command of lab/table.py"


def tools(text, page):
    """build/sphaera COMMAND."""
    del page
    for match in re.finditer(r"(?:`| {4})build/sphaera ([a-z]+)\b", text):
        if f"tool_{match[1]}" not in words(".c"):
            yield match.start(), match[0], "a command of the tool"


def links(text, page):
    """Links of a page, with the headings that they point at."""
    if page.suffix != ".md":
        return
    for match in re.finditer(r"\]\(([^)#:\s]*)(?:#([\w-]+))?\)", text):
        to = page.parent / match[1] if match[1] else page
        if not to.exists():
            yield match.start(), match[1], "a file beside this page"
        elif match[2] and to.suffix == ".md":
            heads = re.findall(r"^#+ (.*)$", to.read_text(encoding="utf-8"), re.M)
            anchors = {re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in heads}
            if match[2] not in anchors:
                yield match.start(), f"{match[1]}#{match[2]}", "a heading"


RULES = (paths, plain_files, modules, signals, c_functions, model_lines, benches, commands, of_lab,
         tools, links)


def comments(path):
    """(position, text) of the comments of a file; a page is all comment, but for its measured
    tables, which tell of the sources that they were measured with."""
    for endings, pattern in COMMENTS.items():
        if path.name.endswith(endings):
            text = path.read_text(encoding="utf-8", errors="replace")
            if path.suffix == ".md":
                text = measured.TABLE.sub(lambda table: re.sub(r"[^\n]", " ", table[0]), text)
            return text, [(match.start(), match[0]) for match in pattern.finditer(text) if match[0]]
    return "", []


def wrong(path):
    """(line, name, what it should be) of each name in a file that is not there."""
    text, parts = comments(path)
    found = []
    for start, part in parts:
        for rule in RULES:
            for position, name, what in rule(part, path):
                found.append((text.count("\n", 0, start + position) + 1, name, what))
    return sorted(set(found))


def main(*chosen):
    bad = 0
    for path in [Path(name) for name in chosen] or files():
        for line, name, what in wrong(path):
            print(f"{path}:{line}: {name} is not {what}")
            bad += 1
    return bad > 0
