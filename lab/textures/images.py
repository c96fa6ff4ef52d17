# images.py - makes the images of scenes/texture
# SPDX-License-Identifier: Apache-2.0
import os
import struct
import zlib


def write(folder, name, width, height, colour):
    """8-bit RGB PNG of linear light (gAMA 1); colour(x, y) is (r, g, b)."""
    rows = b"".join(
        b"\0" + b"".join(bytes(colour(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    with open(os.path.join(folder, name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                   chunk(b"gAMA", struct.pack(">I", 100000)) +
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


def noise(x, y):
    """0 .. 255, the same on every machine."""
    v = (x * 73856093 ^ y * 19349663) & 0xffffffff
    return (v ^ v >> 13) * 0x5bd1e995 >> 15 & 255


def wood(x, y):
    """Planks of 64 rows with grain along them."""
    plank = y // 64
    if y % 64 < 2 or (x + plank * 77) % 256 < 2:
        return 60, 38, 20
    grain = (noise(plank, y) >> 4) + ((x + y * y // 24) // 16 % 3) * 4
    return 140 + grain * 2, 92 + grain * 2, 48 + grain


def wall(x, y):
    """Wallpaper: stripes, and a flower in every other square of 64."""
    dx, dy = x % 64 - 32, (y + x // 64 % 2 * 32) % 64 - 32
    r = dx * dx + dy * dy
    if r < 30:
        return 250, 220, 90
    if r < 220 and (dx * dy // 24) % 2 == 0:
        return 180, 60, 70
    return (206, 214, 190) if x % 16 < 3 else (232, 228, 208)


def metal(x, y):
    """Panels of 64 with rivets at the corners."""
    dx, dy = x % 64, y % 64
    if dx < 2 or dy < 2:
        return 52, 58, 66
    ax, ay = min(dx, 66 - dx) - 8, min(dy, 66 - dy) - 8
    if ax * ax + ay * ay < 10:
        return 236, 236, 240
    grey = 140 + 24 * ((x // 64 + y // 64) % 2) + (noise(y, x // 64) >> 4)
    return grey, grey, grey + 12


def ground(x, y):
    """Slabs of 128 x 64 with grit."""
    row = y // 64
    if y % 64 < 3 or (x + row % 2 * 64) % 128 < 3:
        return 70, 66, 60
    grey = 150 + noise((x + row % 2 * 64) // 128, row) // 8 + (noise(x // 4, y // 4) >> 6) * 9
    return grey, grey - 6, grey - 18


def parquet(x, y):
    """Squares of four strips, lying and standing by turns."""
    lying = (x // 64 + y // 64) % 2
    along, across = (x, y) if lying else (y, x)
    if across % 16 < 1 or along % 64 < 1:
        return 58, 36, 20
    tone = (noise(x // 64 * 8 + across // 16, y // 64) >> 4) + 8 * lying
    return 158 + tone * 2, 104 + tone * 2, 56 + tone


def face(x, y):
    """Two eyes and a mouth in the middle, seams around."""
    dx, dy = abs(x - 128), y - 60
    if (dx - 20) ** 2 + dy * dy < 60:
        return 20, 30, 40
    if (dx - 20) ** 2 + dy * dy < 130:
        return 250, 210, 60
    if dx < 24 and 22 <= dy < 30:
        return (30, 30, 30) if dx % 8 < 2 else (200, 60, 50)
    return (70, 76, 86) if x % 32 < 2 or y % 32 < 2 else (176, 182, 194)


def rings(x, y):
    """Painting: rings of three colours around two points."""
    near = min((x - 70) ** 2 + (y - 60) ** 2, (x - 170) ** 2 + (y - 110) ** 2)
    ring = 0
    while ring * ring < near:
        ring += 1
    return ((220, 60, 50), (245, 215, 120), (40, 70, 130), (240, 240, 230))[ring // 6 % 4]


def blocks(x, y):
    """Painting: fields of plain colours between black bars."""
    columns, rows = (0, 52, 68, 150, 214, 240), (0, 30, 90, 104, 160)
    i = sum(x >= c for c in columns) - 1
    j = sum(y >= r for r in rows) - 1
    if x - columns[i] < 5 or y - rows[j] < 5:
        return 16, 16, 16
    return ((240, 238, 230), (200, 30, 30), (240, 238, 230), (30, 60, 150), (245, 210, 40))[
        (i * 3 + j * 2) % 5]


def threads(x, y):
    """Painting: fine threads, the hardest to show without aliasing."""
    if (x + y) % 4 < 2:
        return (30, 90, 80) if (x - y) % 6 < 2 else (240, 230, 200)
    return (190, 120, 50) if y % 40 < 20 else (90, 40, 90)


def script(x, y):
    """Painting: lines of small signs on paper."""
    sign = noise(x // 8, y // 12)
    inside = x % 8 < 6 and y % 12 < 8 and 16 <= x < 224 and 12 <= y < 148
    if inside and sign >> (x % 8 // 2 + y % 12 // 3 * 2) & 1:
        return 40, 34, 30
    return 236, 226, 200


def main(folder="scenes/texture"):
    for side, painted in ((256, wood), (256, wall), (256, metal), (256, parquet), (512, tiles),
                          (512, ground), (128, letter)):
        write(folder, painted.__name__ + ".png", side, side, painted)
    write(folder, "globe.png", 512, 256, globe)
    write(folder, "face.png", 256, 128, face)
    for painted in rings, blocks, threads, script:
        write(folder, painted.__name__ + ".png", 240, 160, painted)
