# case.py - a scene's case on one page: accuracy, hard tests, its own core, what limits it
# SPDX-License-Identifier: Apache-2.0
"""Writes FOLDER/case.html of what `make sim` left there, and links it from report.html. Cells that
neither a page nor BUILD/synth has are estimated, with CELLS=1 synthesised; with RTL=1 the whole
core is simulated, too."""
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

from . import clocks, intact, known, price
from .effects.scenes import WHOLE, forced, whole
from .pages import data
from .report import frames, html, page, wrong
from .report.html import number, text
from .report.run import Run
from .synth import results

PIXELS = "8192"     # that a table of prices looks at, as in the report of make sim
SIZES = ("ENGINES", "PIPES", "LEAF_UNITS", "SHADES", "ROOT_STEP", "QUOTIENT_STEP", "SIZES")
JUDGED = ("rays", "hits", "roots", "pairs")     # of floats: what may be wrong


def tool(build, *words):
    return subprocess.run([f"{build}/sphaera", *words], check=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout


def asked(run, build, command, *more):
    """The report of a command for the scene of the run. All but `price` take all that the scene
    names."""
    return json.loads(tool(build, command, run.built["input"],
                           *shlex.split(run.key["BUILD_OPTIONS"]), *more, "--json", "-"))


def prices(run, build, *more):
    """The table of `sphaera price`."""
    return asked(run, build, "price", "--pixels", PIXELS, *more)["price"]


def of_profile(run, table):
    """The row of the machine's own profile; None: it could not be built, or has own widths."""
    return next((row for row in table["rows"]
                 if row["name"] == run.machine["profile"] and not row["why"]), None)


# ---- accuracy ----
def accuracy(run, build, table):
    row, said = of_profile(run, table), ""
    if row:
        row["rtl"] = run.report["cold"]["counters"]["cycles"] / run.report["pixels"]
        if row["clock"]:
            row["milliseconds"] = row["rtl"] / row["cycles_per_pixel"] * row["milliseconds"]
        said = (f"Cycles of {text(row['name'])} are the RTL's, cold caches; those of the others "
                "follow from the model's counters. Cells and clock are of the core "
                f"<code>{text(row['core'])}</code>.")
    return ("<h2>What accuracy costs in time</h2>" + price.rows(table)
            + f"<p>{text(table['says'])}.</p><p class='soft'>{said}</p>"
            + price.pictures(run.folder, run.built["input"], f"{build}/sphaera", table))


# ---- hard tests ----
def floats(run, build):
    picture = run.folder / "floats.png"
    report = asked(run, build, "floats", "--profile", run.machine["profile"], "--picture",
                   str(picture))
    kinds, pixels, rows = report["floats"], report["pixels"], []
    for kind, of in kinds.items():
        for which in ("float32", "float64") if of["all"]["rays"] else ():
            bad = any(of[which][name] for name in JUDGED)
            rows.append(("wrong" if bad else "", [kind, which] + [
                f"{number(of[which][name])} of {number(of['all'][name])}" for name in JUDGED]))
    seen = (f"float32 sees another primitive in {number(pixels['float32'])} pixels, red; float64 "
            f"in {number(pixels['float64'])}, orange." if pixels["float32"] or pixels["float64"]
            else "Neither sees another primitive in any pixel: none is red.")
    return ("<h2>Its rays in exact integers and in floating point</h2><p>The core decides each "
            "test in exact integers. Textbook formulas get the same integers; of their answers so "
            "many are wrong, and none of the core's, whose pixels are compared above.</p>"
            + html.table(["rays", "in", "nearest hits", "hits", "roots", "orders"], rows,
                         range(2, 6))
            + f'<div class="maps"><figure>{html.picture(picture, "floats")}<figcaption>{seen}'
            "</figcaption></figure></div>")


# ---- own core ----
def of_pages():
    """{core: cells} of whole cores, by `make effects`."""
    found, (head, rows) = {}, data.read("effects.prices")
    for row in rows:
        cell = dict(zip(head, (word.strip("`") for word in row)))
        core = {"all": "all", "everything": WHOLE}.get(cell["core"])
        if core:
            found[core] = [int(cell[what]) for what in ("LUT4eq", "MULT18X18D", "DP16KD")]
    return found


def of_whole(profile, core):
    """Cells of a whole core and some words more: what a page has, or estimated as the tool does
    for own cores; None: nothing is known."""
    told, area = of_pages(), known.cells()
    base = max((name for name in told if f"{core}+".startswith(f"{name}+")), key=len, default=None)
    own, standard = ((area.get((name, known.CORE, 1)) for name in (profile, "standard")))
    more = core[len(base):].split("+")[1:] if base else []
    costs = known.words()
    if not base or not own or not all(word in costs for word in more):
        return None
    ratio = int(own[0]) / int(standard[0])
    counts = [count + sum(costs[word][i] for word in more) for i, count in enumerate(told[base])]
    return dict(zip(price.AREA, [round(ratio * counts[0]), *counts[1:]])) | {
        "estimated": bool(more) or profile != "standard"}


def cells(run, build, row, cores):
    """{core: cells}: of the run's own core those of its row of the table, of others those of pages;
    what is estimated there, of Yosys if that was done before or is asked for."""
    profile = run.machine["profile"]
    sizes = {name: run.key[name] for name in SIZES if run.key.get(name)}
    keys = {core: clocks.key(profile, core, **sizes) for core in cores}
    found = {}
    for core, key in keys.items():
        if key == f"{profile}-ecp5-{core}-engines1":
            found[core] = row["cells"] if row and core == row["core"] else of_whole(profile, core)
    guessed = [core for core in cores if (found.get(core) or {"estimated": True})["estimated"]]
    made = [core for core in guessed if Path(build, "synth", keys[core], "stat.json").exists()
            or os.environ.get("CELLS") == "1"]
    if made:
        print("  SYNTH", *(keys[core] for core in made), flush=True)
        results.synthesise(build, made, PROFILES=profile, **sizes)
    for core in made:
        found[core] = results.read(Path(build, "synth", keys[core]))["core"] | {"estimated": False}
    return {core: of for core, of in found.items() if of}


def on_rtl(run, build, core):
    """Cycles of the run's machine on another core; None if that fails."""
    line = shlex.split((run.folder / "command").read_text("utf-8"))[2:]
    words = [word for word in line if not word.startswith("EFFECTS=")] + [f"EFFECTS={core}"]
    print("  SIM", core, flush=True)
    folder = price.make(build, "-s", "sim-folder", *words)
    if folder is None or price.make(build, "sim", *words) is None:
        return None
    return json.loads(Path(folder.split()[-1], "report.json").read_text("utf-8"))[
        "cold"]["counters"]["cycles"]


def own_core(run, build, table):
    own = run.report.get("core", "all")
    every = whole(own)
    row = of_profile(run, table)
    area = cells(run, build, row, list(dict.fromkeys([own, every])))
    pixels, profile = run.report["pixels"], run.machine["profile"]
    all_on = of_profile(run, prices(run, build, "--profile", profile, "--effects", "all",
                                    *forced([])))

    def clocks_of(row):
        return "-" if row is None else number(row["cycles_per_pixel"], 2)
    cycles = [run.report["cold"]["counters"]["cycles"],
              on_rtl(run, build, every) if os.environ.get("RTL") == "1" else None]
    cycles = ["-" if count is None else number(count / pixels, 2) for count in cycles + [None]]
    body = [[name, f"<code>{core}</code>",
             *("-" if core not in area else "~" * area[core]["estimated"] + number(area[core][what])
               for what in price.AREA), rtl, model]
            for name, core, rtl, model in zip(
                ("its own", "the whole one, the same machine", "the whole one, all effects on"),
                (own, every, every), cycles, (clocks_of(row), clocks_of(row), clocks_of(all_on)))]
    return ("<h2>Its own core beside the whole one</h2>"
            + html.table(["core", "built with", "LUT4eq", "MULT", "RAM", "cycles a pixel, RTL",
                          "by the model's counters"], body, range(2, 7))
            + f"<p class='soft'>Profile {text(profile)}, ECP5. All effects on: shadow, mirror and "
            "inside rays are traced though no pixel needs them. ~: estimated from cores that were "
            "synthesised; CELLS=1 synthesises these. -: not measured (RTL=1).</p>"
            + page.energy(run, page.row_of(run, table)) + left_out(run.built["build"])
            + page.effects(run))


def left_out(build):
    """What the scene names and no ray of the frame meets."""
    said = [f"{effect['name']}: {effect['why']}" for effect in build["effects"]
            if effect["left_out"]] + build["left_out"]
    return "<h3>Left out, since no ray of the frame meets it</h3>" + (
        "<ul>" + "".join(f"<li>{text(line)}</li>" for line in said) + "</ul>" if said else
        "<p>Nothing: rays meet all that the scene names.</p>")


def whole_page(run, build):
    table = prices(run, build, "--profile", "auto")
    body = (price.style(table) + page.head(run) + wrong.section(run, run.first_wrong())
            + accuracy(run, build, table) + floats(run, build) + own_core(run, build, table)
            + page.cycles(run))
    return html.whole(f"{run.report['scene']}: its case", body, script=False)


def main(folder):
    build = os.environ.get("BUILD", "build")
    try:
        run = Run(Path(folder))
        name = run.folder / "case.html"
        intact.write(name, whole_page(run, build))
        intact.write(run.folder / "report.html", page.page(run))    # which links it now
    except (OSError, frames.Bad) as error:
        sys.exit(f"case: {error}")
    except subprocess.CalledProcessError as error:
        sys.exit(f"case: {shlex.join(map(str, error.cmd))}: exit code {error.returncode}")
    except (json.JSONDecodeError, KeyError) as error:
        sys.exit(f"case: {folder}: not what `make sim` left: {error!r}")
    print("look at", name.resolve().as_uri())
