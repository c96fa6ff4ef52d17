# roof.py - the roofline of a run: whether its busiest unit or memory limits it
# SPDX-License-Identifier: Apache-2.0
"""Across, node visits for a byte that memory gives; up, node visits a clock. No run lies above the
roof: its flat part is the busiest unit but memory, the slope what the pins of memory give."""
from math import floor as whole, log10

from .html import number, text
from .units import LINE, lines_of, units

MEMORY = "memory"  # how names of its rows begin
WIDTH, HEIGHT, LEFT, BELOW = 640, 300, 60, 40


class Roof:
    """visits, bytes, clocks of a run; rate: visits a clock of the busiest unit; peak: bytes."""

    def __init__(self, run):
        count, memory = run.last["counters"], run.last.get("memory", {})
        self.visits, self.clocks = count["node_visits"], count["cycles"]
        self.bytes = LINE * memory.get("lines", lines_of(count, run.parameters))
        self.peak = run.report["memory"]["peak_bytes_per_clock"]
        busy = [u for u in units(run.last, run.machine, run.parameters)
                if not u.name.startswith(MEMORY)]
        self.unit = busy[0] if busy else None
        self.rate = self.unit and self.visits / self.unit.clocks

    def least(self):
        """Clocks of the busiest unit, and of memory's pins."""
        return self.unit.clocks, self.bytes / self.peak


def ticks(low, high):
    """1, 2 and 5 times powers of ten between the ends of an axis; of a long one the powers alone.
    Each as (number, text)."""
    steps = (1, 2, 5) if high / low < 200 else (1,)
    return [(step * 10.0 ** e, f"{step * 10.0 ** e:g}")
            for e in range(whole(log10(low)), whole(log10(high)) + 1) for step in steps
            if low <= step * 10.0 ** e <= high]


def drawing(roof):
    x, y = roof.visits / roof.bytes, roof.visits / roof.clocks
    ridge = roof.rate / roof.peak
    low, high = min(x, ridge) / 10, max(x, ridge) * 10
    floor, top = min(y, roof.peak * low) / 2, roof.rate * 2

    def at(px, py):
        across = LEFT + (WIDTH - LEFT) * log10(px / low) / log10(high / low)
        up = (HEIGHT - BELOW) * (1 - log10(py / floor) / log10(top / floor))
        return f"{across:.1f},{up:.1f}"
    line = " ".join(at(px, min(roof.rate, roof.peak * px)) for px in (low, ridge, high))
    dot = at(x, y).split(",")
    numbers, marks = [], ""
    for px, word in ticks(low, high):
        over = float(at(px, floor).split(",")[0])
        numbers.append((over - 4 * len(word), HEIGHT - BELOW + 17, word))
        marks += f"M{over:.1f},{HEIGHT - BELOW}v4"
    for py, word in ticks(floor, top):
        up = float(at(low, py).split(",")[1])
        numbers.append((LEFT - 8 - 8 * len(word), up + 4, word))
        marks += f"M{LEFT},{up:.1f}h-4"
    words = [*numbers, (LEFT + 6, 14, "visits a clock"), (WIDTH - 90, HEIGHT - 4, "visits a byte"),
             (float(at(high, roof.rate).split(",")[0]) - 190,
              float(at(high, roof.rate).split(",")[1]) - 6, roof.unit.name)]
    said = "".join(f'<text x="{a:.0f}" y="{b:.0f}" font-size="13" fill="currentColor">{text(w)}'
                   "</text>" for a, b, w in words)
    return (f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="roofline">'
            f'<polyline points="{line}" fill="none" stroke="var(--accent)" stroke-width="2"/>'
            f'<path d="M{LEFT},0V{HEIGHT - BELOW}H{WIDTH}{marks}" fill="none" '
            'stroke="currentColor"/>'
            f'<circle cx="{dot[0]}" cy="{dot[1]}" r="6" fill="var(--bad)"/>{said}</svg>')


def roof(run):
    """A section of the page; nothing if no node is visited or no line was asked for."""
    found = Roof(run)
    if not found.unit or not found.visits or not found.bytes:
        return ""
    memory, pixels = run.last.get("memory", {}), run.report["pixels"]
    busy, pins = found.least()
    first = found.unit.name if busy >= pins else "memory"
    figures = [("bytes a pixel", number(found.bytes / pixels, 1)),
               ("bytes a clock", f"{found.bytes / found.clocks:.2f} of {found.peak:.2f}")]
    if "row_hit_share" in memory:
        figures += [("lines whose row was open", f"{memory['row_hit_share']:.1%}"),
                    ("refreshes", number(memory["refreshes"]))]
    if memory:
        figures.append(("clocks bound by memory", f"{memory['bound_share']:.1%}"))
    cells = "".join(f"<div><dt>{name}</dt><dd>{value}</dd></div>" for name, value in figures)
    if "limit" in run.last:
        said = f"the run says: <b>{text(run.last['limit']['said'])}</b>. "
    else:
        said = f"by the counters alone the limit is <b>{text(first)}</b>. "
    return (f"<h2>What limits it</h2><p>{text(run.report['memory']['name'])} memory: its pins need "
            f"{pins / found.clocks:.1%} of the clocks, {text(found.unit.name)} at least "
            f"{busy / found.clocks:.1%}; {said}A clock is bound by "
            "memory if a line is owed, a ray waits, and no node is visited.</p>"
            f'<dl class="figures">{cells}</dl><div class="card" style="margin-top:.7rem">'
            f"{drawing(found)}</div>")
