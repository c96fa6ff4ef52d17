#!/usr/bin/env python3
# plan.py - writes a makefile with a target for each job of the study that has no result yet
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.study.plan [--short] [--kinds KIND,...] TOOL BUILD RESULTS MAKEFILE
Says how many jobs there are and how many have to be run, and names results that are damaged."""
import argparse
import os
import sys

from . import jobs, points


def main(argv):
    parser = argparse.ArgumentParser(prog="plan", description=__doc__.split("\n")[1])
    parser.add_argument("--short", action="store_true", help="the short form")
    parser.add_argument("--kinds", default=",".join(jobs.FIELDS), help="only these")
    for name in "tool", "build", "results", "makefile":
        parser.add_argument(name)
    a = parser.parse_args(argv)
    kinds = a.kinds.split(",")
    if set(kinds) - set(jobs.FIELDS):
        sys.exit(f"study: {a.kinds}: kinds are {', '.join(jobs.FIELDS)}")
    keys = [k for k in (points.short() if a.short else points.plan())
            if jobs.words(k)["kind"] in kinds]
    digests, todo = {}, []
    for key in keys:
        why = jobs.look(a.results, key, digests)[1]
        if why:
            todo.append(key)
            if "damaged" in why:
                print(f"study: {why}, made anew", file=sys.stderr)
    lines = ["# written by lab/study/plan.py: jobs without a result, the most important first"]
    names = [f"job{i}" for i in range(len(todo))]
    lines += [".PHONY: all " + " ".join(names), "all: " + " ".join(names)]
    for name, key in zip(names, todo):
        lines += [f"{name}:", f"\t@printf '  %-4s %s\\n' JOB '{key}'",
                  f"\t@python3 -m lab.study.run '{a.tool}' '{a.build}' '{a.results}' '{key}'"]
    os.makedirs(os.path.dirname(a.makefile) or ".", exist_ok=True)
    with open(a.makefile + ".tmp", "w", encoding="utf-8") as f:
        f.write("\n".join(lines) + "\n")
    os.replace(a.makefile + ".tmp", a.makefile)
    print(f"study: {len(keys)} jobs, {len(todo)} to run")


if __name__ == "__main__":
    main(sys.argv[1:])
