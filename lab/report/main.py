# main.py - the report of a run
# SPDX-License-Identifier: Apache-2.0
"""Writes FOLDER/report.html of what `make sim` left there. --csv appends a row for each pass to
FILE, which gets a header if it is new; a file with another header is refused."""
import json
import sys
from pathlib import Path

from .. import intact
from . import frames, page, rows
from .run import Run


def main(folder, csv=None):
    name = Path(folder, "report.html")
    try:
        run = Run(Path(folder))
        intact.write(name, page.page(run))
        print("look at", name.resolve().as_uri())
        for row in rows.rows(run) if csv else ():
            rows.append(Path(csv), row)
    except (OSError, frames.Bad, rows.Bad) as error:
        sys.exit(f"report: {error}")
    except (json.JSONDecodeError, KeyError) as error:
        sys.exit(f"report: {folder}: not what `make sim` left: {error!r}")
