#!/usr/bin/env python3
# plan.py - writes the list of those jobs of the study that have no result yet
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.study.plan [--short] [--kinds KIND,...] TOOL BUILD RESULTS LIST
LIST is for lab/jobs/run.py. Says how many jobs there are and how many have to be run, and names
results that are damaged."""
import argparse
import sys

from ..jobs import plan
from . import keys, points

# Seconds of a job that was never run: of 320x180 pixels, of a frame whose core may have to be made.
GUESS = {"accuracy": 10, "cycles": 40, "cells": 120}


def guess(key):
    words = keys.words(key)
    if words["kind"] != "accuracy":
        return GUESS[words["kind"]]
    width, height = (int(n) for n in words["size"].split("x"))
    return GUESS["accuracy"] * width * height / (320 * 180)


def main(argv):
    parser = argparse.ArgumentParser(prog="plan", description=__doc__.split("\n")[1])
    parser.add_argument("--short", action="store_true", help="the short form")
    parser.add_argument("--kinds", default=",".join(keys.FIELDS), help="only these")
    for name in "tool", "build", "results", "list":
        parser.add_argument(name)
    a = parser.parse_args(argv)
    kinds = a.kinds.split(",")
    if set(kinds) - set(keys.FIELDS):
        sys.exit(f"study: {a.kinds}: kinds are {', '.join(keys.FIELDS)}")
    chosen = [k for k in (points.short() if a.short else points.plan())
              if keys.words(k)["kind"] in kinds]
    command = ["python3", "-m", "lab.study.run", a.tool, a.build, a.results]
    plan.write(a.list, a.results,
               [plan.job(a.results, k, [*command, k], guess(k)) for k in chosen], "study")


if __name__ == "__main__":
    main(sys.argv[1:])
