# main.py - the report of a run
# SPDX-License-Identifier: Apache-2.0
"""Writes FOLDER/report.html of what `make sim` left there. --csv appends a row for each pass to
FILE, which gets a header if it is new; a file with another header is refused."""
import fcntl
import io
import json
import sys
from csv import reader, writer
from pathlib import Path

from .. import intact
from . import frames, page
from .run import Run

MEMORY = "bytes_per_pixel", "row_hit_share", "bound_share"  # empty where nobody counts them


class Bad(Exception):
    """A table that has other columns."""


def rows(run):
    """{column: value} of each pass of a run: what it was asked, and what it counted with cold and,
    with WARM=1, with warm caches."""
    return [row(run, caches) for caches in ("cold", "warm") if caches in run.report]


def row(run, caches):
    report = run.report
    last = report[caches]
    columns = {name: report[name] for name in ("scene", "profile")}
    columns.update(width=run.model.width, height=run.model.height,
                   window=" ".join(map(str, run.window)), core=report.get("core", ""),
                   engines=run.parameters["ENGINES"], pipes=run.parameters["PIPES"],
                   tree=run.machine["tree"], separation=run.machine["background"],
                   depth=run.machine["max_depth"])
    columns.update((name, report[name]) for name in
                   ("simulator", "latency", "stall", "seed", "pixels", "mismatches", "seconds"))
    memory = last.get("memory", {})
    columns.update(memory=report["memory"]["name"], core_mhz=report["memory"]["core_mhz"])
    columns.update((name, memory.get(name, "")) for name in MEMORY)
    columns.update(caches=caches, cycles_per_pixel=last["cycles_per_pixel"])
    columns.update(last["counters"])
    return columns


def append(path, columns):
    """Appends a row under a lock; a new file gets a header before it."""
    with open(path, "a+", encoding="utf-8", newline="") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        file.seek(0)
        there = next(reader(file), None)
        if there is not None and there != list(columns):
            extra = sorted(set(there) ^ set(columns))
            raise Bad(f"{path}:1: this header is another one: "
                      + (f"{', '.join(extra)} in one of them alone" if extra else
                         "the order of its columns"))
        text = io.StringIO()
        out = writer(text, lineterminator="\n")
        if there is None:
            out.writerow(columns)
        out.writerow(columns.values())
        file.write(text.getvalue())


def main(folder, csv=None):
    name = Path(folder, "report.html")
    try:
        run = Run(Path(folder))
        intact.write(name, page.page(run))
        print("look at", name.resolve().as_uri())
        for columns in rows(run) if csv else ():
            append(Path(csv), columns)
    except (OSError, frames.Bad, Bad) as error:
        sys.exit(f"report: {error}")
    except (json.JSONDecodeError, KeyError) as error:
        sys.exit(f"report: {folder}: not what `make sim` left: {error!r}")
