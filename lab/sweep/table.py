# table.py - the figures of a sweep: CSV, a printed table, figures of others beside them
# SPDX-License-Identifier: Apache-2.0
"""A row is a point: all axes that shape what was measured, all figures, figures of `beside` as
FIGURE_beside, why something was refused, and the versions of the tools that a figure depends on.
Nothing in it depends on the machine, on how many jobs ran at once, or on when."""
import csv
import io
import re

from . import axes, measures
from .axes import Wrong, perhaps

# printed and drawn if nothing is asked for
SHOWN = {"counts": ["node_visits_per_ray", "leaf_tests_per_ray"], "accuracy": ["psnr", "wrong_id"],
         "price": ["price_psnr", "price_cycles_per_pixel"], "cycles": ["cycles_per_pixel", "limit"],
         "cells": ["lut4eq", "ff", "mult"]}


def number(text):
    """Of a cell; None if it is none."""
    found = re.fullmatch(r"[-+]?[0-9]+(\.[0-9]*)?([eE][-+]?[0-9]+)?", str(text).strip())
    return float(text) if found else None


def full(spec, point):
    """All axes of a point that shape what is measured: those of the sweep first."""
    shaped = [name for measure in spec.measures for name in axes.SHAPES[measure]]
    if "price" in spec.measures:
        shaped.append("profile")
    plain = {**axes.DEFAULTS, **axes.folded(point)}
    return {name: point.get(name, plain.get(name, "")) for name in
            dict.fromkeys([*spec.axes, *shaped])}


def rows(spec, keys, results):
    """(columns, rows, how many results are missing); keys(measure, point): of a job, or its
    refusal as {"refused": why}."""
    made, missing, names = [], 0, {}
    for point in spec.points:
        row, tools = full(spec, point), []
        found = {}
        for measure in spec.measures:
            key = keys(measure, point)
            result = key if isinstance(key, dict) else results.look(key)
            if result is None:
                missing += 1
                continue
            w = {**axes.DEFAULTS, **axes.folded(point), "measure": measure}
            found.update(measures.figures(w, result))
            tools += [result["yosys"].split(" (")[0]] if "yosys" in result else []
            tools += [measures.version(tool) for tool in measures.tools(w) if tool == "verilator"]
        row.update(found)
        if tools:
            row["tools"] = "; ".join(dict.fromkeys(tools))
        names.update(dict.fromkeys(name for name in found if name != "refused"))
        made.append(row)
    last = [name for name in ("refused", "tools") if any(name in row for row in made)]
    return [*full(spec, spec.points[0]), *names, *last], made, missing


def read(path):
    """Rows of a CSV file; lines that begin with # are comments."""
    try:
        with open(path, encoding="utf-8", newline="") as f:
            lines = [line for line in f if not line.startswith("#")]
    except OSError as why:
        raise Wrong(f"{path}: {why.strerror}") from None
    except UnicodeError as why:
        raise Wrong(f"{path}: {why}") from None
    found = list(csv.DictReader(lines, strict=True))
    if not found:
        raise Wrong(f"{path}: has no row")
    for n, row in enumerate(found, 1):
        if None in row or None in row.values():
            raise Wrong(f"{path}: row {n} has not as many columns as the first line")
    return found


def put_beside(columns, made, path):
    """Puts FIGURE_beside behind each figure that a CSV file has: its rows are matched by the axes
    that it names. Returns columns, and rows of the file that no point has."""
    others = read(path)
    figures = [name for name in columns if name not in (*axes.KNOWN, "tools", "refused")]
    for name in others[0]:
        if name not in (*axes.KNOWN, *figures, "source", "tools", "refused") \
                and not name.endswith("_beside"):
            raise Wrong(f"{path}: {name} is no axis and no figure of this sweep"
                        f"{perhaps(name, columns)}")
    figures = [name for name in figures if name in others[0]]
    here = [name for name in others[0] if name in axes.KNOWN and name in columns]
    apart = [name for name in others[0] if name in axes.KNOWN and name not in columns
             and len({row[name] for row in others}) > 1]
    if not here or apart:
        raise Wrong(f"{path}: its rows are told apart by {', '.join(apart) or 'no axis'}, which "
                    "this sweep does not have")
    by = {}
    for row in others:
        by.setdefault(tuple(row[name] for name in here), row)
    used = set()
    for row in made:
        key = tuple(str(row.get(name, "")) for name in here)
        used.add(key)
        for name in figures:
            row[f"{name}_beside"] = by.get(key, {}).get(name, "")
    out = []
    for name in columns:
        out += [name, f"{name}_beside"] if name in figures else [name]
    return out, [key for key in by if key not in used]


def of_csv(columns, made):
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    out.writerow(columns)
    out.writerows([row.get(name, "") for name in columns] for row in made)
    return text.getvalue()


def shown(spec, columns):
    """Figures that are printed and drawn; Wrong if one is none."""
    asked = spec.said.get("show")
    for name in asked or ():
        if name not in columns or name in axes.KNOWN:
            figures = [c for c in columns if c not in axes.KNOWN]
            raise Wrong(f"show: there is no figure {name}{perhaps(name, figures, '.')} There are "
                        f"{' '.join(figures)}")
    every = [name for measure in spec.measures for name in SHOWN[measure]]
    return asked or [name for name in every if name in columns]


def printed(spec, columns, made):
    """A table for people: axes that vary, figures that are shown, with a ratio to those beside."""
    heads = list(spec.varied) or spec.axes
    for name in shown(spec, columns):
        heads.append(name)
        if f"{name}_beside" in columns:
            heads += [f"{name}_beside", "ratio"]
    if any(row.get("refused") for row in made):
        heads.append("refused")
    table = [heads]
    for row in made:
        line, before = [], ""
        for head in heads:
            if head == "ratio":
                a, b = number(row.get(before[:-7], "")), number(row.get(before, ""))
                line.append(f"{a / b:.3f}" if a is not None and b else "")
            else:
                line.append(str(row.get(head, "")))
            before = head
        table.append([cell or "-" for cell in line])
    widths = [max(map(len, column)) for column in zip(*table)]
    text = [number(row[i]) is None and row[i] != "-" for i in range(len(heads))
            for row in table[1:2]]
    return "".join("  ".join(cell.ljust(w) if left else cell.rjust(w) for cell, w, left in
                             zip(row, widths, text)).rstrip() + "\n" for row in table)
