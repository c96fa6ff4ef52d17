# events.py - frames by cores in standard cells, and what an event takes: docs/results/silicon.md
# SPDX-License-Identifier: Apache-2.0
"""Draws FRAMES with `make silicon`, fits energies of events to those that are `in` the fit, and
puts all of it into the page: each frame with what the fit says of it, cores, energies. Then the
tool is built with these energies, and tells what a pixel takes."""
import json
import sys
from pathlib import Path

from .. import known
from ..effects import scenes
from ..pages import data
from ..pages.place import place
from ..runner import said
from ..study import points
from ..sweep import axes, measures
from . import fit, report

SIZE = "32x18"
COMMAND, TABLE = "make silicon-energy", "cmodel/trial/known_table.h"
CORES = points.KINDS    # name: the scene that asks for it, its effects
# core, profile, fit, frames: scenes with more words of make
FRAMES = [
    ("spheres", "standard", "in", "random:16, random:64, random:256, random:4096, sphereflake:3, "
     "paper5, paper100, one_sphere"),
    ("spheres", "standard", "out", "random:256 DEPTH=0, sphereflake:2, materials, huge_tiny"),
    *[("spheres", profile, which, scene) for profile in ("draft", "reference")
      for which, scene in (("in", "random:256"), ("out", "paper5"))],
    ("triangles", "standard", "in",
     "facets/room, facets/triangles, icosphere:1, random:64 ACCEL=box4"),
    ("triangles", "standard", "out",
     "facets/triangles DEPTH=0, mount:1, icosphere:2, paper5 ACCEL=box4"),
]
SHOWN = {"spheres": "random:256", "triangles": "facets/room"}   # modules, paths of cores: standard
HEAD = ["frame", "core", "profile", "fit", "effects", "cycles", "LUT4eq", *fit.COUNTS, "rays", "nJ",
        "idle pJ", "nJ a pixel", "nJ a ray", *[f"pJ: {group}" for group in report.GROUPS],
        "fit says", "off"]
NODES = ((180, 1.8), (130, 1.2), (28, 0.9))     # nm, volts: ours, MRTP's, RayCore's (assumed)


def scaled(frames):
    """nJ a ray of the frames at other nodes, as length and the square of voltage go."""
    rays = [float(frame["nJ a ray"]) for frame in frames]
    for length, volts in NODES:
        factor = length / NODES[0][0] * (volts / NODES[0][1]) ** 2
        yield [f"{length} nm", f"{volts} V", f"{factor:.3f}", f"{min(rays) * factor:.2f}",
               f"{max(rays) * factor:.2f}"]


def drawn(what, profile, scene, *more):
    """silicon.json of a run."""
    words = [f"SCENE={scene}", f"PROFILE={profile}", f"EFFECTS={CORES[what][1]}", f"SIZE={SIZE}",
             *more]
    print("  RUN ", *words, flush=True)
    said("make", "--no-print-directory", "silicon", *words)
    folder = said("make", "-s", "--no-print-directory", "silicon-folder", "SIM=silicon", *words)
    return json.loads(Path(folder.split()[-1], "silicon.json").read_text("utf-8"))


def pixel_rows(tool):
    """What a pixel takes: of CORES in all profiles, and of those scenes that effects.md shows."""
    head, rows = data.chosen("effects.costs")
    effects = [{"scene": row[head.index("scene")], "size": scenes.SIZE,
                "build_more": "--effects all"} for row in rows]
    for words in [words for words, _ in CORES.values()] + effects:
        w = axes.words(axes.job("price", **{"size": points.PICTURE, **words}))
        for found in measures.price(tool, "build", w, None)["rows"]:
            if found.get("energy"):
                yield [f"`{words['scene']}`", words.get("size", points.PICTURE), found["core"],
                       found["name"], f"~{found['energy']['nj_pixel']:.1f}"]


def row(what, profile, which, frame, found, lut4eq):
    energy = found["energy"]
    return [f"`{frame}`", what, profile, which, CORES[what][1], found["cycles"], lut4eq,
            *fit.counts(found["counters"], CORES[what][1]), found["rays"],
            f"{energy['nj_pixel'] * found['pixels']:.1f}", f"{sum(energy['idle'].values()):.1f}",
            f"{energy['nj_pixel']:.2f}", f"{energy['nj_ray']:.2f}",
            *[f"{energy['busy'][group]:.0f}" for group in report.GROUPS]]


def core_row(what, profile, found):
    energy = found["energy"]
    return [what, profile, f"{found['kge']:.1f}", f"{found['logic_mm2']:.2f}",
            f"{found['memory_mm2']:.2f}", found["flip_flops"], found["clock_gates"],
            f"{found['mhz']:.1f}" if found["mhz"] else "-", f"{sum(energy['idle'].values()):.0f}",
            f"{energy['idle_mw']:.0f}" if energy["idle_mw"] else "-"]


def block_rows(what, found):
    """Those modules that take a percent of the energy of a frame."""
    blocks = found["blocks"]
    whole = sum(report.summed(block, "busy") for block in blocks.values())
    order = sorted(blocks, key=lambda name: -report.summed(blocks[name], "busy"))
    return [[what, f"`{name.rpartition('.')[2]}`", f"{blocks[name]['kge']:.1f}",
             *[f"{blocks[name].get('busy', {}).get(group, 0):.0f}" for group in report.GROUPS],
             *[f"{report.summed(blocks[name], phase):.0f}" for phase in report.PHASES]]
            for name in order if report.summed(blocks[name], "busy") > whole / 100]


def path_rows(what, found):
    return [[what, f"{path['ns']:.2f}", " > ".join(
        f"`{module.rpartition('.')[2]}`" for module in path["through"])]
            for path in found["paths"] or []]


def frame_rows():
    """({(core, profile, frame): silicon.json}, rows of HEAD but for its last two columns)"""
    found, rows, area = {}, [], known.cells()
    for what, profile, which, frames in FRAMES:
        lut4eq = area[(profile, CORES[what][1], 1)][0]
        for frame in frames.split(", "):
            of = found[(what, profile, frame)] = drawn(what, profile, *frame.split())
            rows.append([str(cell) for cell in row(what, profile, which, frame, of, lut4eq)])
    return found, rows


def main(tool, page):
    found, rows = frame_rows()
    cores = {}
    for (what, profile, _), of in found.items():
        cores.setdefault((what, profile), core_row(what, profile, of))
    shown = {what: found[(what, fit.PROFILE, frame)] for what, frame in SHOWN.items()}
    frames = fit.frames_of((HEAD, rows))
    model = fit.fitted(frames)
    for cells, frame in zip(rows, frames):
        says = sum(model.parts(frame).values())
        cells += [f"{says:.1f}", f"{100 * (says / frame['nJ'] - 1):+.1f} %"]
    place(page, COMMAND, {
        "frames": [HEAD, *rows],
        "scaled": [["node", "voltage", "factor", "nJ a ray, least", "most"], *scaled(frames)],
        "cores": [["core", "profile", "kGE", "mm2, cells", "mm2, memories", "flip-flops",
                   "clock gates", "MHz", "pJ an idle clock", "mW idle"],
                  *[[str(cell) for cell in cells] for cells in cores.values()]],
        "blocks": [["core", "module", "kGE", *[f"pJ: {group}" for group in report.GROUPS], "busy",
                    "idle"], *[cells for what, of in shown.items() for cells in
                               block_rows(what, of)]],
        "paths": [["core", "ns", "through"],
                  *[cells for what, of in shown.items() for cells in path_rows(what, of)]],
        "events": [["event", "nJ"], *[[name, f"{weight:.4f}"] for name, weight in
                                      zip(fit.EVENTS, model.weights) if weight]],
        "profiles": [["profile", "scale of events", "fJ a clock and LUT4eq", "with triangles"],
                     *[[profile, f"{scale:.3f}", *[f"{clock * 1e6:.1f}" for clock in
                                                   model.clocks[profile]]]
                       for profile, scale in model.scales.items()]]})
    known.main(TABLE)
    said("make", tool)
    place(page, COMMAND, {"pixels": [["scene", "size", "core", "profile", "nJ a pixel"],
                                     *pixel_rows(tool)]})
    said(sys.executable, "-m", "lab", "pages")
