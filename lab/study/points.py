# points.py - which runs make up the study
# SPDX-License-Identifier: Apache-2.0
"""What is to be shown first stands first: a study that is broken off has measured that."""
from ..sweep.axes import job

PROFILES = ["draft", "standard", "fine", "reference"]
# knob: widths around standard, alone; w and wd go together upwards since w + 1 <= wd
KNOBS = {
    "w": ["standard:w=12,fw=12", "standard:w=14", "standard", "standard:w=18,wd=19",
          "standard:w=20,wd=21"],
    "wd": ["standard", "standard:wd=19", "standard:wd=21"],
    "pr": [f"standard:pr={n}" for n in (8, 12, 16, 20)] + ["standard"],
    "pq": [f"standard:pq={n}" for n in (9, 11, 13, 15)] + ["standard", "standard:pq=20"],
    "ng": [f"standard:ng={n}" for n in (0, 1)] + ["standard", "standard:ng=4"],
    "fw": [f"standard:fw={n}" for n in (9, 12)] + ["standard"],
    "w, pq": ["standard:w=18,wd=19,pq=20", "standard:w=18,wd=19,pq=20,pr=14",
              "standard:w=20,wd=21,pq=24", "fine:pr=16"],
}
# rate knobs: the picture is the same
RATES = [{}, {"engines": 2}, {"root_step": 2}, {"root_step": 4}, {"quotient_step": 1},
         {"quotient_step": 4}]
# beside the profiles these cores are simulated and synthesised; the others are pictures alone
KNOB_CORES = ["standard:pr=12", "standard:w=18,wd=19,pq=20,pr=14", "standard:pq=13",
              "standard:fw=12", "standard:w=14", "standard:wd=21", "standard:ng=0"]
SCENES = ["sphereflake:3", "protein", "paper100", "huge_tiny", "interpenetrating"]
CORE = "shadow+reflect2+lights3+inside"  # what the nearest hit in all of SCENES calls for
PICTURE, FRAME = "320x180", "96x54"      # of accuracy, of the RTL
# kinds of scenes: what `sphaera price` is told, and the core that the scene then asks for, of which
# cells and clock are
KINDS = {
    "spheres": (dict(scene="sphereflake:3", build_more="--inside on"), CORE),
    "triangles": (dict(scene="facets/room"), "shadow+reflect2+lights2+inside+facets+turned+boxes"),
    "glass": (dict(scene="refraction/nested"),
              "shadow+reflect2+lights1+inside+facets+refract+specular+sum"),
    "textures": (dict(scene="texture/hall"),
                 "shadow+reflect2+lights1+inside+facets+texture+spread"),
}
# the same in cycles alone: other trees over the same triangles
TREES = {
    "triangles, spheres around them": dict(scene="facets/room", accel="bvh4"),
    "triangles, BIH": dict(scene="facets/room", accel="bih"),
}
# the papers' trades, on a core that can all of it
TRADES = [{}] + [{"background": b} for b in ("rect", "spans", "exact")] \
    + [{"background": "exact", "levels": 1}] \
    + [{"traverse": "first"}, {"traverse": "first", "tree": "paper"}, {"tree": "paper"}] \
    + [{"depth": d} for d in (0, 1)]
# the short form, for continuous integration: no synthesis, one small core
SHORT_SCENES, SHORT_SIZE, SHORT_CORE = ["paper5"], "32x18", "shadow+reflect2+lights1"
SHORT_PROFILES = ["draft", "standard", "standard:pq=11"]


def widths():
    """Every profile of the study once."""
    return list(dict.fromkeys(PROFILES + [p for knob in KNOBS.values() for p in knob]))


def cores():
    """Every core: axes of it."""
    return [dict(profile=p, effects=CORE) for p in PROFILES] \
        + [dict(profile="standard", effects=CORE, **r) for r in RATES if "engines" in r] \
        + [dict(profile="standard", effects=CORE, **r) for r in RATES if r and "engines" not in r] \
        + [dict(profile=p, effects=CORE) for p in KNOB_CORES]


def price(words):
    """The job of all profiles of one of KINDS or TREES."""
    return job("price", size=PICTURE, **words)


def trade(words, scene, kind):
    """One trade on a scene; the picture against a truth of two reflections."""
    if kind == "accuracy":
        return job(kind, scene=scene, size=PICTURE, **({"truth": 2} if "depth" in words else {}),
                   **words)
    core = CORE + "+cones4" if "levels" in words else "all"  # all: one cone
    return job(kind, scene=scene, size=FRAME, effects=core, **words)


def plan():
    """All jobs of the study, the most important first."""
    keys = [price(words) for words in [of for of, _ in KINDS.values()] + list(TREES.values())]
    keys += [job("cells", profile=p, effects=core) for _, core in KINDS.values() for p in PROFILES]
    keys += [job("accuracy", profile=p, scene=s, size=PICTURE) for p in widths() for s in SCENES]
    keys += [trade(t, s, "accuracy") for t in TRADES for s in SCENES]
    runs = [[job("cycles", scene=s, size=FRAME, **c) for s in SCENES] + [job("cells", **c)]
            for c in cores()]
    first = len(PROFILES) + 1
    keys += sum(runs[:first], [])
    # the paper's tree takes 25 times the visits, and the simulation as long: its pictures alone
    keys += [trade(t, s, "cycles") for t in TRADES if "tree" not in t for s in SCENES]
    keys += sum(runs[first:], [])
    return list(dict.fromkeys(keys))


def short():
    """Some small ones: pictures, and one core."""
    keys = [job("accuracy", profile=p, scene=s, size=SHORT_SIZE)
            for p in SHORT_PROFILES for s in SHORT_SCENES]
    return keys + [job("cycles", profile="standard", effects=SHORT_CORE, scene=s, size=SHORT_SIZE)
                   for s in SHORT_SCENES] \
        + [job("price", scene=s, size=SHORT_SIZE) for s in SHORT_SCENES]
