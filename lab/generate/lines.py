# lines.py - lines of a file of definitions, and the head of what is made of them
# SPDX-License-Identifier: Apache-2.0
from sim.definition import SHORT, Unsound


class Lines:
    """Of a file; fail() raises Unsound of the present one."""

    def __init__(self, name):
        self.name, self.number = name, 0

    def each(self, take):
        """Calls take(first word, others, line) for lines that are not empty without comments."""
        with open(self.name, encoding="utf-8") as f:
            for self.number, line in enumerate(f, 1):
                text = line.partition("#")[0].rstrip()
                if text:
                    kind, *words = text.split()
                    try:
                        take(kind, words, text)
                    except (IndexError, ValueError):
                        self.fail(f"{kind}: {SHORT}")

    def fail(self, why):
        raise Unsound(f"{self.name}:{self.number}: {why}")


def verilog_head(name, made_from, *more):
    return [f"// {name} - generated from {made_from} by make layout; do not edit",
            "// SPDX-License-Identifier: Apache-2.0", *(f"// {text}" for text in more)]


def c_head(name, made_from, *more):
    """Its comment may go on, and then ends at the end of the last line."""
    lines = [f"/* {name} - generated from {made_from} by make layout; do not edit",
             " * SPDX-License-Identifier: Apache-2.0", *(f" * {text}" for text in more)]
    return lines[:-1] + [lines[-1] + " */"] if more else lines + [" */"]


def told(lines):
    return "\n".join([*lines, ""])
