# fit.py - energy of events, fitted to frames of cores in standard cells
# SPDX-License-Identifier: Apache-2.0
"""Energy of a frame is what a clock of the idle core takes, times its clocks, and what each event
of EVENTS takes, times its count. The weights are those of the profile PROFILE that make the sum of
squares of relative errors least, none below 0; another profile scales all of them alike. A clock
costs in proportion to the LUT4eq of the core. Frames are rows of the table silicon.frames, of which
those that are held out are in no fit."""
from ..pages import data

EVENTS = {      # name: counters that are added up, of cmodel/machine/machine.def
    "node visit": ("node_visits",),
    "leaf test": ("leaf_tests",),
    "primary ray": ("rays_primary",),
    "shadow ray": ("rays_shadow",),
    "later ray": ("rays_reflected", "rays_refracted"),
}
PROFILE = "standard"
WORDS = {"shadow", "reflect", "lights", "inside", "camera", "none"}     # of cores that it is for
CLOCK, COUNTS = "idle clock", [f"{name}s" for name in EVENTS]


def solved(matrix, right):
    """Of a symmetric system, by elimination."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for at in range(size):
        pivot = max(range(at, size), key=lambda row: abs(rows[row][at]))
        rows[at], rows[pivot] = rows[pivot], rows[at]
        for row in range(at + 1, size):
            factor = rows[row][at] / rows[at][at]
            rows[row] = [a - factor * b for a, b in zip(rows[row], rows[at])]
    found = [0.0] * size
    for at in reversed(range(size)):
        found[at] = (rows[at][size] - sum(rows[at][k] * found[k]
                                          for k in range(at + 1, size))) / rows[at][at]
    return found


def least_squares(rows, values):
    """Weights, none below 0."""
    on = list(range(len(rows[0])))
    while True:
        matrix = [[sum(row[i] * row[j] for row in rows) for j in on] for i in on]
        found = solved(matrix, [sum(row[i] * value for row, value in zip(rows, values))
                                for i in on])
        if min(found) >= 0:
            break
        on.pop(found.index(min(found)))
    weights = [0.0] * len(rows[0])
    for i, weight in zip(on, found):
        weights[i] = weight
    return weights


def counts(counters):
    return [sum(counters[name] for name in names) for names in EVENTS.values()]


class Model:
    """nJ: weights of EVENTS, {profile: their scale}, {profile: a clock for each LUT4eq}."""

    def __init__(self, weights, scales, clocks):
        self.weights, self.scales, self.clocks = weights, scales, clocks

    def parts(self, profile, lut4eq, cycles, events):
        """{part: nJ} of so many clocks and events."""
        found = {CLOCK: self.clocks[profile] * lut4eq * cycles}
        return found | {name: self.scales[profile] * weight * count for name, weight, count in
                        zip(EVENTS, self.weights, events)}


def fitted(frames, lut4eq):
    """Of frames, dictionaries of numbers by the names of columns; lut4eq: {profile: LUT4eq}."""
    def events(frame):
        return [frame[name] for name in COUNTS]

    def busy(frame):
        return frame["nJ"] - frame["idle pJ"] * frame["cycles"] / 1000
    known = [frame for frame in frames if frame["fit"] == "in"]
    base = [frame for frame in known if frame["profile"] == PROFILE]
    weights = least_squares([[count / frame["nJ"] for count in events(frame)] for frame in base],
                            [busy(frame) / frame["nJ"] for frame in base])
    scales, clocks = {}, {}
    for profile in {frame["profile"] for frame in known}:
        own = [frame for frame in known if frame["profile"] == profile]
        sums = [(busy(frame), sum(map(float.__mul__, weights, events(frame)))) for frame in own]
        scales[profile] = 1.0 if profile == PROFILE else \
            sum(of / by for of, by in sums) / len(sums)
        clocks[profile] = sum(frame["idle pJ"] for frame in own) / len(own) / 1000 / lut4eq[profile]
    return Model(weights, scales, clocks)


def frames_of(rows):
    """Rows, the column names first, as dictionaries of numbers."""
    def number(word):
        try:
            return float(word)
        except ValueError:
            return word
    head, *found = rows
    return [dict(zip(head, map(number, row))) for row in found]


def model():
    """Of the tables that pages have."""
    _, weights = data.read("silicon.events")
    _, profiles = data.read("silicon.profiles")
    return Model([float(row[1]) for row in weights],
                 {row[0]: float(row[1]) for row in profiles},
                 {row[0]: float(row[2]) / 1e6 for row in profiles})


def told(profile, core, lut4eq, counters):
    """{part: nJ} of a frame; None if nothing is known of such a core."""
    of = model()
    words = {word.rstrip("0123456789") for word in core.split("+")}
    if profile not in of.scales or not words <= WORDS or not lut4eq:
        return None
    return of.parts(profile, lut4eq, counters["cycles"], counts(counters))
