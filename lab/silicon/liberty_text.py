# liberty_text.py - the groups of a file in Liberty format
# SPDX-License-Identifier: Apache-2.0
"""Reader(path).library() gives the group library with all that is in it. What is wrong raises Bad,
which names file and line."""
import re
from dataclasses import dataclass, field
from pathlib import Path


class Bad(Exception):
    """A library that cannot be read: file, line, why."""


TOKEN = re.compile(r"""
    (?P<space> (?: \s | \\\s*\n | /\*.*?\*/ | //[^\n]* )+ )
  | "(?P<text> [^"]* )"
  | (?P<mark> [(){}:;,] )
  | (?P<word> [^\s(){}:;,"\\]+ )
""", re.X | re.S)


@dataclass
class Group:
    """kind (words) { values and groups }. A value is a list of words: those behind a colon, or
    between parentheses."""
    kind: str
    words: list
    line: int
    values: dict = field(default_factory=dict)      # {name: (words, line)}, the last of each name
    groups: list = field(default_factory=list)

    @property
    def name(self):
        return self.words[0] if self.words else ""

    def all(self, *kinds):
        return [group for group in self.groups if group.kind in kinds]


class Reader:
    """The groups of a file."""

    def __init__(self, path):
        self.path = path
        try:
            self.source = Path(path).read_text(encoding="utf-8", errors="replace")
        except OSError as error:
            raise Bad(f"{path}: {error.strerror}") from error
        self.at, self.line = 0, 1
        self.token, self.is_text, self.token_line = "", False, 1
        self.take()

    def bad(self, line, why):
        return Bad(f"{self.path}:{line}: {why}")

    def take(self):
        """The token that was ahead; "" at the end of the file."""
        taken = self.token
        while True:
            self.token_line = self.line
            if self.at >= len(self.source):
                self.token, self.is_text = "", False
                return taken
            match = TOKEN.match(self.source, self.at)
            if not match:
                raise self.bad(self.line, "a text without its second quote"
                               if self.source[self.at] == '"' else
                               f"{self.source[self.at]!r} is of no use here")
            self.at = match.end()
            self.line += match[0].count("\n")
            if match.lastgroup != "space":
                self.token, self.is_text = match[match.lastgroup], match.lastgroup == "text"
                return taken

    def is_mark(self, mark):
        return self.token == mark and not self.is_text

    def need(self, mark, behind):
        if not self.is_mark(mark):
            raise self.bad(self.token_line, f"{mark!r} is missing behind {behind}"
                           + (f", there is {self.token!r}" if self.token else
                              ": the file ends here"))
        self.take()

    def words(self, name):
        """Between parentheses."""
        found = []
        while not self.is_mark(")"):
            if not self.token and not self.is_text:
                raise self.bad(self.token_line, f"{name} ( has no ')': the file ends here")
            if self.token in ("{", "}", ";") and not self.is_text:
                raise self.bad(self.token_line, f"{name} ( has no ')'")
            word = self.take()
            if word != ",":
                found.append(word)
        self.take()
        return found

    def value(self, name):
        """Behind a colon, to the end of its line or a semicolon."""
        found, line = [], self.token_line
        while self.token_line == line and (self.token or self.is_text) \
                and not (self.token in ("}", ";") and not self.is_text):
            found.append(self.take())
        if not found:
            raise self.bad(line, f"{name} has no value")
        return found

    def group(self, kind, words, line):
        """What is between braces; the first is taken already."""
        found = Group(kind, words, line)
        while not self.is_mark("}"):
            if self.is_mark(";"):
                self.take()
                continue
            name, at = self.token, self.token_line
            if not name:
                raise self.bad(at, f"the file ends inside of {kind} "
                               f"{found.name or ''}".rstrip() + f", which began in line {line}")
            if self.is_text or name in "(){}:,":
                raise self.bad(at, f"{name!r} stands where a name should")
            self.take()
            if self.is_mark(":"):
                self.take()
                found.values[name] = self.value(name), at
                continue
            self.need("(", name)
            inside = self.words(name)
            if self.is_mark("{"):
                self.take()
                found.groups.append(self.group(name, inside, at))
            else:
                found.values[name] = inside, at
        self.take()
        return found

    def library(self):
        if self.token != "library":
            raise self.bad(self.token_line, "a library is expected, there is "
                           f"{self.token!r}" if self.token else "the file has no library")
        line = self.token_line
        self.take()
        self.need("(", "library")
        words = self.words("library")
        self.need("{", f"library ({' '.join(words)})")
        return self.group("library", words, line)
