# function.py - what a library says that an output is of its pins
# SPDX-License-Identifier: Apache-2.0
import re
from functools import cached_property

SYMBOL = re.compile(r"\s*([A-Za-z_]\w*(?:\[\d+\])?|[01]|[!'^*&+|()])")


class Function:
    """A Boolean function of pins: ! and ' invert, * & or nothing between is and, + | is or, ^ is
    exclusive or. code: C and Python alike, of bits with 1 and 0."""

    def __init__(self, text):
        self.text, self.pins = text, []
        self.symbols, at = [], 0
        while text[at:].strip():
            match = SYMBOL.match(text, at)
            if not match:
                raise ValueError(f"{text[at:].strip()[0]!r} in a function")
            self.symbols.append(match[1])
            at = match.end()
        self.symbols.append("")
        self.code = self.either()
        if self.symbols[0]:
            raise ValueError(f"{self.symbols[0]!r} is too much")

    def either(self):
        code = self.both()
        while self.symbols[0] in ("+", "|"):
            self.symbols.pop(0)
            code = f"({code} | {self.both()})"
        return code

    def both(self):
        code = self.differ()
        while self.symbols[0] in ("*", "&") or self.symbols[0] and self.symbols[0] not in "+|)^'":
            if self.symbols[0] in ("*", "&"):
                self.symbols.pop(0)
            code = f"({code} & {self.differ()})"
        return code

    def differ(self):
        code = self.single()
        while self.symbols[0] == "^":
            self.symbols.pop(0)
            code = f"({code} ^ {self.single()})"
        return code

    def single(self):
        symbol = self.symbols.pop(0)
        if symbol == "!":
            return f"({self.single()} ^ 1)"
        if symbol == "(":
            code = self.either()
            if self.symbols.pop(0) != ")":
                raise ValueError("')' is missing")
        elif symbol and (symbol[0].isalpha() or symbol[0] in "_01"):
            code = symbol
            if symbol not in "01" and symbol not in self.pins:
                self.pins.append(symbol)
        else:
            raise ValueError(f"a pin is missing before {symbol!r}" if symbol else
                             "it ends where a pin should be")
        while self.symbols[0] == "'":
            self.symbols.pop(0)
            code = f"({code} ^ 1)"
        return code

    @cached_property
    def compiled(self):
        return compile(self.code, self.text, "eval")

    def value(self, bits):
        """Of {pin: 0 or 1}."""
        return eval(self.compiled, {"__builtins__": {}}, bits)    # pylint: disable=eval-used
