# film.py - the report of a moving scene: what `make sim TOP=1` leaves as report.html
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has report.json of top/frames.py and, for each of its frames, what the frame store
showed, shown-0000.ppm and so on, with layers rendering-, l1- and l2-0000.ppm too. COMMAND is the
one that repeats the run."""
import base64
import json
import re
import struct
import sys
import zlib
from pathlib import Path

from .. import intact
from . import html
from .frames import Bad
from .html import number, text


SHOWN = 12  # frames with bars


def png(path):
    """A binary PPM of 8 bits as PNG, base64."""
    data = path.read_bytes()
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
    if not head:
        raise Bad(f"{path}: no binary PPM of 8 bits")
    width, height, data = int(head[1]), int(head[2]), data[head.end():]
    if len(data) != 3 * width * height:
        raise Bad(f"{path}: {len(data)} bytes, not of {width}x{height}")

    def chunk(kind, body):
        return (struct.pack(">I", len(body)) + kind + body
                + struct.pack(">I", zlib.crc32(kind + body)))
    rows = b"".join(b"\0" + data[3 * width * y:3 * width * (y + 1)] for y in range(height))
    whole = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0,
                                                               0))
             + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
    return base64.b64encode(whole).decode()


def film(folder, frames):
    pictures = sorted(folder.glob("shown-*.ppm"))
    if len(pictures) != len(frames):
        raise Bad(f"{folder}: {len(pictures)} pictures of {len(frames)} frames")
    shown = "".join(
        f'<img src="data:image/png;base64,{png(path)}" alt="frame {frame["at"]}"'
        f'{" hidden" if at else ""}>' for at, (path, frame) in enumerate(zip(pictures, frames)))
    return (f'<h2>Frames</h2><div class="film">{shown}</div><input type="range" id="film" min="0" '
            f'max="{len(frames) - 1}" value="0" step="1" aria-label="frame"><p class="soft" '
            f'id="shown">frame {frames[0]["at"]}</p>')


def layers(folder):
    """Rendering, L1 and L2 of the first frame, if they were stored."""
    paths = [(name, folder / f"{name.lower()}-0000.ppm") for name in ("Rendering", "L1", "L2")]
    if not paths[0][1].exists():
        return ""
    shown = "".join(f'<figure><img src="data:image/png;base64,{png(path)}" alt="{name}">'
                    f"<figcaption>{name}</figcaption></figure>" for name, path in paths)
    return f'<h2>Layers of the first frame</h2><div class="maps">{shown}</div>'


def bars(frames):
    """Upload of a machine below its drawing, both as parts of the slowest; of the first frames."""
    left, frames = len(frames) - SHOWN, frames[:SHOWN]
    most = max(max(f["image_cycles"], f["upload_cycles"]) for f in frames)
    body = ""
    for f in frames:
        for name, note in (("image_cycles", "from START to all written"),
                           ("upload_cycles", "upload, while the frame before is drawn")):
            image = name == "image_cycles"
            body += html.bar(f"frame {f['at']}" if image else "", f[name] / most, number(f[name]),
                             note, "most" if image else "")
    return ("<h2>Time to image</h2><p>Clocks of each frame; a machine that is uploaded faster than "
            f'the frame before it is drawn costs no time.</p><div class="card">{body}</div>'
            + (f'<p class="soft">{left} more below.</p>' if left > 0 else ""))


def table(frames):
    rows = [[f["at"], number(1e3 * f["build_seconds"], 1), "refitted" if f["refitted"] else "built",
             number(f["memory_bytes"]), number(f["upload_cycles"]), number(f["draw_cycles"]),
             number(f["image_cycles"]), number(f["pixels_a_burst"], 2)] for f in frames]
    return "<h2>Each frame</h2>" + html.table(
        ["frame", "ms to build", "tree", "bytes", "upload", "draw", "to all written",
         "pixels a burst"], rows, (0, 1, 3, 4, 5, 6, 7))


def page(folder, command):
    report = json.loads((folder / "report.json").read_text("utf-8"))
    frames = report["frames"]
    body = (f"<h1>{text(Path(report['input']).stem)}</h1><p class='soft'>{len(frames)} frames, one "
            "behind the other, on one rt_top in Verilator</p>"
            '<div class="verdict">every frame equals that of the golden model</div>'
            + film(folder, frames) + layers(folder) + bars(frames) + table(frames))
    if command:
        body += "<h2>Again</h2>" + html.command("again", command)
    return html.whole(f"{Path(report['input']).stem}: frames on rt_top", body)


def main(folder, command=""):
    try:
        intact.write(Path(folder, "report.html"), page(Path(folder), command))
    except (OSError, Bad, ValueError, KeyError) as error:
        sys.exit(f"report: {folder}: {error!r}")
