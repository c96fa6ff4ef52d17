# gather.py - results of the study put together: what a profile, a core, a trade amounts to
# SPDX-License-Identifier: Apache-2.0
"""Every function gives None where a result is missing; tables show a dash then."""
import math

from ..pages import whole
from ..sweep import axes
from ..sweep.run import Results
from . import points

# scenes that every profile can take: means are over these
COMMON = [s for s in points.SCENES if s != "huge_tiny"]
CEILING = 70.0  # dB that an equal picture counts as in a mean


class Study(Results):
    def __init__(self, folder):
        super().__init__(folder)
        self.planned = set(points.plan())

    def get(self, key):
        if key in self.planned and self.look(key) is None:
            whole.lack(f"no result of {key}")  # that counts
        return self.look(key)

    def accuracy(self, profile, scene):
        return self.get(axes.job("accuracy", profile=profile, scene=scene, size=points.PICTURE))

    def cycles(self, core, scene, **words):
        return self.get(axes.job("cycles", scene=scene, size=points.FRAME, **core, **words))

    def price(self, words):
        """{profile: row of `sphaera price`} of one of points.KINDS or points.TREES."""
        run = self.get(points.price(words))
        return {row["profile"]: row for row in run["rows"]} if run else {}

    def cells(self, core):
        run = self.get(axes.job("cells", **core))
        return run and run["core"]


def psnr(run):
    """Of the deepest layer; None for no result or a refusal."""
    if run is None or "refused" in run:
        return None
    value = run["accuracy"]["psnr"][-1]
    return CEILING if value is None else value


def mean(values):
    values = list(values)
    return None if not values or None in values else sum(values) / len(values)


def total(values):
    values = list(values)
    return None if None in values else sum(values)


def mean_psnr(study, profile):
    return mean(psnr(study.accuracy(profile, s)) for s in COMMON)


def wrong(study, profile, name, scenes=None):
    """Pixels of a kind of mistake, summed over scenes."""
    runs = [study.accuracy(profile, s) for s in scenes or COMMON]
    return total(None if r is None or "refused" in r else r["accuracy"][name] for r in runs)


def worst(study, profile, name, scenes=None):
    runs = [study.accuracy(profile, s) for s in scenes or COMMON]
    values = [None if r is None or "refused" in r else r["accuracy"][name] for r in runs]
    return None if None in values else max(values)


def mean_of(study, profile, name):
    """Mean of the scenes."""
    runs = [study.accuracy(profile, s) for s in COMMON]
    return mean(None if r is None or "refused" in r else r["accuracy"][name] for r in runs)


def pixels(size):
    width, height = size.split("x")
    return int(width) * int(height)


def frame_cycles(study, core, scenes=None):
    """Cycles of a frame, mean of the scenes."""
    runs = [study.cycles(core, s) for s in scenes or COMMON]
    return mean(None if r is None or "refused" in r else r["counters"]["cycles"] for r in runs)


def ray_cycles(study, core, scenes=None):
    """Cycles over rays of all kinds, of all the scenes together."""
    runs = [study.cycles(core, s) for s in scenes or COMMON]
    if any(r is None or "refused" in r for r in runs):
        return None
    rays = sum(r["counters"][f"rays_{k}"] for r in runs
               for k in ("primary", "shadow", "reflected"))
    return sum(r["counters"]["cycles"] for r in runs) / rays


def model_milliseconds(study, profile):
    """Of the golden model's one thread for a frame of points.FRAME, by its pixels."""
    seconds = mean_of_runs(study.accuracy(profile, s) for s in COMMON)
    return seconds and 1000 * seconds * pixels(points.FRAME) / pixels(points.PICTURE)


def simulation_milliseconds(study, core):
    """Of the core simulated by Verilator, one thread, a frame of points.FRAME."""
    seconds = mean_of_runs(study.cycles(core, s) for s in COMMON)
    return seconds and 1000 * seconds


def mean_of_runs(runs):
    """Processor seconds of runs, their mean."""
    return mean(r and r.get("cpu_seconds", r.get("cpu")) for r in runs)


def core_of(profile):
    return {"profile": profile, "effects": points.CORE}


def error(db):
    """Root mean square of the error of a channel, of 255."""
    return 255 / math.pow(10, db / 20)
