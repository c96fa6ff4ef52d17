# __main__.py - python3 -m lab: one command for all that measures, studies and writes pages
# SPDX-License-Identifier: Apache-2.0
import argparse
import importlib
import os
import sys

from . import table

HEAD = """usage: python3 -m lab COMMAND [ARGUMENT...]       from the root of the tree
       python3 -m lab COMMAND --help
"""


def overview():
    rows = {"experiments, which make runs too": [(e.name, e.text) for e in table.EXPERIMENTS]}
    rows.update({group: [(name, text) for name, _, _, text in commands]
                 for group, commands in table.GROUPS.items()})
    return HEAD + "".join(f"\n{group}\n" + "".join(f"  {name:15} {text}\n" for name, text in found)
                          for group, found in rows.items())


def function(run):
    """(what "module:function" names, what the module says of itself)"""
    module, _, name = run.partition(":")
    found = importlib.import_module("lab." + module)
    return getattr(found, name or "main"), found.__doc__


def parser_of(name, arguments, text, about):
    """And the names of its options."""
    parser = argparse.ArgumentParser(
        prog=f"python3 -m lab {name}", formatter_class=argparse.RawDescriptionHelpFormatter,
        description=f"{text}\n\n{about or ''}")
    options = []
    for word in arguments.split():
        shown = word.strip("[]").removesuffix("...")
        if word.startswith("--"):
            flag, has, value = word.partition("=")
            options.append(flag[2:].replace("-", "_"))
            parser.add_argument(flag, **({"metavar": value} if has else {"action": "store_true"}))
        else:
            many = ("*" if word.endswith("...]") else
                    "+" if word.endswith("...") and "," not in word else None)
            parser.add_argument(shown, nargs=many or ("?" if word.startswith("[") else None))
    return parser, options


def command(name, words):
    row = table.COMMANDS[name]
    run, about = function(row.run)
    parser, options = parser_of(name, row.arguments, row.text, about)
    given = vars(parser.parse_args(words))
    chosen = {option: given.pop(option) for option in options}
    positional = []
    for value in given.values():
        positional += value if isinstance(value, list) else [] if value is None else [value]
    return run(*positional, **{option: value for option, value in chosen.items() if value})


def experiment(row, words):
    steps = {step.split()[0]: step.split()[1:] for step in row.steps}
    parser, _ = parser_of(row.name, "", row.text, "steps: " + ", ".join(row.steps))
    parser.add_argument("steps", nargs="*", metavar="STEP", help="only these, by their first words")
    parser.add_argument("--build", default=os.environ.get("BUILD", "build"),
                        help="folder of all that is built")
    given = parser.parse_args(words)
    for wrong in set(given.steps) - set(steps):
        parser.error(f"no step {wrong}; there are {', '.join(steps)}")
    for step in given.steps or steps:
        run, _ = function(step)
        arguments = [given.build + w[5:] if w.split("/")[0] == "BUILD" else
                     f"{given.build}/sphaera" if w == "TOOL" else w for w in steps[step]]
        options = {w[2:].replace("-", "_"): True for w in arguments if w.startswith("--")}
        run(*[w for w in arguments if not w.startswith("--")], **options)


def main(words):
    if not words or words[0] in ("--help", "-h"):
        print(overview(), end="")
        return not words
    name, rest = words[0], words[1:]
    found = {row.name: row for row in table.EXPERIMENTS}
    if name in found:
        return experiment(found[name], rest)
    if name in table.COMMANDS:
        return command(name, rest)
    sys.exit(f"there is no command {name}: python3 -m lab --help")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
