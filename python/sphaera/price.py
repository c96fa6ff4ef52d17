# price.py - what accuracy costs in time: a row for each profile
# SPDX-License-Identifier: Apache-2.0
from typing import Any, List, NamedTuple, Optional

from ._library import lib, ffi, text


class Row(NamedTuple):
    """One machine of a scene; why is None, or says that it could not be built: the rest is 0."""
    name: str
    why: Optional[str]
    psnr: float                 # dB measured, infinite: equal
    psnr_least: float           # of the whole frame, at least
    psnr_expected: float        # before anything is drawn, at least; 0: not known
    pixels: int                 # that were looked at
    undecidable: int            # of them, that double precision cannot tell: they do not count
    wrong: int                  # of them, that see another object
    wrong_most: float           # part of the whole frame's pixels that does, at most
    keeps: bool                 # what was asked for
    cycles_per_pixel: float     # of one engine
    lut4eq: int                 # cells of this very core on an ECP5; 0: nobody has made it
    mult: int
    bram: int
    mhz: float                  # its clock, routed; 0: not known
    milliseconds: float         # a frame at it


class Price(NamedTuple):
    """rows, and the number of the cheapest that keeps what was asked for, None: none does."""
    rows: List[Row]
    best: Optional[int]


def price_of(pointer: Any) -> Price:
    """Of a sphaera_price."""
    rows = []
    for number in range(lib.sphaera_price_rows(pointer)):
        row = ffi.new("sphaera_price_row *")
        lib.sphaera_price_get(pointer, number, row)
        words = {name: getattr(row, name) for name in Row._fields[2:]}
        words["keeps"] = bool(row.keeps)
        rows.append(Row(text(row.name), text(row.why) if row.why else None, **words))
    best = lib.sphaera_price_best(pointer)
    return Price(rows, best if best >= 0 else None)
