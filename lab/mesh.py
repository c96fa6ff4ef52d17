# mesh.py - what a mesh of a million triangles takes, as the table of docs/reference/scene_format.md
# SPDX-License-Identifier: Apache-2.0
"""Writes the same bumpy ball as OBJ, PLY, STL and GLB into FOLDER, has the tool read and build it,
and puts seconds of a processor and the memory of the largest process into PAGE."""
import json
import math
import os
import struct
import sys
from pathlib import Path

from .pages import place

ROWS, COLUMNS = 708, 707        # 999 698 triangles


def ball():
    """Corners, and triangles as numbers of corners."""
    corners, faces = [], []
    for i in range(ROWS + 1):
        for j in range(COLUMNS):
            t, p = math.pi * i / ROWS, 2 * math.pi * j / COLUMNS
            r = 1 + 0.1 * math.sin(9 * t) * math.sin(8 * p)
            corners.append((r * math.sin(t) * math.cos(p), r * math.cos(t),
                            -r * math.sin(t) * math.sin(p)))
    for i in range(ROWS):
        for j in range(COLUMNS):
            a, b = i * COLUMNS + j, i * COLUMNS + (j + 1) % COLUMNS
            if i > 0:
                faces.append((a, a + COLUMNS, b))
            if i < ROWS - 1:
                faces.append((b, a + COLUMNS, b + COLUMNS))
    return corners, faces


def obj(corners, faces):
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in corners]
    lines += [f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces]
    return "".join(lines).encode()


def ply(corners, faces):
    head = ("ply\nformat binary_little_endian 1.0\n"
            f"element vertex {len(corners)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return head.encode() + b"".join(struct.pack("<3f", *c) for c in corners) + \
        b"".join(struct.pack("<B3i", 3, *f) for f in faces)


def stl(corners, faces):
    return bytes(80) + struct.pack("<I", len(faces)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *corners[a], *corners[b], *corners[c], 0)
        for a, b, c in faces)


def glb(corners, faces):
    parts = [b"".join(struct.pack("<3f", *c) for c in corners),
             b"".join(struct.pack("<3I", *f) for f in faces)]
    first = len(parts[0])
    text = json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(corners),
                       "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5125, "count": 3 * len(faces),
                       "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": first},
                        {"buffer": 0, "byteOffset": first, "byteLength": len(parts[1])}],
        "buffers": [{"byteLength": first + len(parts[1])}]}).encode()
    text += b" " * (-len(text) % 4)
    data = b"".join(parts)
    return struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + \
        struct.pack("<I4s", len(text), b"JSON") + text + \
        struct.pack("<I4s", len(data), b"BIN\0") + data


def taken(*command):
    """Seconds of processors, and MB of the largest process."""
    quiet = os.open(os.devnull, os.O_WRONLY)
    child = os.posix_spawn(command[0], command, os.environ,
                           file_actions=[(os.POSIX_SPAWN_DUP2, quiet, 1)])
    os.close(quiet)
    _, status, used = os.wait4(child, 0)
    if status:
        sys.exit(f"mesh: {' '.join(command)}: fails")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1000


def main(tool, folder, page):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    corners, faces = ball()
    rows = [["file", "MB", "read, s", "read, MB of memory", "build, s", "build, MB of memory"]]
    for write in obj, ply, stl, glb:
        path = folder / f"million.{write.__name__}"
        path.write_bytes(write(corners, faces))
        read = taken(tool, "info", str(path))
        built = taken(tool, "build", str(path), "--profile", "fine", "-o", str(folder / "m.sph"))
        rows.append([write.__name__.upper(), f"{path.stat().st_size / 1e6:.0f}",
                     f"{read[0]:.1f}", f"{read[1]:.0f}", f"{built[0]:.1f}", f"{built[1]:.0f}"])
        path.unlink()
    (folder / "m.sph").unlink()
    place.place(page, "make mesh-time", {"million": rows})
