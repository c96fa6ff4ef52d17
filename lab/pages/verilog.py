# verilog.py - parameters and ports of the modules, with their comments
# SPDX-License-Identifier: Apache-2.0
"""A header is `module NAME #( parameters ) ( ports );`, a parameter or port on a line, a comment
behind it. A comment on lines of its own is the heading of what follows; one that is indented as far
as the comments is the rest of the comment above it."""
import re
from collections import namedtuple
from pathlib import Path

Item = namedtuple("Item", "name bits default comment heading")  # bits of a port, or default
PARAMETER = re.compile(r"parameter\s+(?:\[[^]]*\]\s*)?(?P<name>\w+)\s*=\s*(?P<default>[^,]+?),?$")
PORT = re.compile(r"(?P<way>input|output)\s+(?:wire|reg)?\s*(?P<signed>signed)?\s*"
                  r"(?P<range>\[.*\])?\s*(?P<name>\w+)\s*,?$")


HEAD = 3        # lines of a generated file above what it has


class Bad(Exception):
    """A header that cannot be read: file, line, text."""


def defines():
    """Macros of rtl/ that are numbers."""
    found = {}
    for path in Path("rtl").rglob("*.vh"):
        for name, value in re.findall(r"^`define (\w+) (\d+)$", path.read_text(), re.M):
            found[name] = value
    return found


def files():
    """{module: file}"""
    return {path.stem: path for path in sorted(Path("rtl").rglob("*.v"))}


def tidy(expression, macros):
    """2*W+WD-1 as a reader writes it: 2W+WD-1; macros that are numbers, and products of numbers,
    by their value."""
    text = re.sub(r"`(\w+)", lambda m: macros.get(m[1], m[1]), expression).strip()
    text = re.sub(r"RT_(\w+)_BITS", lambda m: "bundle " + m[1].lower(), text)
    text = text.replace("$clog2(SLOTS)", "SLOTW")
    text = re.sub(r"\b(\d+)\s*\*\s*(\d+)\b", lambda m: str(int(m[1]) * int(m[2])), text)
    return re.sub(r"(?<=\w)\s*\*\s*(?=[\w(])", lambda m: "" if text[m.start() - 1].isdigit()
                  else "*", text)


def bits(span, macros):
    """The number of bits of a range [N-1:0]."""
    if not span:
        return "1"
    high, low = span[1:-1].rsplit(":", 1)
    text = tidy(high, macros)
    if low.strip() == "0":
        if text.isdigit():
            return str(int(text) + 1)
        end = re.search(r"\s*([+-])\s*(\d+)$", text)
        if not end:
            return text + "+1"
        rest = int(end[1] + end[2]) + 1
        text = text[:end.start()] + (f"{rest:+d}" if rest else "")
        whole = re.fullmatch(r"\(([^()]*)\)", text)
        return whole[1] if whole else text
    return f"{text}:{low}"


def lines(path):
    """(file, number, text) of each line; an `include within a list of parameters is that file.
    Lines of make layout that tell a bundle's fields, are left out."""
    for number, line in enumerate(Path(path).read_text().splitlines(), 1):
        include = re.match(r'\s+`include "(\w+\.vh)"$', line)
        if include:
            yield from list(lines(next(Path("rtl").rglob(include[1]))))[HEAD:]
        elif not line.startswith("    //: "):
            yield path, number, line


def header(path, macros):
    """(parameters, ports) of the module of a file, in their order."""
    lists, into, heading, column, above = ([], []), None, "", 0, False
    for where, number, line in lines(path):
        code, _, comment = (part.strip() for part in line.partition("//"))
        if into is None:
            if re.match(r"module\s", code):
                into = 0 if "#" in code else 1
            continue
        if code == ") (":
            into, heading = 1, ""
        elif code == ");":
            return lists
        elif not code and comment and lists[into] and column and line.index("//") >= column > 8:
            last = lists[into].pop()
            lists[into].append(last._replace(comment=f"{last.comment} {comment}"))
        elif not code and comment:
            heading, above = f"{heading} {comment}" if above else comment, True
            continue
        elif code and not code.startswith("`"):
            match = (PARAMETER, PORT)[into].match(code)
            if not match:
                raise Bad(f"{where}:{number}: neither a parameter nor a port: {code}")
            column = line.index("//") if comment else 0
            group = match.groupdict()
            value = tidy(group["default"], macros) if into == 0 else ""
            size = "" if into == 0 else bits(group["range"], macros)
            if into == 1 and group["signed"]:
                size = "s" + (size if re.fullmatch(r"\w+", size) else f"({size})")
            comment = re.sub(r"`(\w+)", lambda m: macros.get(m[1], m[0]), comment)
            lists[into].append(Item(group["name"], size, value, comment, heading))
        above = False
    raise Bad(f"{path}: no module header that ends with `);`")
