# frames.py - frame files and clocks of a run, and what pixels took
# SPDX-License-Identifier: Apache-2.0
"""Formats: cmodel/core/frame.h; --clocks of sim/core.sh."""
import struct
from array import array
from collections import namedtuple
from itertools import zip_longest
from pathlib import Path

Pixel = namedtuple("Pixel", "rendering l1 l2 id visits texture key")
HEAD, PIXEL = struct.Struct("<8s6I"), struct.Struct("<6IQ")
VERSION, LAYERS = 2, 3


class Bad(Exception):
    """A file that is not what it should be."""


class Frame:
    """width, height, and of each pixel, row by row, what the model or the core gave."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        if len(data) < HEAD.size:
            raise Bad(f"{path}: no frame file")
        magic, version, self.width, self.height, layers, counters, self.errors = \
            HEAD.unpack_from(data)
        if magic != b"SPHFRAME" or version != VERSION or layers != LAYERS:
            raise Bad(f"{path}: no frame file of version {VERSION}")
        begin = HEAD.size + 8 * counters
        end = begin + PIXEL.size * self.width * self.height
        if len(data) != end + 8:
            raise Bad(f"{path}: {len(data)} bytes, not {end + 8}")
        self.pixels = list(map(Pixel._make, PIXEL.iter_unpack(data[begin:end])))

    def at(self, x, y):
        return self.pixels[y * self.width + x]


def clocks(path, frame):
    """The clock in which each pixel left, 0: none did; or None if there is no such file."""
    if not Path(path).exists():
        return None
    words = array("I")
    words.frombytes(Path(path).read_bytes())
    if struct.pack("=H", 1) != struct.pack("<H", 1):
        words.byteswap()
    if len(words) != frame.width * frame.height:
        raise Bad(f"{path}: clocks of {len(words)} pixels, not of {frame.width}x{frame.height}")
    return words


def walk(window):
    """Pixels of a window in the order of rt_pixel_scan: columns of 8, row by row."""
    x0, y0, x1, y1 = window
    for left in range(x0, x1, 8):
        for y in range(y0, y1):
            for x in range(left, min(left + 8, x1)):
                yield x, y


def halves(window, walks):
    """The part of the window that each of one or two walks has, as rt_pixel_scans parts it."""
    x0, y0, x1, y1 = window
    middle = (x0 + x1 + 1) // 2
    return [window] if walks == 1 else [(x0, y0, middle, y1), (middle, y0, x1, y1)]


def in_turn(lists):
    """One of each list after the other, as long as they have some."""
    return [x for group in zip_longest(*lists) for x in group if x is not None]


def in_flight(frame, left, window, slots, walks):
    """Clocks from the one in which a slot was free for each pixel to the one in which it left, of a
    core with so many slots and walks that drew the window; 0 of those that were not traced. The
    n-th pixel starts when n - slots others have left, or a little later."""
    took = array("I", bytes(4 * len(left)))
    of_walks = [[y * frame.width + x for x, y in walk(half)] for half in halves(window, walks)]
    traced = in_turn([i for i in pixels if left[i] and frame.pixels[i].visits]
                     for pixels in of_walks)
    ends = sorted(left[i] for i in traced)
    for number, i in enumerate(traced):
        start = ends[number - slots] if number >= slots else 0
        took[i] = max(left[i] - start, 0)
    return took


def first_wrong(model, core, window):
    """x, y of the first pixel of the window that differs, by rows; None: none does."""
    x0, y0, x1, y1 = window
    for y in range(y0, y1):
        for x in range(x0, x1):
            a, b = model.at(x, y), core.at(x, y)
            if a._replace(visits=a.visits & 0xffffff) != b:
                return x, y
    return None
