# wrong.py - a mismatch on the page: the pixel, its rays, how to see it in a waveform
# SPDX-License-Identifier: Apache-2.0
from . import html
from .html import number, text

FIELDS = ("id", "key", "visits", "texture", "rendering", "l1", "l2")


NONE = {"id": 0xffffff, "key": 0, "texture": 0xfff00000}  # as machine.def has it


def shown(name, value):
    if value == NONE.get(name):
        return "none"
    if name in ("rendering", "l1", "l2"):  # 0xBBGGRR
        rgb = value.to_bytes(3, "little").hex()
        return f'<i class="swatch" style="background:#{rgb}"></i> 0x{value:06x}'
    return f"{value} (0x{value:x})"


def values(model, core):
    rows = []
    for name in FIELDS:
        a, b = getattr(model, name), getattr(core, name)
        rows.append(("" if a == b else "wrong", [name, shown(name, a), shown(name, b)]))
    return html.table(["", "model", "core"], rows, (1, 2))


def ray(rays, number_of):
    """A ray, and those that start where it ends."""
    r = rays[number_of]
    if r["kind"] == "shadow":
        found = "light hidden" if r["hit"] else "light seen"
    elif r["hit"]:
        found = (f"id {r['id']}{' from inside' if r['inside'] else ''}, key {number(r['key'])}, "
                 f"{r['distance']:.6g} grid steps away")
    else:
        found = "nothing"
    below = "".join(ray(rays, i) for i, other in enumerate(rays) if other["parent"] == number_of)
    vectors = f"from ({', '.join(map(str, r['org']))}) along ({', '.join(map(str, r['dir']))})"
    return (f"<li><b>{r['kind']}</b>: {found}; {r['visits']} visits <span>{vectors}</span>"
            + (f"<ul>{below}</ul>" if below else "") + "</li>")


def waveform(run):
    """The waveforms that are there, and the command that makes that of the pixel."""
    body = ""
    for name, what in (("core.fst", "this run"), ("pixel.fst", "the pixel alone")):
        if (run.folder / name).exists():
            body += (f'<p>Waveform of {what}, beside this page, for GTKWave or Surfer: '
                     f'<a href="{name}">{name}</a>.</p>')
    if "repeat" in run.report:
        line = run.report["repeat"].replace("--trace pixel.fst",
                                            f"--trace {run.folder}/pixel.fst")
        body += ('<p>This command repeats the pixel alone, from the root of the tree, and leaves '
                 'pixel.fst:</p>' + html.command("alone", line))
    return body


def section(run, at):
    """Nothing if nothing is wrong."""
    if not run.report["mismatches"]:
        return ""
    body = "<h2>What is wrong</h2>"
    if at:
        x, y = at
        rays = run.rays(x, y)
        roots = "".join(ray(rays, i) for i, r in enumerate(rays) if r["parent"] is None)
        body += (f"<p>The first wrong pixel is <b>{x}, {y}</b>.</p>"
                 + values(run.model.at(x, y), run.core.at(x, y))
                 + "<h3>Its rays, as the model traces them</h3>"
                 + (f'<ul class="rays card">{roots}</ul>' if roots else
                    "<p>None: it is separated as background.</p>"))
    if "explanation" in run.report:
        body += f"<h3>What the comparison says</h3><pre>{text(run.report['explanation'])}</pre>"
    return body + waveform(run)
