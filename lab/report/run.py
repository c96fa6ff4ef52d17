# run.py - what a run of `make sim` left in its folder
# SPDX-License-Identifier: Apache-2.0
import json
import os
import subprocess
from pathlib import Path

from . import frames, units


class Run:
    """The files of a folder: key and build.json, report.json, frames and clocks."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.key = dict(line.split("=", 1)
                        for line in (self.folder / "key").read_text("utf-8").splitlines())
        self.built = self.read("build.json")
        self.machine = self.built["machine"]
        self.report = self.read("report.json")
        self.model = frames.Frame(self.folder / "model.frame")
        self.core = frames.Frame(self.folder / "rtl.frame")
        self.window = self.report["window"]
        self.parameters = units.parameters(self.key, self.report.get("core", "all"),
                                           self.machine["profile"])
        self.last = self.report.get("warm", self.report["cold"])
        self.left = frames.clocks(self.folder / "rtl.clocks", self.core)

    def read(self, name):
        return json.loads((self.folder / name).read_text("utf-8"))

    def slots(self):
        return self.parameters["SLOTS"] * self.parameters["PIPES"] * self.parameters["ENGINES"]

    def in_flight(self):
        """Clocks of each pixel in a slot; None if nobody noted when pixels left."""
        if not self.left:
            return None
        return frames.in_flight(self.core, self.left, self.window, self.slots(),
                                self.parameters["WALKS"])

    def first_wrong(self):
        return frames.first_wrong(self.model, self.core, self.window)

    def rays(self, x, y):
        """The rays of a pixel as the model traces them."""
        tool = os.path.join(os.environ.get("BUILD", "build"), "sphaera")
        said = subprocess.run([tool, "info", self.folder / "scene.sph", "--pixel", f"{x},{y}",
                               "--json", "-"], check=True, capture_output=True, text=True)
        return json.loads(said.stdout)["pixel_rays"]
