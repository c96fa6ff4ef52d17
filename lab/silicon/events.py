# events.py - frames by cores in standard cells, and what an event takes: docs/results/silicon.md
# SPDX-License-Identifier: Apache-2.0
"""Draws RUNS with `make silicon`, fits energies of events to those that are `in` the fit, and puts
all of it into the page: each frame with what the fit says of it, cores, energies."""
import json
from pathlib import Path

from .. import known
from ..pages.place import place
from ..runner import said
from . import fit, report

CORE = "shadow+reflect2+lights3+inside"
SIZE = "32x18"
# fit, profile, scene, more words of make
RUNS = [("in", "standard", scene, ()) for scene in (
    "random:16", "random:64", "random:256", "random:4096", "sphereflake:3", "paper5", "paper100",
    "one_sphere", "inside")] + [
        ("out", "standard", scene, more) for scene, more in (
            ("random:256", ("SEED=3",)), ("random:256", ("DEPTH=0",)), ("random:1024", ()),
            ("sphereflake:2", ()), ("paper100", ("DEPTH=1",)), ("materials", ()),
            ("huge_tiny", ()), ("no_light", ()))] + [
                (which, profile, scene, ()) for profile in ("draft", "reference")
                for which, scene in (("in", "random:256"), ("out", "paper5"))]
HEAD = ["frame", "profile", "fit", "cycles", *fit.COUNTS, "rays", "nJ", "idle pJ", "nJ a pixel",
        "nJ a ray", *[f"pJ: {group}" for group in report.GROUPS], "fit says", "off"]
NODES = ((180, 1.8), (130, 1.2), (28, 0.9))     # nm, volts: ours, MRTP's, RayCore's (assumed)


def scaled(frames):
    """nJ a ray of the frames at other nodes, as length and the square of voltage go."""
    rays = [float(frame["nJ a ray"]) for frame in frames]
    for length, volts in NODES:
        factor = length / NODES[0][0] * (volts / NODES[0][1]) ** 2
        yield [f"{length} nm", f"{volts} V", f"{factor:.3f}", f"{min(rays) * factor:.2f}",
               f"{max(rays) * factor:.2f}"]


def drawn(profile, scene, more):
    """silicon.json of a run."""
    words = [f"SCENE={scene}", f"PROFILE={profile}", f"EFFECTS={CORE}", f"SIZE={SIZE}", *more]
    print("  RUN ", *words, flush=True)
    said("make", "--no-print-directory", "silicon", *words)
    folder = said("make", "-s", "--no-print-directory", "silicon-folder", "SIM=silicon", *words)
    return json.loads(Path(folder.split()[-1], "silicon.json").read_text("utf-8"))


def row(which, profile, scene, more, found):
    energy = found["energy"]
    clocks = found["cycles"]
    return [" ".join([f"`{scene}`", *more]), profile, which, clocks,
            *fit.counts(found["counters"]), found["rays"],
            f"{energy['nj_pixel'] * found['pixels']:.1f}", f"{sum(energy['idle'].values()):.1f}",
            f"{energy['nj_pixel']:.2f}", f"{energy['nj_ray']:.2f}",
            *[f"{energy['busy'][group]:.0f}" for group in report.GROUPS]]


def core_row(profile, found):
    energy = found["energy"]
    return [profile, f"{found['kge']:.1f}", f"{found['logic_mm2']:.2f}",
            f"{found['memory_mm2']:.2f}", found["flip_flops"], found["clock_gates"],
            f"{found['mhz']:.1f}" if found["mhz"] else "-", f"{sum(energy['idle'].values()):.0f}",
            f"{energy['idle_mw']:.0f}" if energy["idle_mw"] else "-"]


def block_rows(found):
    """Of the standard core and random:256: those modules that take a percent of the energy."""
    blocks = found["blocks"]
    whole = sum(report.summed(block, "busy") for block in blocks.values())
    order = sorted(blocks, key=lambda name: -report.summed(blocks[name], "busy"))
    return [[f"`{name}`", f"{blocks[name]['kge']:.1f}",
             *[f"{blocks[name].get('busy', {}).get(group, 0):.0f}" for group in report.GROUPS],
             *[f"{report.summed(blocks[name], phase):.0f}" for phase in report.PHASES]]
            for name in order if report.summed(blocks[name], "busy") > whole / 100]


def main(page):
    rows, cores, shown, area = [], {}, None, known.cells()
    for which, profile, scene, more in RUNS:
        found = drawn(profile, scene, more)
        rows.append([str(cell) for cell in row(which, profile, scene, more, found)])
        cores.setdefault(profile, core_row(profile, found))
        if (profile, scene, more) == ("standard", "random:256", ()):
            shown = found
    frames = fit.frames_of([HEAD, *rows])
    lut4eq = {profile: int(area[(profile, CORE, 1)][0]) for profile in cores}
    model = fit.fitted(frames, lut4eq)
    for cells, frame in zip(rows, frames):
        says = sum(model.parts(frame["profile"], lut4eq[frame["profile"]], frame["cycles"],
                               [frame[name] for name in fit.COUNTS]).values())
        cells += [f"{says:.1f}", f"{100 * (says / frame['nJ'] - 1):+.1f} %"]
    place(page, "make silicon-energy", {
        "frames": [HEAD, *rows],
        "scaled": [["node", "voltage", "factor", "nJ a ray, least", "most"], *scaled(frames)],
        "cores": [["profile", "kGE", "mm2, cells", "mm2, memories", "flip-flops", "clock gates",
                   "MHz", "pJ an idle clock", "mW idle"],
                  *[[str(cell) for cell in cells] for cells in cores.values()]],
        "blocks": [["module", "kGE", *[f"pJ: {group}" for group in report.GROUPS], "busy", "idle"],
                   *block_rows(shown)],
        "paths": [["ns", "through"], *[[f"{path['ns']:.2f}", " > ".join(
            f"`{module}`" for module in path["through"])] for path in shown["paths"] or []]],
        "events": [["event", "nJ"], *[[name, f"{weight:.4f}"] for name, weight in
                                      zip(fit.EVENTS, model.weights)]],
        "profiles": [["profile", "scale of events", "fJ a clock and LUT4eq"],
                     *[[profile, f"{model.scales[profile]:.3f}",
                        f"{model.clocks[profile] * 1e6:.1f}"] for profile in cores]]})
