# cores.py - cycles of scenes on cores with some number of units
# SPDX-License-Identifier: Apache-2.0
"""What was measured lies in rate/DIGEST/ of the build folder, where DIGEST is that of RTL, model
and scenes, and is not measured again."""
import json
import sys
from collections import namedtuple
from pathlib import Path

from .. import intact
from ..jobs import store
from ..runner import said, scene_file

SOURCES = ["rtl/*/*.v", "rtl/*/*.vh", "cmodel/*/*.[ch]", "scenes/**/*.nff",
           "tool:verilator"]
SPHERES = "shadow+reflect2+lights3+inside+spans"
GLASS = "shadow+reflect2+lights1+inside+facets+refract+specular+sum"


class Core(namedtuple("Core", "pipes leaf_units shades")):
    """Units of an engine; 0: by the rule of rt_core."""

    def variables(self):
        return {"PIPES": str(self.pipes), "LEAF_UNITS": str(self.leaf_units),
                "SHADES": str(self.shades)}

    def name(self):
        given = [f"{n} {what}" for n, what in ((self.leaf_units, "leaf"), (self.shades, "shading"))
                 if n]
        return str(self.pipes) + (f", {' and '.join(given)}" if given else "")


class Bench:
    """Where runs lie."""

    def __init__(self, build, size):
        self.build, self.size = build, size
        self.folder = Path(build) / "rate" / store.digest(SOURCES)[:8]
        self.folder.mkdir(parents=True, exist_ok=True)

    def machine(self, scene, effects):
        """The machine of a scene in scenes/, KIND:N of `sphaera gen`, or protein; spans tell its
        background, if the core has them."""
        tool, stem = f"{self.build}/sphaera", scene.replace("/", "_").replace(":", "_")
        built = self.folder / f"{stem}-{self.size}.sph"
        if built.exists():
            return built
        source = scene_file(tool, scene, self.folder / f"{stem}.nff")
        said(tool, "build", source, "--profile", "standard", "--size", self.size, "--depth", "2",
             "--background", "spans" if "spans" in effects else "none", "-o", built)
        return built

    def counted(self, scene, effects, core, *options):
        """Report of a frame that the core drew as the model does."""
        machine = self.machine(scene, effects)
        name = "-".join([machine.stem, *map(str, core), *(o.lstrip("-") for o in options)])
        path = self.folder / f"{name.replace('=', '')}.json"
        if not path.exists():
            print("  RUN ", path.stem, flush=True)
            with intact.beside(path) as new:
                said("sh", "sim/core.sh", "--machine", machine, "--json", new, *options,
                     EFFECTS=effects, BUILD=self.build, **core.variables())
        report = json.loads(path.read_text("utf-8"))
        if report["mismatches"]:
            sys.exit(f"rate: {path}: {report['mismatches']} pixels differ")
        return report


def cycles(report):
    return report["cold"]["counters"]["cycles"]
