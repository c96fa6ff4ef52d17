#!/usr/bin/env python3
# images.py - makes the images of this folder: tiles.png, globe.png, letter.png
# SPDX-License-Identifier: Apache-2.0
#
# usage: python3 scenes/texture/images.py      from the root; needs nothing but Python
import os
import struct
import zlib


def write(name, width, height, colour):
    """8-bit RGB PNG; colour(x, y) is (r, g, b)."""
    rows = b"".join(
        b"\0" + b"".join(bytes(colour(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    with open(os.path.join(os.path.dirname(__file__), name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def tiles(x, y):
    """8 x 8 tiles in three colours with thin joints."""
    if x % 64 < 3 or y % 64 < 3:
        return 60, 60, 60
    return ((225, 215, 190), (120, 70, 60), (225, 215, 190), (70, 90, 110))[(x // 64 + y // 64) % 4]


def globe(x, y):
    """Meridians and parallels, warm in the north, cool in the south; the seam is red."""
    if x < 4 or x >= 508:
        return 220, 30, 30
    if x % 64 < 3 or y % 64 < 3:
        return 250, 250, 250
    return 200 - y // 2, 110 + (x // 64 * 37 + y // 64 * 59) % 60, 60 + y // 2


def letter(x, y):
    """F, which no turn or mirror makes itself, on stripes."""
    if 24 <= x < 44 and 16 <= y < 112 or 24 <= x < 100 and (16 <= y < 36 or 56 <= y < 74):
        return 30, 30, 120
    return (250, 220, 90) if (x + y) // 16 % 2 else (240, 160, 60)


write("tiles.png", 512, 512, tiles)
write("globe.png", 512, 256, globe)
write("letter.png", 128, 128, letter)
