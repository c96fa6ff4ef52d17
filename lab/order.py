# order.py - what an order of children is worth: `make order`, docs/design/extending.md
# SPDX-License-Identifier: Apache-2.0
"""The sweep examples/order/sweep.txt in this tree, and in a copy of it that
examples/order/far_first.patch was put to, by the tool of each."""
import shutil
import subprocess
from pathlib import Path

from . import tasks
from .pages.place import place
from .runner import said
from .sweep import table

PATCH, SWEEP = "examples/order/far_first.patch", "examples/order/sweep.txt"
PARTS = ["Makefile", "VERSION", "cmodel", "driver", "examples", "lab", "make", "rtl", "scenes",
         "sim", "synth", "tb"]


def copy(folder):
    """A copy of the tree, with the patch, and its tool."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    said("cp", "-r", *PARTS, folder)
    said("patch", "-s", "-d", folder, "-p1", "-i", PATCH)
    subprocess.run(["make", "-s", "-C", folder, "tool"], check=True, env=tasks.clean())


def measure(tool, folder):
    folder = Path(folder).resolve()
    copy(folder / "copy")
    own = folder / "copy/build/sphaera"
    said(tool, "sweep", SWEEP, "--out", folder / "before")
    said(own, "sweep", folder / "copy" / SWEEP, "--beside", folder / "before/sweep.csv", "--out",
         folder / "after")


def main(page, folder):
    found = [["scene", "as the node has them", "far first", "ratio"]]
    for row in table.read(Path(folder, "after/sweep.csv")):
        if row["picture"] != row["picture_beside"]:
            raise ValueError(f"{row['scene']}: an order changes the picture")
        own, other = int(row["node_visits"]), int(row["node_visits_beside"])
        found.append([f"`{row['scene']}`", str(other), str(own), f"{own / other:.3f}"])
    place(page, "make order", {"order": found})
