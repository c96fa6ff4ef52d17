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
        if row.get("build"):
            frame["upload_bytes"], frame["build_cycles"] = int(row["moved"]), int(row["build"])
    return dict(built, command="top")


def chip(frames, mhz):
    """What building in rt_top costs a mean frame; none counts that nothing was drawn beside."""
    later = [f for f in frames[1:] if "build_cycles" in f]
    if not later:
        return ""
    build, upload, image = (sum(f[name] for f in later) / len(later)
                            for name in ("build_cycles", "upload_cycles", "image_cycles"))
    period = max(image, upload + build)
    return (f"tree by rt_top: upload {upload:.0f} clocks, build {build:.0f}, both beside the frame "
            f"before, START to all written {image:.0f}; {1e6 * mhz / period:.1f} frames a second "
            f"at {mhz:g} MHz, building {100 * build / period:.2f} % of a frame\n")


def main(folder, mhz=84):
    report = joined(folder)
    built = any("build_cycles" in f for f in report["frames"])
    print("frame  built, s  tree          bytes   upload, cycles    draw   START to all written   "
          "pixels a burst" + ("   moved, bytes   build, cycles" if built else ""))
    for f in report["frames"]:
        tree = "refitted" if f["refitted"] else "built"
        more = f" {f['upload_bytes']:14} {f['build_cycles']:15}" if "build_cycles" in f else ""
        print(f"{f['at']:5} {f['build_seconds']:9.4f}  {tree:8} {f['memory_bytes']:10} "
              f"{f['upload_cycles']:16} {f['draw_cycles']:7} {f['image_cycles']:22} "
              f"{f['pixels_a_burst']:16.2f}{more}")
    print(chip(report["frames"], float(mhz)), end="")
    path = os.path.join(folder, "report.json")
    intact.write(path, json.dumps(report, indent=2) + "\n")
