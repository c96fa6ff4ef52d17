# golden.py - machine files and the golden model's frames, for benches in Python
# SPDX-License-Identifier: Apache-2.0
"""docs/reference/machine_file.md and cmodel/core/frame.h draw both files."""
import struct
from pathlib import Path


def machine(path):
    """(registers, memory) of a machine file."""
    data = Path(path).read_bytes()
    header, count, _, lines = struct.unpack_from("<4I", data, 12)
    first = header - 4 * count
    return struct.unpack_from(f"<{count}I", data, first), data[header:header + 32 * lines]


def golden(machine_path, frame_path, depth=None):
    """Rows of 0x00RRGGBB at a depth, or that which register FRAME of the machine selects."""
    data = Path(frame_path).read_bytes()
    _, width, height, frames, counters, _ = struct.unpack_from("<6I", data, 8)
    if depth is None:
        depth = min(machine(machine_path)[0][96], frames - 1)
    size, at = 4 * (frames + 3) + 8, 32 + 8 * counters
    for y in range(height):
        row = []
        for x in range(width):
            bgr, = struct.unpack_from("<I", data, at + size * (y * width + x) + 4 * depth)
            row.append((bgr & 255) << 16 | bgr & 0xff00 | bgr >> 16)
        yield row
