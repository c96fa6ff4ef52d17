# page.py - the report of a run: what `make sim` leaves as report.html
# SPDX-License-Identifier: Apache-2.0
import base64
import json
import sys
import zlib
from array import array

from .. import price
from . import html, wrong
from .html import bar, number, text
from .roof import roof
from .units import units
from .words import effects, machine_words

MAPS = {  # name: title, unit, whether it is drawn by logarithm, what it says
    "visits": ("Visits", "nodes", True, "Tree nodes that all rays of a pixel visit, in model and "
               "core alike."),
    "cycles": ("Clocks a pixel", "clocks", True, "The pixel's part of the frame: clocks from the "
               "one in which a slot was free for it to the one in which it left, divided by the "
               "{slots} slots that work at once. All parts add up to {sum} of {cycles} clocks."),
    "left": ("Order", "clocks", False, "The clock in which each pixel left: pixels start in "
             "columns of eight{walks}, and hard ones leave late."),
    "energy": ("Energy", "nJ", True, "As standard cells of 0.18 um, estimated from events: idle "
               "clocks by the pixel's part of the frame, all events by its visits."),
}


def deflated(values):
    words = array("I", values)
    if sys.byteorder == "big":
        words.byteswap()
    return base64.b64encode(zlib.compress(words.tobytes(), 9)).decode()


def energy_map(run):
    """pJ of each pixel; None of a core whose energy is not known, or without clocks of pixels."""
    row, clocks = row_of(run, prices(run)), run.in_flight()
    if not row or not row["energy"] or clocks is None:
        return None
    parts = energy_parts(run, row)
    visits = [p.visits for p in run.model.pixels]
    idle = 1000 * len(visits) * parts.pop("idle clock") / max(1, sum(clocks))
    event = 1000 * len(visits) * sum(parts.values()) / max(1, sum(visits))
    return [round(idle * clock + event * visit) for clock, visit in zip(clocks, visits)]


def planes(run):
    """What the maps and the line below them show of each pixel."""
    found = {"visits": ([p.visits for p in run.model.pixels], 1),
             "cycles": (run.in_flight(), run.slots()), "left": (run.left, 1),
             "energy": (energy_map(run), 1000)}
    result = []
    for name, (values, per) in found.items():
        if values is None:
            continue
        title, unit, log, _ = MAPS[name]
        result.append({"name": name, "title": title.lower(), "unit": unit, "log": log, "per": per,
                       "map": True, "data": deflated(values)})
    result.append({"name": "id", "title": "id", "per": 1, "names": {0xffffff: "background"},
                   "map": False, "data": deflated(p.id for p in run.model.pixels)})
    for plane in result:
        plane.update(width=run.model.width, height=run.model.height)
    return result


def pictures(run, at):
    def picture(name, label, css=""):
        return html.picture(run.folder / name, label, css)
    mark = ""
    if at:
        mark = (f'<span class="mark" style="left:{100 * (at[0] + .5) / run.model.width:.3f}%;'
                f'top:{100 * (at[1] + .5) / run.model.height:.3f}%"></span>')
    body = (f'<h2>Model and RTL</h2><div class="compare">{picture("model.png", "model")}'
            f'{picture("rtl.png", "RTL", "over")}<span class="edge"></span>{mark}'
            '<span class="side left">model</span><span class="side right">RTL</span></div>'
            '<input type="range" id="slider" min="0" max="100" value="50" step="0.1" '
            'aria-label="model on the left, RTL on the right">')
    if run.report["mismatches"]:
        body += ('<div class="maps"><figure>' + picture("diff.png", "difference")
                 + '<figcaption><b>Difference</b><span class="soft">16 times |model - RTL|; white '
                 "where only id, key, visits or texture differ.</span></figcaption></figure></div>")
    else:
        body += '<p class="soft">The difference is black: every bit is equal.</p>'
    return body


def maps(run, drawn):
    told = {"slots": run.slots(), "cycles": number(run.last["counters"]["cycles"]), "sum": "",
            "walks": " of either half" if run.parameters["WALKS"] > 1 else ""}
    if run.left:
        told["sum"] = number(sum(run.in_flight()) / run.slots())
    figures = ""
    for plane in drawn:
        if plane["map"]:
            title, _, _, note = MAPS[plane["name"]]
            figures += (f'<figure><canvas id="{plane["name"]}" width="{plane["width"]}" '
                        f'height="{plane["height"]}"></canvas><figcaption><b>{title}</b>'
                        f'<span class="soft">{note.format(**told)}</span>'
                        '<div class="scale"></div></figcaption></figure>')
    return (f'<h2>Maps of work</h2><div class="maps">{figures}</div>'
            '<div class="pixel">Point at a picture: its pixel is told here.</div>'
            f'<script type="application/json" id="planes">{json.dumps(drawn)}</script>')


def cycles(run):
    count = run.last["counters"]
    total, waiting, idle = (count[name] for name in ("cycles", "rays_waiting", "issue_wait"))
    if not total:
        return ""
    parts = [("a node is visited", waiting - idle), ("none is, though a ray waits", idle),
             ("no primary ray waits: begin, end", total - waiting)]
    split = "".join(f'<i style="width:{value / total:.2%}"></i>' for _, value in parts)
    said = "; ".join(f"{name}: {value / total:.1%}" for name, value in parts)
    busy = units(run.last, run.machine, run.parameters)
    bars = "".join(bar(u.name, u.clocks / total, f"{u.clocks / total:.1%}", u.what,
                       "most" if u is busy[0] else "") for u in busy)
    if "limit" in run.last:
        told = ("Clocks in which each unit of the core works, as the bench counts them; one that "
                "holds a result which nobody takes does not work. The limit: "
                f"<b>{text(run.last['limit']['said'])}</b>.")
    else:
        told = ("Verilator alone counts every unit. By the counters of the core these need at "
                f"least so many clocks, <b>{text(busy[0].name)}</b> the most; what limits the "
                "frame, they do not tell.")
    return (f"<h2>Where cycles go</h2><p>{told}</p>"
            f'<div class="card"><div>{bars}</div></div>'
            f'<div class="card" style="margin-top:.7rem"><div class="bar split"><span>all clocks'
            f'</span><span class="track">{split}</span><span class="n">{number(total)}</span>'
            f"<small>{text(said)}</small></div></div>")


def counters(run):
    count, model = run.last["counters"], run.report["model"]
    rows = []
    for name, value in count.items():
        if name in model:
            if not value and not model[name]:
                continue
            same = model[name] == value
            rows.append(("" if same else "wrong", [name, number(model[name]), number(value),
                                                   "equal" if same else "differs"]))
        elif value:
            note = "the RTL alone counts it"
            if name == "cycles":
                least = units(run.last, run.machine, run.parameters)[0]
                note = f"at least {number(least.clocks)}: {least.name}"
            rows.append(["", [name, "", number(value), note]])
    return ("<h2>Counters</h2><p>What the model predicts, and what the core counted"
            + f" with {'warm' if 'warm' in run.report else 'cold'} caches"
            + ". Those that are 0 are left out.</p>"
            + html.table(["counter", "model", "core", ""], rows, (1, 2)))


def head(run):
    report, last = run.report, run.last
    good = not report["mismatches"]
    verdict = (f"{number(report['pixels'])} pixels, every bit equal" if good else
               f"{number(report['mismatches'])} mismatches in {number(report['pixels'])} pixels")
    caches = "warm" if "warm" in report else "cold"
    figures = [(f"cycles a pixel, {caches} caches", number(last["cycles_per_pixel"], 2)),
               ("cycles a visit", number(last["cycles_per_visit"], 3)),
               ("issue port busy", f"{last['issue_port_busy']:.1%}"),
               ("cycles", number(last["counters"]["cycles"])),
               ("node visits", number(last["counters"]["node_visits"])),
               ("simulated in", f"{report['seconds']:.1f} s")]
    cells = "".join(f"<div><dt>{name}</dt><dd>{value}</dd></div>" for name, value in figures)
    version = report["simulator_version"].split("(")[0].strip()
    sim = version if report["simulator"] in version.lower() else f"Verilator {version}"
    if report["simulator"] == "icarus":
        sim += ": four-valued, registers without reset start as x"
    return (f"<h1>{text(report['scene'])}</h1><p class='soft'>golden model and RTL, profile "
            f"{text(report['profile'])}, {run.model.width} x {run.model.height}; {text(sim)}</p>"
            f'<div class="verdict{"" if good else " wrong"}">{verdict}</div>'
            f'<dl class="figures">{cells}</dl>')


def energy_parts(run, row):
    """{part: nJ a pixel}, of the row of a table of prices; its clocks are those of the run."""
    parts = dict(row["energy"]["parts"])
    parts["idle clock"] *= run.last["cycles_per_pixel"] / row["cycles_per_pixel"]
    return parts


def energy(run, row):
    """What a pixel takes, by part."""
    if not row or not row["energy"]:
        return "<p>Energy: not known of such a core; <code>make silicon</code> measures it.</p>"
    parts = energy_parts(run, row)
    return (f"<p>Energy, as standard cells of 0.18 um: ~{number(sum(parts.values()), 1)} nJ a "
            "pixel: " + ", ".join(f"{text(name)} {number(nj, 1)}" for name, nj in parts.items())
            + ". Estimated from events; <code>make silicon</code> measures it.</p>")


def prices(run):
    """The table of prices; None of a scene that is not built at once."""
    name = run.folder / "price.json"
    return json.loads(name.read_text("utf-8"))["price"] if name.exists() else None


def row_of(run, table):
    """The row of a table of prices that is of the run's profile and core; None: there is none."""
    return next((row for row in (table["rows"] if table else []) if not row["why"]
                 and row["name"] == run.report["profile"]
                 and row["core"] == run.report.get("core")), None)


def costs(run):
    """What other profiles would cost."""
    table = prices(run)
    if not table:
        return ""
    return ("<h2>What accuracy costs in time</h2>" + price.rows(table)
            + f'<p class="soft">{text(table["says"])}. Clocks by the work of the model; '
            "<code>make case</code> has more.</p>" + energy(run, row_of(run, table)))


def page(run):
    at, drawn = run.first_wrong(), planes(run)
    repeat = run.folder / "command"
    body = head(run) + wrong.section(run, at) + pictures(run, at) + maps(run, drawn) + cycles(run) \
        + roof(run) + costs(run) + counters(run) + machine_words(run) + effects(run)
    if (run.folder / "case.html").exists():
        body += '<p><a href="case.html">The case of this scene</a></p>'
    if repeat.exists():
        body += "<h2>Again</h2>" + html.command("again", repeat.read_text("utf-8").strip())
    return html.whole(f"{run.report['scene']}, {run.report['profile']}: model and RTL", body)
