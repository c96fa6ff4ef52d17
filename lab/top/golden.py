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


def show_files(folder, path, frame):
    """Writes FOLDER/machine.hex, memory.hex (words of 64 bits) and frame.hex (a pixel a line), as
    tb/top/tb_show_icarus.v reads them: the frame that each value of MUX selects."""
    registers, memory = machine(path)
    words = struct.unpack(f"<{len(memory) // 8}Q", memory)
    pixels = [colour for depth in (None, 0, 1, 2) for row in golden(path, frame, depth)
              for colour in row]
    for name, values, digits in (("machine", registers, 8), ("memory", words, 16),
                                 ("frame", pixels, 6)):
        text = "".join(f"{value:0{digits}x}\n" for value in values)
        (Path(folder) / f"{name}.hex").write_text(text, encoding="utf-8")
