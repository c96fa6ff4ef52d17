# budget.py - is a synthesised core within synth/budget.txt? TAP lines, one a module
# SPDX-License-Identifier: Apache-2.0
"""Exits with 1 if a module is over its budget or is not in the core."""
import sys

from . import results


def read(path, name="budget", columns="`module MULT18X18D places`"):
    """{module: two whole numbers}; other columns are an error of file and line, told by name."""
    limits = {}
    with open(path, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            word = line.split("#")[0].split()
            if not word:
                continue
            if len(word) != 3 or not (word[1] + word[2]).isdigit():
                sys.exit(f"{name}: {path}:{number}: not {columns}: {line.strip()}")
            limits[word[0]] = int(word[1]), int(word[2])
    return limits


def main(folder, *budgets):
    run = results.read(folder)
    limits = {}
    for path in budgets:
        limits.update(read(path))
    bad = 0
    for module, (mult, places) in limits.items():
        total = run["modules"].get(module, {"total": None})["total"]
        ok = total is not None and total["mult"] <= mult and total["places"] <= places
        bad += not ok
        is_now = (f"{total['mult']} of {mult} MULT18X18D, {total['places']} of {places} LUT places"
                  if total else "not in the core")
        print(f"{'ok' if ok else 'not ok'} - {run['profile']} {run['target']} {module}: {is_now}")
    sys.exit(bad > 0)
