# price.py - the table and the picture of make price
# SPDX-License-Identifier: Apache-2.0
"""FOLDER has price.json of `sphaera price`; with CELLS=1 cores whose cells are estimated there or
not known are synthesised (kept in BUILD/synth, and taken from there in any case), with RTL=1 every
row is simulated. Writes price.json anew, price.svg, energy.svg and price.html, and prints the
table. What is estimated has ~ before it, what is not known is -."""
import json
import os
import subprocess
import sys
from pathlib import Path

from . import clocks, intact, tasks
from .report import html
from .study.gather import error
from .study.plots import draw
from .synth import results

AREA = ("lut4eq", "mult", "bram")
PROFILES = ("draft", "standard", "fine", "reference")
HEAD = ["", "dB", "expected", "wrong", "undecided", "cycles a pixel", "limit", "LUT4eq", "MULT",
        "RAM", "MHz", "ms a frame", "nJ a pixel"]
NO_MORE = [""] * (len(HEAD) - 2)     # of a row that could not be built
STYLE = ('<style>.strip{display:flex;flex-wrap:wrap;gap:1em}.strip figure{margin:0}'
         '.crop{width:%dpx;max-width:100%%;overflow:hidden}.crop img{width:300%%;max-width:none;'
         'margin-left:-200%%;display:block}</style>')


def make(build, *words):
    """A goal of make, without what the make that called has given; its output if it fails."""
    given = {name: value for name, value in tasks.clean().items() if name not in ("RTL", "MORE")}
    done = subprocess.run(["make", "--no-print-directory", f"B={build}", *words], env=given,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        print(f"make {' '.join(words)}:\n{done.stdout[-1500:]}", file=sys.stderr)
    return done.stdout if not done.returncode else None


def cells(build, row):
    """Cells of the row's core: synthesised if that is asked for or was done before, else what the
    tool has of it."""
    pipes = str(row["pipes"])
    key = clocks.key(row["profile"], row["core"], PIPES=pipes)
    folder = Path(build, "synth", key)
    if not Path(folder, "stat.json").exists():
        if os.environ.get("CELLS") != "1":
            return row["cells"]
        print(f"  SYNTH {key}", flush=True)
    if make(build, "synth", f"PROFILE={row['profile']}", f"EFFECTS={row['core']}",
            f"PIPES={pipes}", "TARGET=ecp5") is None:
        return row["cells"]
    core = results.read(folder)["core"]
    return {name: core[name] for name in AREA} | {"estimated": False}


def simulated(build, row, pixels):
    """Clocks a pixel of the row on the RTL; None if it fails."""
    has = row["core"].split("+")
    accel = "box4" if "boxes" in has else "bih" if "bih" in has else "bvh4"
    words = [f"{name}={os.environ.get(name, '')}" for name in ("SCENE", "SIZE", "SEED", "DEPTH",
                                                             "LATENCY")]
    words += [f"PROFILE={row['profile']}", f"PIPES={row['pipes']}", f"ACCEL={accel}"]
    print(f"  SIM   {row['name']}", flush=True)
    said = make(build, "-s", "sim-folder", *words)
    if said is None or make(build, "sim", *words) is None:
        return None
    report = json.loads(Path(said.split()[-1], "report.json").read_text("utf-8"))
    return report["cold"]["counters"]["cycles"] / pixels


def complete(build, price, rtl):
    """Adds what the tool does not know."""
    pixels = price["width"] * price["height"]
    for row in price["rows"]:
        if row["why"]:
            continue
        row["rtl"] = simulated(build, row, pixels) if rtl else None
        if (row["cells"] or {"estimated": True})["estimated"]:
            row["cells"] = cells(build, row)
        if row["clock"]:
            row["milliseconds"] = (row["rtl"] or row["cycles_per_pixel"]) * pixels \
                / row["clock"]["median"] / 1000


def shown(value, form="{}", of=None):
    """As a cell; ~ if it is of something that is estimated."""
    return "-" if value is None else ("~" if of and of["estimated"] else "") + form.format(value)


def clock(found):
    if not found:
        return "-"
    if found["estimated"]:
        return f"~{found['median']:g}"
    spread = f"{found['worst']:g}..{found['best']:g}" if found["seeds"] > 1 else "1 seed"
    return f"{found['median']:g} ({spread})"


def line(row):
    """The cells of a row."""
    if row["why"]:
        return [row["name"], row["why"]] + NO_MORE
    of, area = row["measured"], row["cells"] or {}
    expected = row["expected"] or {"psnr": None}
    cycles = row.get("rtl") or row["cycles_per_pixel"]
    return [row["name"], shown(of["psnr"], "{:.2f}") if of["psnr"] is not None else "equal",
            shown(expected["psnr"], "{:.2f}"), str(of["wrong"]), str(of["undecidable"]),
            f"{cycles:.2f}", row["limit"]["unit"], *(shown(area.get(name), of=row["cells"])
                                                  for name in AREA), clock(row["clock"]),
            shown(row["milliseconds"], "{:.3f}", row["clock"]),
            f"~{row['energy']['nj_pixel']:.1f}" if row.get("energy") else "-"]


def text(price):
    cells_of = [HEAD] + [line(row) for row in price["rows"]]
    wide = [max(len(row[i]) for row in cells_of if i != 1 or row[2:] != NO_MORE)
            for i in range(len(HEAD))]
    lines = []
    for i, row in enumerate(cells_of):
        cells_in = [row[0].ljust(wide[0])] + [cell.rjust(w) for cell, w in zip(row[1:], wide[1:])]
        lines.append(("* " if i - 1 == price["best"] else "  ") + "  ".join(cells_in).rstrip())
    return "\n".join(lines)


def plot(folder, price):
    """{heading: picture} of error against time and against energy, of those that have a point."""
    drawn = [row for row in price["rows"] if not row["why"] and row["measured"]["psnr"] is not None]
    timed = all(row["milliseconds"] for row in drawn)
    found = {}
    for name, what, axis, costs in (
            ("price", "time", "ms a frame" if timed else "cycles a pixel",
             [row["milliseconds"] if timed else row.get("rtl") or row["cycles_per_pixel"]
              for row in drawn]),
            ("energy", "energy", "nJ a pixel, as standard cells of 0.18 um",
             [row["energy"]["nj_pixel"] if row.get("energy") else None for row in drawn])):
        dots = [(cost, error(row["measured"]["psnr"]), row["name"])
                for row, cost in zip(drawn, costs) if cost is not None]
        profiles = [dot for dot in dots if dot[2] in PROFILES]
        series = [("profiles", profiles)] + [("", [dot]) for dot in dots if dot not in profiles]
        path = folder / f"{name}.svg"
        if dots and draw(str(path), str(folder), f"What accuracy costs in {what}", axis, series):
            svg = path.read_text("utf-8")
            found[f"Error against {what}"] = svg[svg.index("<svg"):]
    return found


def strip(folder, scene, tool, price):
    """Where the pictures differ from the scene as written, a figure for each that differs."""
    figures, seen = [], set()
    for row in price["rows"]:
        if row["why"] or row["profile"] in seen:
            continue
        seen.add(row["profile"])
        name = folder / f"difference-{len(seen)}.png"
        subprocess.run([tool, "accuracy", scene, "--profile", row["profile"], "--size",
                        f"{price['width']}x{price['height']}", "--depth",
                        os.environ.get("DEPTH") or "2", "-d", str(name)], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        figures.append(f'<figure><div class="crop">{html.picture(name, row["profile"])}</div>'
                       f'<figcaption>{html.text(row["profile"])}</figcaption></figure>')
    return f'<div class="strip">{"".join(figures)}</div>'


def rows(price):
    """The table as HTML."""
    return html.table(HEAD, [("best" if i == price["best"] else "",
                              [html.text(cell) for cell in line(row)])
                             for i, row in enumerate(price["rows"])], range(1, len(HEAD)))


def style(price):
    """Of pictures()."""
    return STYLE % min(price["width"], 480)


def pictures(folder, scene, tool, price):
    """The plots, and where each profile's picture is off."""
    plots = "".join(f"<h2>{head}</h2>{svg}" for head, svg in plot(folder, price).items())
    return plots + "<h2>Where pictures differ from the scene as written</h2>" \
        + strip(folder, scene, tool, price)


def page(folder, scene, tool, price):
    return (style(price) + "<h1>What accuracy costs in time</h1>"
            f"<p>{html.text(scene)}, {price['width']}x{price['height']}</p>"
            + rows(price) + f"<p>{html.text(price['says'])}</p>"
            + (f"<p>Does not pay: {html.text(price['tried'])}.</p>" if price["tried"] else "")
            + pictures(folder, scene, tool, price))


def main(folder, scene):
    folder, build = Path(folder), os.environ.get("BUILD", "build")
    tool = f"{build}/sphaera"
    report = json.loads((folder / "price.json").read_text("utf-8"))
    price, rtl = report["price"], os.environ.get("RTL") == "1"
    complete(build, price, rtl)
    intact.write(folder / "price.json", json.dumps(report, indent=1) + "\n")
    intact.write(folder / "price.html", html.whole("price", page(folder, scene, tool, price)))
    notes = (folder / "price.log").read_text("utf-8").splitlines()
    print(text(price))
    for note in notes:
        if note.startswith(("sample:", "~:", "energy:", "does not pay:")):
            print(note)
    latency = os.environ.get("LATENCY")
    print(f"cycles: of the RTL, memory answers after {latency} clocks" if rtl else
          "cycles: by the model's counters; RTL=1 measures them")
    if any(not row["clock"] for row in price["rows"] if not row["why"]):
        print("clock -: nobody has routed that core; make study-seeds does")
    print(price["says"])
    print("look at", (folder / "price.html").resolve().as_uri())
