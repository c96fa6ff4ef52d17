# __init__.py - import sphaera: scenes, machines, and the golden model's frames as NumPy arrays
# SPDX-License-Identifier: Apache-2.0
"""Golden model of a ray tracer in hardware.

    scene = sphaera.read("scenes/paper100.nff")
    frame = scene.build(profile="standard", width=320, height=180).render()
    frame.rgb()                    # uint8 [180, 320, 3]
    frame.counters["node_visits"]

A Scene is what a user wrote, a Machine all that the hardware sees, a Frame what the model draws
of it, bit by bit what the hardware gives. None of them changes once it is made.

Errors: whatever the library refuses raises sphaera.Error with the tool's message, which names
file, line and field. What is no text or number at all raises TypeError, a number that C has no
room for OverflowError.

Threads: other Python threads go on while the library reads, builds, draws or traces, and any
number of them may use the same object."""
from . import verify
from ._library import Error, Record, version
from .frame import Frame, Layers
from .machine import Hit, Hits, Machine, counter_names, exact_counters, register_names
from .pixel import Operand, Pixel, Ray, Stage
from .price import Price, Row
from .scene import Scene, parse, read, scene_of
from .verify import Scoreboard

NONE = Frame.NONE
__version__ = version()
__all__ = ["Error", "Frame", "Hit", "Hits", "Layers", "Machine", "NONE", "Operand", "Pixel",
           "Price", "Ray", "Record", "Row", "Scene", "Scoreboard", "Stage", "counter_names",
           "exact_counters", "parse", "read", "register_names", "scene_of", "verify", "version"]
