# plan.py - writes the list of those jobs of the study that have no result yet
# SPDX-License-Identifier: Apache-2.0
"""LIST is for lab/jobs/run.py. Says how many jobs there are and how many have to be run, and names
results that are damaged."""
import sys

from ..jobs import plan
from . import keys, points

# Seconds of a job that was never run: of 320x180 pixels, of a frame whose core may have to be made.
GUESS = {"accuracy": 10, "cycles": 40, "cells": 120, "price": 5}


def guess(key):
    words = keys.words(key)
    if words["kind"] != "accuracy":
        return GUESS[words["kind"]]
    width, height = (int(n) for n in words["size"].split("x"))
    return GUESS["accuracy"] * width * height / (320 * 180)


def main(tool, build, results, name, short=False, kinds=",".join(keys.FIELDS)):
    if set(kinds.split(",")) - set(keys.FIELDS):
        sys.exit(f"study: {kinds}: kinds are {', '.join(keys.FIELDS)}")
    chosen = [k for k in (points.short() if short else points.plan())
              if keys.words(k)["kind"] in kinds.split(",")]
    command = ["python3", "-m", "lab", "study-job", tool, build, results]
    plan.write(name, results,
               [plan.job(results, k, [*command, k], guess(k)) for k in chosen], "study")
