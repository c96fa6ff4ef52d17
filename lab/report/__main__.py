# __main__.py - the report of a run
# SPDX-License-Identifier: Apache-2.0
"""usage: [BUILD=build] python3 -m lab.report FOLDER [--csv FILE]
Writes FOLDER/report.html of what `make sim` left there. --csv appends a row for each pass to FILE,
which gets a header if it is new; a file with another header is refused."""
import argparse
import json
import sys
from pathlib import Path

from .. import intact
from . import frames, page, rows
from .run import Run


def main():
    parser = argparse.ArgumentParser(prog="report", usage=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--csv", type=Path)
    given = parser.parse_args()
    try:
        run = Run(given.folder)
        intact.write(given.folder / "report.html", page.page(run))
        print("look at", (given.folder / "report.html").resolve().as_uri())
        if given.csv:
            for row in rows.rows(run):
                rows.append(given.csv, row)
    except (OSError, frames.Bad, rows.Bad) as error:
        sys.exit(f"report: {error}")
    except (json.JSONDecodeError, KeyError) as error:
        sys.exit(f"report: {given.folder}: not what `make sim` left: {error!r}")


if __name__ == "__main__":
    main()
