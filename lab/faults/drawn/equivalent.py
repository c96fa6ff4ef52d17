# equivalent.py - drawn faults that nothing can notice, and why: tests/faults/equivalent
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab equivalents
Reads both lists and tells which entries match nothing in the sources, exit code 1."""
import fnmatch
import functools
import glob
import re
import sys

RTL = "tests/faults/equivalent/rtl.txt"
MODEL = "tests/faults/equivalent/model.txt"


def entries(name):
    """[(entry, reason, line)]: a reason stands above its entries, which are indented."""
    found, reason = [], []
    with open(name, encoding="utf-8") as f:
        for number, line in enumerate(f, 1):
            text = line.strip()
            if not text or line[0] == "#":
                continue
            if line[0] != " ":
                if found and found[-1][1] is reason:
                    reason = []
                reason.append(text)
            elif line.startswith("    ") and found and found[-1][1] is reason:
                found[-1][0] += " " + text
            elif reason:
                found.append([text, reason, number])
            else:
                sys.exit(f"{name}:{number}: no reason above {text}")
    return [(entry, " ".join(reason), number) for entry, reason, number in found]


@functools.cache
def source(module):
    """The lines of a module's file; none if there is no such module."""
    for name in glob.glob(f"rtl/*/{module}.v"):
        with open(name, encoding="utf-8") as f:
            return f.read().split("\n")
    return []


def joined(lines):
    return " ".join(" ".join(lines).split())


def region(module, where):
    """The text of a cell's place, `file:line.column-line.column`, or what stands there now."""
    at = re.fullmatch(r".*:(\d+)\.(\d+)-(\d+)\.(\d+)", where)
    if not at:
        return ""
    first, begin, last, end = map(int, at.groups())
    lines = source(module)[first - 1:last]
    if len(lines) != last - first + 1:
        return ""
    lines[-1] = lines[-1][:end - 1]
    lines[0] = lines[0][begin - 1:]
    return joined(lines)


@functools.cache
def listed():
    return [(*split(entry), reason, entry) for entry, reason, _ in entries(RTL)]


def rtl(name, moved=False):
    """(entry, reason) that a fault's name, `module file:lines cell#nth port.bit mode`, falls under,
    or None; moved: whatever stands in these lines now."""
    module, where, rest = name.split(" ", 2)
    text = region(module, where)
    for wanted, begin, pattern, reason, entry in listed():
        if wanted == module and fnmatch.fnmatchcase(rest, pattern) and (
                moved or begin == "*" or text.startswith(begin)):
            return entry, reason
    return None


def split(entry):
    """Module, how the text begins, pattern of the rest."""
    module, _, rest = entry.partition(": ")
    begin, _, pattern = rest.rpartition(": ")
    return module, begin, pattern


def model():
    """{fault: reason}"""
    return {entry: reason for entry, reason, _ in entries(MODEL)}


def unmatched():
    """What is wrong with entries: those that nothing in the sources can be meant by."""
    from .model import name_of, places
    wrong, known = [], {name_of(*place) for place in places()}
    for entry, _, number in entries(MODEL):
        if entry not in known:
            wrong.append(f"{MODEL}:{number}: cmodel/ has no such place: {entry}")
    for entry, _, number in entries(RTL):
        module, begin, pattern = split(entry)
        if not begin or not pattern or "#" not in pattern and pattern != "*":
            wrong.append(f"{RTL}:{number}: is not `module: text: cell#nth port.bit mode`: {entry}")
        elif not source(module):
            wrong.append(f"{RTL}:{number}: there is no module {module}")
        elif begin != "*" and begin not in joined(source(module)):
            wrong.append(f"{RTL}:{number}: {module} has no such text: {begin}")
    return wrong


def main():
    return "\n".join(unmatched()) or 0
