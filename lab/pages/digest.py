# digest.py - one short number for the sources that a figure depends on
# SPDX-License-Identifier: Apache-2.0
"""Comments, white space, folders, included headers' names and the unit of time, which no delay
uses, do not count: what they change is no figure. 8 hex digits of SHA-256."""
import hashlib
import re
from functools import lru_cache
from pathlib import Path

KINDS = {
    "rtl": ("rtl", (".v", ".vh")),
    "model": ("cmodel", (".c", ".h", ".cpp", ".def")),
    "scenes": ("scenes", (".nff", ".png")),
}
AROUND = {"board", "bus", "top", "video"}  # folders of rtl/ around the core: no figure of its own
COMMENT = {
    ".v": r"//[^\n]*|/\*.*?\*/|^`timescale[^\n]*", ".c": r"//[^\n]*|/\*.*?\*/|^#include[^\n]*",
    ".sh": r"(?m)^ *#.*$", ".def": r"#[^\n]*",
}
COMMENT.update({".vh": COMMENT[".v"], ".h": COMMENT[".c"], ".cpp": COMMENT[".c"],
                ".nff": COMMENT[".def"]})


@lru_cache(maxsize=None)
def of_file(path):
    """Of one file; its name counts."""
    data = path.read_bytes()
    if path.suffix in COMMENT:
        text = re.sub(COMMENT[path.suffix], " ", data.decode("utf-8"), flags=re.S | re.M)
        data = "".join(text.split()).encode()
    return hashlib.sha256(path.name.encode() + b"\0" + data).hexdigest()


def of_files(paths, more=""):
    """Of some files, and of a text."""
    each = sorted(of_file(Path(path)) for path in paths)
    return hashlib.sha256("".join(each + more.split()).encode()).hexdigest()[:8]


def found(top, endings):
    """The sources below a folder that figures depend on."""
    return [path for path in Path(top).rglob("*") if path.suffix in endings
            and not (path.parts[0] == "rtl" and path.parts[1] in AROUND)]


@lru_cache(maxsize=None)
def of(kinds):
    """Of all sources of some kinds, `rtl+model`."""
    paths = []
    for kind in kinds.split("+"):
        top, endings = KINDS[kind]
        paths += found(top, endings)
    return of_files(paths)
