# ray_timing.py - one pixel's rays through the units of the core, clock by clock, as a picture
# SPDX-License-Identifier: Apache-2.0
"""measure() draws a single pixel with the RTL and keeps, in TABLE, at which clock each stage gave
its word, counted from the clock at which the pixel got its slot. main() draws that table: in the
row of a unit a bar ends when the unit gives its result and begins when the last unit before it gave
its own. So a bar has the unit's latency and what the ray waited for on the way to it."""
import re
import sys
from pathlib import Path

from . import intact
from .pages import data
from .runner import said

SCENE, SIZE, PIXEL, LATENCY = "scenes/texture/hall.nff", "64x36", (36, 20), 20
TABLE = data.FOLDER / "ray_timing.tsv"
COLUMNS = ["ray", "kind", "stage", "visit", "clock"]
LINE = re.compile(r"(?:ray (?P<ray>\d+) (?P<kind>\w+) \| )?(?P<stage>[a-z-]+) "
                  r"(?:visit (?P<visit>\d+) )?.* clock (?P<clock>\d+)$")
# A row: its name; the stages whose words end its bars; those that such a bar begins after, if not
# after all of the other rows.
ROWS = (
    ("set-up", ("set-up", "normal"), ()),
    ("issue, node cache", ("node",), ()),
    ("filters", ("filter", "box"), ()),
    ("leaf test", ("sphere", "triangle", "plane"), ()),
    ("root, key", ("root", "key"), ()),
    ("collect", ("hit",), ()),
    ("quotient", ("quotient",), ()),
    ("record", ("material",), ("quotient",)),
    ("point", ("point",), ("quotient",)),
    ("texture", ("path", "level", "texel", "albedo"), ()),
    ("lights", ("light",), ()),
    ("blend", ("colour",), ()),
    ("reflect, set-up", ("reflected", "refracted"), ()),
    ("delivery", ("pixel",), ()),
)
ROW_OF = {stage: row for row, (_, stages, _) in enumerate(ROWS) for stage in stages}
LEFT, TOP, HEIGHT, WIDTH, NARROW = 130, 44, 22, 1080, 45  # NARROW: too narrow for a name
TICK = 50  # clocks
STYLE = """<style>
  .bar { fill: #4477aa } .grid { stroke: #dddddd } .name { font-size: 13px }
  .visit { fill: #cc6633 } .ray { fill: #ccddaa } .surface { fill: #eeddbb }
  .small { font-size: 11px }
</style>"""


def rows(lines):
    """Of lines that the bench prints: what TABLE has, in the order of clocks."""
    found = [match.groupdict("") for match in map(LINE.match, lines) if match]
    return sorted(found, key=lambda row: int(row["clock"]))


def measure(tool, build):
    """The run, into TABLE; TOOL builds the machine, whose core and log lie in BUILD."""
    folder, pixel = Path(build), "{},{}".format(*PIXEL)
    folder.mkdir(parents=True, exist_ok=True)
    machine = folder / "ray.sph"
    window = f"{pixel},{PIXEL[0] + 1},{PIXEL[1] + 1}"
    said(tool, "build", SCENE, "--size", SIZE, "--profile", "standard", "--depth", "1",
         "-o", machine)
    text = said("sh", "sim/core.sh", "--machine", machine, "--pixel", pixel, "--window", window,
                "--latency", LATENCY, EFFECTS="auto", BUILD=str(Path(tool).parent))
    found = rows(text.splitlines())
    if not found:
        sys.exit("ray-timing: the bench printed no stage with its clock")
    intact.write(TABLE, data.of_rows([COLUMNS, *([row[c] for c in COLUMNS] for row in found)]))


def bars(events):
    """[(row of ROWS, first clock, last clock)], none without length; events as rows() has them."""
    found, given = [], {}  # the latest clock of each stage
    for event in events:
        stage, clock = event["stage"], int(event["clock"])
        stage = event["kind"] if stage == "set-up" and event["kind"] in ROW_OF else stage
        if stage in ROW_OF:
            row = ROW_OF[stage]
            before = [at for name, at in given.items()
                      if (name in ROWS[row][2] if ROWS[row][2] else ROW_OF[name] != row)]
            begin = max(before, default=0)
            if clock > begin:
                if found and found[-1][:2] == (row, begin):
                    found.pop()
                found.append((row, begin, clock))
            given[stage] = clock
    return found


def spans(events):
    """[(name, first clock, last clock)] of rays, from set-up to hit, and of surfaces between."""
    found, at = [], 0
    for event in events:
        if event["stage"] in ("set-up", "hit", "pixel"):
            name = event["kind"] if event["stage"] == "hit" else "surface"
            clock = int(event["clock"])
            if event["stage"] != "set-up" or event["ray"] != "0":
                found.append((name, at, clock))
                at = clock
    return found


def drawing(events):
    last = int(events[-1]["clock"])
    scale = WIDTH / last
    below = TOP + HEIGHT * len(ROWS)

    def x(clock):
        return f"{LEFT + clock * scale:.1f}"

    def text(at, y, words, css="small", anchor="middle"):
        return f'<text class="{css}" x="{at}" y="{y}" text-anchor="{anchor}">{words}</text>'
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {LEFT + WIDTH + 30} {below + 24}"'
           ' font-family="sans-serif">', "<!-- SPDX-License-Identifier: Apache-2.0 -->", STYLE,
           '<rect width="100%" height="100%" fill="#ffffff"/>']
    for clock in range(0, last + 1, TICK):
        out += [f'<path class="grid" d="M{x(clock)} {TOP}V{below}"/>',
                text(x(clock), below + 16, clock)]
    out.append(text(LEFT - 8, below + 16, "clocks", "name", "end"))
    for name, begin, end in spans(events):
        css = "surface" if name == "surface" else "ray"
        out.append(f'<rect class="{css}" x="{x(begin)}" y="8" width="{(end - begin) * scale:.1f}" '
                   f'height="18"/>')
        if (end - begin) * scale > NARROW:
            out.append(text(x((begin + end) / 2), 21, name))
    for row, (name, _, _) in enumerate(ROWS):
        out.append(text(LEFT - 8, TOP + HEIGHT * row + 15, name, "name", "end"))
    for row, begin, end in bars(events):
        out.append(f'<rect class="bar" x="{x(begin)}" y="{TOP + HEIGHT * row + 3}" '
                   f'width="{(end - begin) * scale:.1f}" height="{HEIGHT - 6}"/>')
    for event in events:
        if event["stage"] == "node":
            at = x(int(event["clock"]))
            out += [f'<path class="visit" d="M{at} {TOP}l5 -9h-10z"/>',
                    f'<path stroke="#cc6633" stroke-dasharray="2 3" d="M{at} {TOP}V{below}"/>']
    return "\n".join(out + ["</svg>"]) + "\n"


def main(table, picture):
    head, found = data.read(Path(table).stem)
    events = [dict(zip(head, cells)) for cells in found]
    intact.write(picture, drawing(events))
