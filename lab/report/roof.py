# roof.py - the roofline of a run: whether its busiest unit or memory limits it
# SPDX-License-Identifier: Apache-2.0
"""Across, node visits for a byte that memory gives; up, node visits a clock. No run lies above the
roof: its flat part is the busiest unit but memory, the slope what the pins of memory give."""
from math import log10

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
    words = [(LEFT, 14, "visits a clock"), (WIDTH - 130, HEIGHT - 8, "visits a byte"),
             (float(at(high, roof.rate).split(",")[0]) - 190,
              float(at(high, roof.rate).split(",")[1]) - 6, roof.unit.name)]
    said = "".join(f'<text x="{a:.0f}" y="{b:.0f}" font-size="13" fill="currentColor">{text(w)}'
                   "</text>" for a, b, w in words)
    return (f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="roofline">'
            f'<polyline points="{line}" fill="none" stroke="var(--accent)" stroke-width="2"/>'
            f'<path d="M{LEFT},0V{HEIGHT - BELOW}H{WIDTH}" fill="none" stroke="currentColor"/>'
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
