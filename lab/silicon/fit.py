# fit.py - energy of events, fitted to frames of cores in standard cells
# SPDX-License-Identifier: Apache-2.0
"""Energy of a frame is what a clock of the idle core takes, times its clocks, and what each event
of EVENTS takes, times its count. The weights are those of the profile PROFILE that make the sum of
squares of relative errors least, none below 0; another profile scales all of them alike. A clock
costs in proportion to the LUT4eq of the core, a share of its own with triangles and without; 0: no
frame of the fit tells. Frames are rows of the table silicon.frames, of which those that are held
out are in no fit."""
from ..pages import data

SPHERES, TREES = "spheres", ("boxes", "bih")    # what a core walks: words of it, else spheres
EVENTS = {      # name: its counter, of cmodel/machine/machine.def; the tree whose cores have it
    "node visit": ("node_visits", SPHERES),
    "box visit": ("node_visits", "boxes"),
    "BIH step": ("node_visits", "bih"),
    "sphere test": ("leaf_tests", None),
    "triangle test": ("facet_tests", None),
    "texel": ("texels", None),
    "primary ray": ("rays_primary", None),
    "shadow ray": ("rays_shadow", None),
    "reflected ray": ("rays_reflected", None),
    "refracted ray": ("rays_refracted", None),
}
PROFILE, TRIANGLES = "standard", "facets"
FREE = {"camera", "none"}   # words of cores that make no events of their own
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
    """Weights, none below 0, of columns that are not empty."""
    on = [i for i, column in enumerate(zip(*rows)) if any(column)]
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


def words(core):
    """Of a list of effects, without their counts."""
    return {word.rstrip("0123456789") for word in core.split("+")}


def counts(counters, core):
    """Of each of EVENTS, in a frame of the core."""
    walked = next((tree for tree in TREES if tree in words(core)), SPHERES)
    return [counters[name] if tree in (None, walked) else 0 for name, tree in EVENTS.values()]


class Model:
    """nJ: weights of EVENTS, {profile: their scale}, {profile: a clock for each LUT4eq of a core
    without triangles, of one with them}; the words of cores that it is for."""

    def __init__(self, weights, scales, clocks, known):
        self.weights, self.scales, self.clocks, self.words = weights, scales, clocks, known

    def parts(self, frame):
        """{part: nJ} of a frame's clocks and events; parts that it has none of are left out."""
        profile, events = frame["profile"], [frame[name] for name in COUNTS]
        clock = self.clocks[profile][TRIANGLES in words(frame["effects"])]
        found = {CLOCK: clock * frame["LUT4eq"] * frame["cycles"]}
        return found | {name: self.scales[profile] * weight * count for name, weight, count in
                        zip(EVENTS, self.weights, events) if count}


def known_words(frames):
    return FREE.union(*(words(frame["effects"]) for frame in frames if frame["fit"] == "in"))


def fitted(frames):
    """Of frames, dictionaries of numbers by the names of columns."""
    def events(frame):
        return [frame[name] for name in COUNTS]

    def busy(frame):
        return frame["nJ"] - frame["idle pJ"] * frame["cycles"] / 1000

    def clock(of, triangles):
        each = [frame["idle pJ"] / frame["LUT4eq"] / 1000 for frame in of
                if (TRIANGLES in words(frame["effects"])) == triangles]
        return sum(each) / max(1, len(each))
    known = [frame for frame in frames if frame["fit"] == "in"]
    base = [frame for frame in known if frame["profile"] == PROFILE]
    weights = least_squares([[count / frame["nJ"] for count in events(frame)] for frame in base],
                            [busy(frame) / frame["nJ"] for frame in base])
    scales, clocks = {}, {}
    for profile in dict.fromkeys(frame["profile"] for frame in known):
        own = [frame for frame in known if frame["profile"] == profile]
        sums = [(busy(frame), sum(map(float.__mul__, weights, events(frame)))) for frame in own]
        scales[profile] = 1.0 if profile == PROFILE else \
            sum(of / by for of, by in sums) / len(sums)
        clocks[profile] = clock(own, False), clock(own, True)
    return Model(weights, scales, clocks, known_words(known))


def frames_of(table):
    """Column names and rows as dictionaries of numbers."""
    def number(word):
        try:
            return float(word)
        except ValueError:
            return word
    head, rows = table
    return [dict(zip(head, map(number, row))) for row in rows]


def model():
    """Of the tables that pages have."""
    weights = dict(data.read("silicon.events")[1])
    _, profiles = data.read("silicon.profiles")
    return Model([float(weights.get(name, 0)) for name in EVENTS],
                 {row[0]: float(row[1]) for row in profiles},
                 {row[0]: [float(cell) / 1e6 for cell in row[2:]] for row in profiles},
                 known_words(frames_of(data.read("silicon.frames"))))
