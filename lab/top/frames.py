# frames.py - time to image of the frames that make sim TOP=1 drew
# SPDX-License-Identifier: Apache-2.0
"""Joins build.json of the CPU side and frames.tsv of the harness: prints a table and leaves
FOLDER/report.json (docs/reference/tool.md)."""
import csv
import json
import os
import sys

from .. import intact


def joined(folder):
    """The frames of a run, each with what both sides know of it."""
    with open(os.path.join(folder, "build.json"), encoding="utf-8") as file:
        built = json.load(file)
    with open(os.path.join(folder, "frames.tsv"), encoding="utf-8", newline="") as file:
        drawn = list(csv.DictReader(file, delimiter="\t"))
    if len(built["frames"]) != len(drawn):
        sys.exit(f"frames: {folder}: {len(built['frames'])} frames were built, {len(drawn)} drawn")
    for frame, row in zip(built["frames"], drawn):
        if frame["memory_bytes"] != int(row["bytes"]):
            sys.exit(f"frames: {folder}: frame {frame['at']}: {frame['memory_bytes']} bytes were "
                     f"built, {row['bytes']} drawn")
        frame["upload_cycles"], frame["draw_cycles"], frame["image_cycles"] = (
            int(row[name]) for name in ("upload", "draw", "written"))
        frame["pixels_a_burst"] = float(row["pixels_a_burst"])
    return dict(built, command="top")


def main(folder):
    report = joined(folder)
    print("frame  built, s  tree          bytes   upload, cycles    draw   START to all written   "
          "pixels a burst")
    for f in report["frames"]:
        tree = "refitted" if f["refitted"] else "built"
        print(f"{f['at']:5} {f['build_seconds']:9.4f}  {tree:8} {f['memory_bytes']:10} "
              f"{f['upload_cycles']:16} {f['draw_cycles']:7} {f['image_cycles']:22} "
              f"{f['pixels_a_burst']:16.2f}")
    path = os.path.join(folder, "report.json")
    intact.write(path, json.dumps(report, indent=2) + "\n")
