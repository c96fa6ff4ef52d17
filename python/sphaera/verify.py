# verify.py - hardware against the golden model: frames, and single units
# SPDX-License-Identifier: Apache-2.0
"""For benches in Python, such as those of cocotb: docs/reference/library.md."""
from typing import Any, Mapping, NamedTuple, Sequence, Tuple, Union

from ._library import call, ffi, lib, made, text
from .machine import Machine


class Scoreboard:
    """A frame of another core against the model's. What the core gives is told as it comes, in any
    order; each method says whether the model has the same."""

    def __init__(self, machine: Machine, threads: int = 0) -> None:
        """Draws the machine. Error: as of Machine.render()."""
        self._pointer = made(lib.sphaera_scoreboard_new, lib.sphaera_scoreboard_free,
                             "sphaera_scoreboard", machine._pointer, threads)

    def pixel(self, x: int, y: int, colours: Sequence[int],
              id: int,  # pylint: disable=redefined-builtin
              key: int, visits: int, texture: int) -> bool:
        """A pixel of the pixel port; colours: Rendering, L1, L2, each 0xBBGGRR. One outside the
        window, or that came before, is a difference."""
        return not lib.sphaera_scoreboard_pixel(self._pointer, x, y, *colours, id, key, visits,
                                                texture)

    def colour(self, x: int, y: int, colour: int) -> bool:
        """The same of the colour alone that register FRAME selects."""
        return not lib.sphaera_scoreboard_colour(self._pointer, x, y, colour)

    def counters(self, counters: Mapping[Union[int, str], int]) -> bool:
        """Counters by number or name, at the end; those that the model has not never differ.
        KeyError: a name that is none."""
        same = True
        for which, value in counters.items():
            number = which if isinstance(which, int) else \
                lib.sphaera_counter_find(which.encode())
            if number < 0:
                raise KeyError(which)
            same &= not lib.sphaera_scoreboard_counter(self._pointer, number, value)
        return same

    def errors(self, bits: int) -> bool:
        """The sticky errors, at the end."""
        return not lib.sphaera_scoreboard_errors(self._pointer, bits)

    def end(self) -> int:
        """The end of a frame: how many differences it has, pixels that did not come among them.
        The next frame of the same machine is expected then."""
        return lib.sphaera_scoreboard_end(self._pointer)

    @property
    def text(self) -> str:
        """Lines on the first difference, with the stages of all rays of its pixel; "": none."""
        return text(lib.sphaera_scoreboard_text(self._pointer))


def unit_vector(bits: int, v: Sequence[int]) -> Tuple[Tuple[int, int, int], int, int]:
    """rt_unit: u s1.16, scale u1.16 and shift of a vector of `bits` bits, 9 to 32. Error: a number
    out of range, here as below."""
    u, scale, shift = ffi.new("int32_t[3]"), ffi.new("uint32_t *"), ffi.new("int *")
    call(lib.sphaera_model_unit_vector, bits, list(v), u, scale, shift)
    return (u[0], u[1], u[2]), scale[0], shift[0]


def root(x: int, bits: int = 0) -> Tuple[int, bool]:
    """rt_isqrt: the floor of the root of x, its `bits` most significant bits, 0: all; and whether
    its square is less."""
    found, inexact = ffi.new("uint64_t *"), ffi.new("int *")
    call(lib.sphaera_model_root, x >> 64, x & (1 << 64) - 1, bits, found, inexact)
    return found[0], bool(inexact[0])


def quotient(key: int, key_bits: int, a: int, a_bits: int, pq: int) -> Tuple[int, int]:
    """rt_quotient: mant of pq bits, exp, key / a = mant * 2^-exp."""
    mant, exp = ffi.new("uint32_t *"), ffi.new("int *")
    call(lib.sphaera_model_quotient, key, key_bits, a, a_bits, pq, mant, exp)
    return mant[0], exp[0]


class LeafResult(NamedTuple):
    """Of leaf()."""
    hit: bool
    far: bool
    exit: bool
    b: int
    disc: int   # of a hit without exit
    key: int    # of a hit; 0: none


def leaf(origin: Sequence[int], direction: Sequence[int], centre: Sequence[int], radius: int,
         **more: Any) -> LeafResult:
    """rt_leaf: the exact test of a sphere. more: id, skip_id (NONE: no sphere), skip_inside,
    shadow, inside_on, pr."""
    given = ffi.new("sphaera_leaf *", {"origin": list(origin), "direction": list(direction),
                                       "centre": list(centre), "radius": radius,
                                       "skip_id": lib.SPHAERA_NONE, **more})
    r = ffi.new("sphaera_leaf_result *")
    call(lib.sphaera_model_leaf, given, r)
    return LeafResult(bool(r.hit), bool(r.far), bool(r.exit), r.b, r.disc_high << 64 | r.disc_low,
                      r.key)


def node_filter(**operands: Any) -> Tuple[bool, int]:
    """rt_filter: whether a child may hold a hit, and the least depth that it reaches. operands, as
    its ports: origin, least, p_a, p_b, q, axis, negative, depth_max, centre, radius."""
    passes, near = ffi.new("int *"), ffi.new("int32_t *")
    call(lib.sphaera_model_filter, ffi.new("sphaera_filter *", operands), passes, near)
    return bool(passes[0]), near[0]


def texel(near: Sequence[int], far: Sequence[int], near_weights: Sequence[int],
          far_weights: Sequence[int], level: int) -> int:
    """rt_texel_filter: 0xBBGGRR out of four texels of two levels, weights u0.8 of x+1 and y+1 of
    each, and of the second level."""
    found = ffi.new("uint32_t *")
    call(lib.sphaera_model_texel, list(near), list(far), list(near_weights), list(far_weights),
         level, found)
    return found[0]
