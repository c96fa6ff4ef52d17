# pixel.py - the rays of one pixel, stage by stage
# SPDX-License-Identifier: Apache-2.0
from typing import Any, List, NamedTuple, Optional, Tuple

from ._library import ffi, lib, text


class Ray(NamedTuple):
    """A ray as it was traced."""
    kind: str                       # "primary", "shadow", "reflected", "refracted"
    parent: Optional[int]           # number of the ray at whose hit it starts; None: the eye
    depth: int                      # reflections and refractions before it
    origin: Tuple[int, int, int]    # grid units
    direction: Tuple[int, int, int]
    hit: bool                       # something; of a shadow ray: the light is hidden
    id: Optional[int]               # None: nothing, or of a shadow ray
    key: int
    inside: bool
    visits: int


class Operand(NamedTuple):
    """A word that a stage works with or gives; a vector is three of one name."""
    name: str
    bits: int
    signed: bool
    word: int       # its bits
    value: float    # what it stands for; lengths in units of the scene


class Stage(NamedTuple):
    """A stage of a ray."""
    name: str            # "set-up", "filter", "root", ...
    ray: Optional[int]   # its number; None: of the pixel
    visit: int           # of a tree node, from 1; 0: none
    number: int          # of child, primitive, texel or light
    operands: List[Operand]
    text: str            # as `sphaera info` prints it


class Pixel(NamedTuple):
    """Rays in the order in which they are traced; stages ray by ray."""
    rays: List[Ray]
    stages: List[Stage]


def rays_of(pointer: Any) -> List[Ray]:
    """Of a sphaera_pixel."""
    ray, rays = ffi.new("sphaera_ray *"), []  # type: ignore[var-annotated]
    while not lib.sphaera_pixel_ray(pointer, len(rays), ray):
        rays.append(Ray(text(ray.kind), ray.parent if ray.parent >= 0 else None, ray.depth,
                        tuple(ray.origin), tuple(ray.direction), bool(ray.hit),
                        ray.id if ray.id != lib.SPHAERA_NONE else None, ray.key, bool(ray.inside),
                        ray.visits))
    return rays


def operands_of(pointer: Any, stage: int) -> List[Operand]:
    """Of a stage of it."""
    o, operands = ffi.new("sphaera_operand *"), []  # type: ignore[var-annotated]
    while not lib.sphaera_pixel_operand(pointer, stage, len(operands), o):
        operands.append(Operand(text(o.name), o.bits, bool(o.is_signed), o.high << 64 | o.low,
                                o.value))
    return operands


def pixel_of(pointer: Any) -> Pixel:
    """Of a sphaera_pixel."""
    s, stages = ffi.new("sphaera_stage *"), []  # type: ignore[var-annotated]
    while not lib.sphaera_pixel_stage(pointer, len(stages), s):
        stages.append(Stage(text(s.name), s.ray if s.ray >= 0 else None, s.visit, s.number,
                            operands_of(pointer, len(stages)),
                            text(lib.sphaera_pixel_text(pointer, len(stages)))))
    return Pixel(rays_of(pointer), stages)
