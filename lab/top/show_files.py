# show_files.py - a machine and its golden frame as tb/top/tb_show_icarus.v reads them
# SPDX-License-Identifier: Apache-2.0
"""Writes FOLDER/machine.hex, memory.hex (words of 64 bits) and frame.hex (a pixel a line): the
frame that each value of MUX selects."""
import struct
from pathlib import Path

from lab.top.golden import golden, machine


def main(folder, path, frame):
    registers, memory = machine(path)
    words = struct.unpack(f"<{len(memory) // 8}Q", memory)
    pixels = [colour for depth in (None, 0, 1, 2) for row in golden(path, frame, depth)
              for colour in row]
    for name, values, digits in (("machine", registers, 8), ("memory", words, 16),
                                 ("frame", pixels, 6)):
        text = "".join(f"{value:0{digits}x}\n" for value in values)
        (Path(folder) / f"{name}.hex").write_text(text, encoding="utf-8")
