# command.py - the tables of lab/table.py against the modules that they name
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.command"""
import ast
import inspect
import re
import subprocess
from pathlib import Path

from .. import table
from ..__main__ import overview, parser_of


def signature(run):
    """Of a function of a module, which may need packages that are not here: read, not imported."""
    module, _, name = run.partition(":")
    text = Path("lab", module.replace(".", "/") + ".py").read_text(encoding="utf-8")
    found = next(node.args for node in ast.parse(text).body
                 if isinstance(node, ast.FunctionDef) and node.name == (name or "main"))
    kind = inspect.Parameter
    least = len(found.args) - len(found.defaults)
    return inspect.Signature(
        [kind(a.arg, kind.POSITIONAL_OR_KEYWORD, **({} if i < least else {"default": None}))
         for i, a in enumerate(found.args)]
        + ([kind(found.vararg.arg, kind.VAR_POSITIONAL)] if found.vararg else [])
        + [kind(a.arg, kind.KEYWORD_ONLY, default=None) for a in found.kwonlyargs])


def takes(run, words, options):
    try:
        signature(run).bind(*words, **options)
    except (OSError, StopIteration, TypeError) as fault:
        raise AssertionError(f"{run} {' '.join(words)}: {fault!r}") from fault


for command in table.COMMANDS.values():
    if command.arguments == "...":    # reads them itself
        takes(command.run, [[]], {})
        continue
    _, options = parser_of(command.name, command.arguments, command.text, "")
    every = [w for w in command.arguments.split() if not w.startswith("--")]
    for words in every, [w for w in every if not w.startswith("[")]:
        takes(command.run, words, dict.fromkeys(options))
for row in table.EXPERIMENTS:
    for step in row.steps:
        run, *words = step.split()
        takes(run, [w for w in words if not w.startswith("--")],
              {w[2:].replace("-", "_"): 1 for w in words if w.startswith("--")})

shown = overview()
names = [row.name for row in table.EXPERIMENTS] + list(table.COMMANDS)
assert len(set(names)) == len(names) == len(re.findall(r"^  [a-z]", shown, re.M)), "a name twice"
assert all(len(line) <= 100 for line in shown.splitlines())

# ---- a module by itself is a program only if it says so: it would end without a word ----
said = subprocess.run(["grep", "-rnEoI", "-e", r'-m"?,? "?lab\.[a-z_.]+',
                       "--exclude-dir=build", "--exclude-dir=.git", "."],
                      stdout=subprocess.PIPE, text=True, check=False)
for line in said.stdout.splitlines():
    module = re.search(r"lab\.[a-z_.]+$", line)[0].rstrip(".").replace(".", "/")
    if module.startswith("lab/checks/"):    # nobody imports those
        continue
    files = [path for path in (Path(module + ".py"), Path(module, "__main__.py")) if path.exists()]
    assert files and "sys.argv" in files[0].read_text(encoding="utf-8"), line
