# scenes.py - the scenes that are drawn by POV-Ray, by the double reference and by the model
# SPDX-License-Identifier: Apache-2.0
from pathlib import Path

from ..runner import PROTEIN

SIZE = (320, 180)
PROFILES = ["auto", "draft", "standard", "fine", "reference"]
GENERATED = ["balls:3", "mount:4", "tetra:4", "shells:4", "rings:3", "lattice:3", "jacks:3",
             "tree:4", "sphereflake:4", "icosphere:4", "random:1000", "scenario2:64", "cover",
             "cornell", "horizon"]
DEPTH = {"refraction": 4}  # of a folder; 2 elsewhere
FILTER = ["--filter", "nearest"]  # as images are exported
LEFT = {"empty": "nothing is in it"}
MORE = [Path("tests/scenes/refraction/eye_in_glass.nff")]
# drawn if they are named, for points.py
BY_NAME = [("clear_facets", Path("scenes/effects/effects.nff:clear_facets"))]
COINCIDENT = Path("tests/scenes/coincident")  # surfaces in one place, edges through pixels


def files():
    """[(name, path)] of the scenes of the tree."""
    found = sorted(Path("scenes").glob("*.nff"))
    for folder in "facets", "refraction", "texture":
        found += sorted(Path("scenes", folder).glob("*.nff"))
    return [(path.stem, path) for path in found + MORE if path.stem not in LEFT]


def coincident():
    """The same of scenes that are compared with exact numbers."""
    return [(path.stem, path) for path in sorted(COINCIDENT.glob("*.nff"))]


def named():
    """The same, and those that are drawn if they are named."""
    return files() + BY_NAME


def depth(path):
    """Reflections and refractions one after another."""
    return DEPTH.get(Path(path).parent.name, 2)
