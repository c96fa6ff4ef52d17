# __main__.py - python3 -m lab: one command for all that measures, studies and writes pages
# SPDX-License-Identifier: Apache-2.0
import argparse
import difflib
import importlib
import os
import re
import sys

from sim.definition import Unsound

from . import table, tasks

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
    if row.arguments == "...":
        return run(words)
    parser, options = parser_of(name, row.arguments, row.text, about)
    given = vars(parser.parse_args(words))
    chosen = {option: given.pop(option) for option in options}
    positional = []
    for value in given.values():
        positional += value if isinstance(value, list) else [] if value is None else [value]
    return run(*positional, **{option: value for option, value in chosen.items() if value})


def on_cluster(row, build, listed, sources):
    """What is in the build folder, as jobs: those that wait for nothing, then what waits for them,
    and so on."""
    from .jobs import run, targets
    left = [task for task in listed if task.target.startswith(f"{build}/")]
    rounds = 0
    while left:
        coming = {task.target for task in left}
        ready = [task.target for task in left if coming.isdisjoint(task.needs)]
        left = [task for task in left if task.target not in ready]
        name = f"{build}/{row.name}/jobs{rounds}"
        targets.write(row.name, build, f"{build}/{row.name}/results", name, sources, *ready)
        if run.main("slurm", name):
            sys.exit(1)
        rounds += 1


def experiment(row, words):
    steps = {re.split("[.:]", step.split()[0])[-1]: step.split() for step in row.steps}
    parser, _ = parser_of(row.name, "", row.text, "steps:\n  " + "\n  ".join(
        ([f"the files of {row.files}"] if row.files else []) + row.steps))
    parser.add_argument("steps", nargs="*", metavar="STEP", help="only these, by the last word of "
                        "their module or function")
    parser.add_argument("--build", default=os.environ.get("BUILD") or "build",
                        help="folder of all that is built")
    if row.files:
        parser.add_argument("--file", action="append", metavar="FILE", help="only this file")
    given = parser.parse_args(words)
    for wrong in set(given.steps) - set(steps):
        parser.error(f"no step {wrong}; there are {', '.join(steps)}")
    build, files = given.build, getattr(given, "file", None)
    os.environ["BUILD"] = build
    if row.files and not given.steps:
        module = importlib.import_module(f"lab.{row.files}")
        listed = module.tasks(build)
        if os.environ.get("ENGINE") == "slurm" and not files and hasattr(module, "OF"):
            on_cluster(row, build, listed, module.OF)
        tasks.make_all(listed, files or ())
    for step in given.steps or (() if files else steps):
        arguments = [build + w[5:] if w.split("/")[0] == "BUILD" else
                     f"{build}/sphaera" if w == "TOOL" else w for w in steps[step][1:]]
        options = {w[2:].replace("-", "_"): True for w in arguments if w.startswith("--")}
        words = [w for w in arguments if not w.startswith("--")]
        function(steps[step][0])[0](*words, **options)


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
    meant = difflib.get_close_matches(name, [*found, *table.COMMANDS], 1)
    sys.exit(f"there is no command {name}" + (f"; is {meant[0]} meant?" if meant else "") +
             ": python3 -m lab --help")


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except BrokenPipeError:     # who reads has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (ModuleNotFoundError, OSError, UnicodeError, Unsound) as why:
        sys.exit(f"lab {sys.argv[1]}: {why}")
