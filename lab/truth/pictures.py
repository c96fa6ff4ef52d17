# pictures.py - frames and pictures as lists of bytes, compared and written
# SPDX-License-Identifier: Apache-2.0
"""A picture is (width, height, colours, ids): 3 bytes a pixel, one number a pixel."""
import math
import re
import struct
import subprocess
import zlib

FAR_OFF = 8
ID_NONE = 0xffffff


def ppm(path):
    """(width, height, bytes) of a binary PPM."""
    with open(path, "rb") as f:
        data = f.read()
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
    return int(head[1]), int(head[2]), data[head.end():]


def frame(path):
    """A frame file (cmodel/core/frame.h): its deepest layer."""
    with open(path, "rb") as f:
        data = f.read()
    _, width, height, layers, counters, _ = struct.unpack_from("<6I", data, 8)
    each = struct.Struct(f"<{layers}I3IQ")
    colours, ids = bytearray(), []
    for words in each.iter_unpack(data[32 + 8 * counters:-8]):
        colours += words[layers - 1].to_bytes(4, "little")[:3]
        ids.append(words[layers])
    return width, height, bytes(colours), ids


def povray(parts, flat, to):
    """What POV-Ray drew: sums and differences of parts, [(+1 or -1, EXR)], and the flat colours;
    `to` is where it is put as 8 bits."""
    words = ["oiiotool", parts[0][1]]
    for sign, path in parts[1:]:
        words += [path, "--add" if sign > 0 else "--sub"]
    words += ["--ch", "R,G,B", "--clamp:min=0:max=1", "-d", "uint8", "-o", to]
    subprocess.run(words, check=True)
    subprocess.run(["oiiotool", flat, "--ch", "R,G,B", "-d", "uint8", "-o", flat + ".ppm"],
                   check=True)
    width, height, colours = ppm(to)
    numbers = ppm(flat + ".ppm")[2]
    ids = [int.from_bytes(numbers[i:i + 3], "little") for i in range(0, len(numbers), 3)]
    return width, height, colours, ids


def around(picture, x, y):
    """The ids of a pixel and of those beside it."""
    width, height, _, ids = picture
    return {ids[j * width + i] for j in range(max(y - 1, 0), min(y + 2, height))
            for i in range(max(x - 1, 0), min(x + 2, width))}


def inner(picture):
    """For each pixel whether all around it are of its object."""
    width, height, _, ids = picture
    same = []  # with the pixels left and right of it
    for y in range(height):
        row = ids[y * width:(y + 1) * width]
        same += [a == b == c for a, b, c in zip(row[:1] + row, row, row[1:] + row[-1:])]
    found = []
    for y in range(height):
        above, below = (min(max(y + by, 0), height - 1) * width for by in (-1, 1))
        found += [same[y * width + x] and same[above + x] and same[below + x] and
                  ids[above + x] == ids[y * width + x] == ids[below + x] for x in range(width)]
    return found


def off(a, b):
    """For each pixel the largest difference of a channel."""
    each = [abs(p - q) for p, q in zip(a[2], b[2])]
    return list(map(max, each[0::3], each[1::3], each[2::3]))


def decibel(a, b, some=None):
    """PSNR over all pixels, or those of `some`; None if they are equal."""
    squares = [(p - q) ** 2 for p, q in zip(a[2], b[2])]
    if some is not None:
        squares = [s for i, s in enumerate(squares) if some[i // 3]]
    return 10 * math.log10(255 ** 2 * len(squares) / sum(squares)) if any(squares) else None


def compare(truth, other, away):
    """What a page tells of two pictures; away: pixels that are not on edges."""
    if truth[:2] != other[:2]:
        raise ValueError(f"pictures of {truth[:2]} and {other[:2]} pixels")
    wrong = [a != b for a, b in zip(truth[3], other[3])]
    return {"psnr": decibel(truth, other), "psnr_away": decibel(truth, other, away),
            "wrong": sum(wrong), "wrong_away": sum(w and a for w, a in zip(wrong, away)),
            "far_off": sum(most > FAR_OFF for most in off(truth, other))}


def causes(truth, model, marked, rules):
    """Why pixels of the model are far off, None where they are not; of each the first that holds:
    the object beside (edge), another object, a mark ({name: for each pixel whether}), arithmetic
    (the double reference with the machine's rules is right), another of `rules` (the reference is
    right with those: {name: picture}), or what the two renderers do differently (rule)."""
    mine = off(truth, model)
    right = {name: off(truth, picture) for name, picture in rules.items()}
    found = []
    for i, most in enumerate(mine):
        if most <= FAR_OFF:
            found.append(None)
        elif truth[3][i] != model[3][i]:
            beside = model[3][i] in around(truth, i % truth[0], i // truth[0])
            found.append("edge" if beside else "object")
        else:
            said = [name for name, marks in marked.items() if marks[i]]
            said += [name for name, each in right.items() if each[i] <= FAR_OFF]
            found.append(said[0] if said else "rule")
    return found


CAUSES = ["edge", "object", "doubtful", "beyond", "arithmetic", "limit", "total", "rule"]


def counts(found):
    """{cause: pixels}."""
    return {name: found.count(name) for name in CAUSES}


def rest(truth, model, found):
    """dB of the pixels that are not far off because of marks or rules."""
    return decibel(truth, model, [name in (None, "edge", "object", "arithmetic") for name in found])


def srgb(byte):
    """A byte of linear light as people see it (IEC 61966-2-1)."""
    c = byte / 255
    return round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055))


SRGB = bytes(srgb(byte) for byte in range(256))


def strip(path, truth, model):
    """POV-Ray, the model, both in sRGB; the difference of linear bytes 16 times."""
    width, height = truth[:2]
    rows = b""
    for y in range(height):
        a, b = (p[2][3 * width * y:3 * width * (y + 1)] for p in (truth, model))
        apart = bytes(min(255, 16 * abs(p - q)) for p, q in zip(a, b))
        rows += b"\0" + a.translate(SRGB) + b.translate(SRGB) + apart

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    head = struct.pack(">IIBBBBB", 3 * width, height, 8, 2, 0, 0, 0)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
