# cores.py - cycles of scenes on cores with some number of units, as points of a sweep
# SPDX-License-Identifier: Apache-2.0
from collections import namedtuple

from ..sweep.run import measured

SPHERES = "shadow+reflect2+lights3+inside+spans"
GLASS = "shadow+reflect2+lights1+inside+facets+refract+specular+sum"


class Core(namedtuple("Core", "pipes leaf_units shades")):
    """Units of an engine; 0: by the rule of rt_core."""

    def axes(self):
        return {name: str(value) for name, value in self._asdict().items()}

    def variables(self):
        """Of sim/cores.py."""
        return {name.upper(): value for name, value in self.axes().items()}

    def name(self):
        given = [f"{n} {what}" for n, what in ((self.leaf_units, "leaf"), (self.shades, "shading"))
                 if n]
        return str(self.pipes) + (f", {' and '.join(given)}" if given else "")


def runs(build, what, size, asked):
    """{key: result} of the measure cycles; asked: {key: (scene, effects, axes)}. Spans tell the
    background, if the core has them. Frames are drawn as the model does, or this ends."""
    points = [{"scene": scene, "effects": effects, "size": size,
               "background": "spans" if "spans" in effects else "none", **more}
              for scene, effects, more in asked.values()]
    return dict(zip(asked, measured(build, what, "cycles", points)))


def cycles(run):
    return run["counters"]["cycles"]
