# tables.py - tables of docs/results/accuracy.md
# SPDX-License-Identifier: Apache-2.0
from ..pages import whole
from ..synth import report
from ..sweep import axes
from . import gather, points
from .gather import COMMON, core_of


def show(value, form="{}"):
    return "-" if value is None else form.format(value)


def name(profile):
    return f"`{profile}`"


def scene_name(scene):
    return f"`{scene}`"


def accuracy_row(study, profile):
    """PSNR of the common scenes and of huge_tiny, wrong pixels, worst t."""
    huge = study.accuracy(profile, "huge_tiny")
    tiny = "refused" if huge and "refused" in huge else show(gather.psnr(huge), "{:.1f}")
    kinds = ("silhouette", "wrong_id", "shadow", "reflected")
    return [show(gather.mean_psnr(study, profile), "{:.1f}"), tiny] \
        + [show(gather.wrong(study, profile, k)) for k in kinds] \
        + [show(gather.worst(study, profile, "t_worst"), "{:.1f}"),
           show(gather.mean_of(study, profile, "t_mean"), "{:.2f}")]


ACCURACY = ["PSNR", "huge_tiny", "silhouette", "sphere", "shadow", "mirror", "worst t", "mean t"]


def cost_row(study, core):
    """Cycles and cells; what follows of its clock, the page tells (lab/pages/rates.py)."""
    cells, cycles = study.cells(core), gather.frame_cycles(study, core)
    per_pixel = None if cycles is None else cycles / gather.pixels(points.FRAME)
    return [show(cycles, "{:.0f}"), show(per_pixel, "{:.2f}"),
            show(gather.ray_cycles(study, core), "{:.2f}")] \
        + [show(cells and cells[c]) for c in ("lut4eq", "ff", "bram", "mult")]


COST = ["cycles a frame", "a pixel", "a ray", "LUT4eq", "FF", "DP16KD", "MULT"]


def profiles(study):
    rows = [[name(p)] + accuracy_row(study, p) for p in points.PROFILES]
    return report.table(["profile"] + ACCURACY, rows)


def costs(study):
    rows = [[name(p)] + cost_row(study, core_of(p))
            + [show(gather.model_milliseconds(study, p), "{:.3g}"),
               show(gather.simulation_milliseconds(study, core_of(p)), "{:.3g}")]
            for p in points.PROFILES]
    return report.table(["profile"] + COST + ["model, ms", "simulated, ms"], rows)


def scenes(study):
    """PSNR of each profile on each scene, and who sees what wrong in it."""
    rows = []
    for s in points.SCENES:
        row = [scene_name(s)]
        for p in points.PROFILES:
            run = study.accuracy(p, s)
            if run and "refused" in run:
                row.append("refused")
            elif run:
                a = run["accuracy"]
                counts = " ".join(str(a[k]) for k in ("silhouette", "wrong_id", "shadow",
                                                      "reflected"))
                row.append(f"{show(gather.psnr(run), '{:.1f}')} ({counts}; {a['t_worst']:.1f})")
            else:
                row.append("-")
        rows.append(row)
    return report.table(["scene"] + points.PROFILES, rows)


def cycle_scenes(study):
    """Cycles a pixel and a ray of each scene."""
    rows = []
    for s in points.SCENES:
        row = [scene_name(s)]
        for p in points.PROFILES:
            run = study.cycles(core_of(p), s)
            if run and "refused" in run:
                row.append("refused")
                continue
            cycles = run and run["counters"]["cycles"] / gather.pixels(points.FRAME)
            row.append(f"{show(cycles, '{:.2f}')} "
                       f"({show(gather.ray_cycles(study, core_of(p), [s]), '{:.2f}')})")
        rows.append(row)
    return report.table(["scene"] + points.PROFILES, rows)


def knobs(study):
    rows = []
    for knob, profiles_of in points.KNOBS.items():
        for p in profiles_of:
            core = core_of(p)
            cells = study.cells(core)
            cycles = gather.frame_cycles(study, core)
            rows.append([knob.upper(), name(p)] + accuracy_row(study, p)
                        + [show(cycles and cycles / gather.pixels(points.FRAME), "{:.2f}")]
                        + [show(cells and cells[c]) for c in ("lut4eq", "ff", "mult")])
    return report.table(["knob", "profile"] + ACCURACY + ["cycles a pixel", "LUT4eq", "FF", "MULT"],
                        rows, left=2)


def rates(study):
    rows = []
    for r in points.RATES:
        what = ", ".join(f"{k} {v}" for k, v in r.items()) or "standard"
        rows.append([what] + cost_row(study, dict(core_of("standard"), **r)))
    return report.table(["core"] + COST, rows)


def trade_name(words):
    """background=exact, levels=1 as a reader says it."""
    if not words:
        return "none of them"
    texts = {"background": "background ", "levels": "level ", "traverse": "",
             "tree": "tree of the ", "depth": "depth "}
    return ", ".join(texts[k] + (f"{v} hit" if k == "traverse" else str(v))
                     for k, v in words.items())


def trades(study):
    rows, base = [], None
    for words in points.TRADES:
        pictures = [study.get(points.trade(words, s, "accuracy")) for s in COMMON]
        runs = [study.get(points.trade(words, s, "cycles")) for s in COMMON]
        cycles = gather.mean(r and r["counters"]["cycles"] for r in runs)
        base = base or cycles
        visits = gather.total(r and r["counters"]["node_visits"] for r in pictures)
        ids = gather.total(r and r["accuracy"]["wrong_id"] + r["accuracy"]["silhouette"]
                           for r in pictures)
        rays = gather.total(r and sum(r["counters"][f"rays_{k}"] for k in
                                      ("primary", "shadow", "reflected")) for r in pictures)
        rows.append([trade_name(words), show(gather.mean(map(gather.psnr, pictures)), "{:.1f}"),
                     show(ids), show(rays), show(visits),
                     show(cycles and cycles / gather.pixels(points.FRAME), "{:.2f}"),
                     show(cycles and 100 * cycles / base, "{:.1f} %")])
    return report.table(["trade", "PSNR", "wrong spheres", "rays", "visits", "cycles a pixel",
                         "cycles of none"], rows)


def model(study):
    rows = []
    for s in points.SCENES:
        runs = [study.accuracy(p, s) for p in points.PROFILES]
        seconds = [None if r is None or "refused" in r else r["cpu_seconds"] for r in runs]
        double = next((r["reference_cpu_seconds"] for r in reversed(runs)
                       if r and "refused" not in r), None)
        rows.append([scene_name(s)] + [show(t and 1000 * t, "{:.0f}") for t in seconds]
                    + [show(double and 1000 * double, "{:.0f}")])
    return report.table(["scene"] + points.PROFILES + ["double"], rows)


def decibels(study):
    """From one profile to the next: what a decibel costs."""
    rows = []
    for coarse, fine in zip(points.PROFILES, points.PROFILES[1:]):
        a, b = gather.mean_psnr(study, coarse), gather.mean_psnr(study, fine)
        gain = None if a is None or b is None else b - a
        row = [f"{name(coarse)} to {name(fine)}", show(gain, "{:.1f}")]
        left, right = study.cells(core_of(coarse)), study.cells(core_of(fine))
        for cell in ("lut4eq", "ff", "mult"):
            more = right[cell] - left[cell] if left and right else None
            row.append("-" if gain is None or more is None else f"{more / gain:+.1f}")
        x, y = (gather.frame_cycles(study, core_of(p)) for p in (coarse, fine))
        row.append("-" if gain is None or x is None or y is None
                   else f"{100 * (y / x - 1) / gain:+.2f} %")
        rows.append(row)
    return report.table(["step", "dB", "LUT4eq a dB", "FF a dB", "MULT a dB", "cycles a dB"],
                        rows)


def kinds(study):
    """A picture's error, clocks a pixel and the cells of the scene's own core, kind by kind; cells
    of a core that nobody has synthesised are a dash."""
    rows = []
    for what, (words, core) in points.KINDS.items():
        prices = study.price(words)
        for p in points.PROFILES:
            of, cells = prices.get(p), study.look(axes.job("cells", profile=p, effects=core))
            cells = cells and cells["core"]
            if of and of["core"] != core:
                whole.lack(f"{words['scene']} asks for the core {of['core']}, not {core}")
            rows.append([what, scene_name(words["scene"]), name(p), core,
                         show(of and of["measured"]["psnr"], "{:.1f}"),
                         show(of and of["cycles_per_pixel"], "{:.2f}")]
                        + [show(cells and cells[c]) for c in ("lut4eq", "ff", "bram", "mult")])
    return report.table(["what", "scene", "profile", "core", "dB", "cycles a pixel", "LUT4eq", "FF",
                         "DP16KD", "MULT"], rows, left=4)


def width(study):
    """Cycles a pixel by profile, and how many times as many the widest takes as the cheapest."""
    rows = []
    for what, words in ({w: of for w, (of, _) in points.KINDS.items()} | points.TREES).items():
        prices = study.price(words)
        cycles = [prices.get(p, {}).get("cycles_per_pixel") for p in points.PROFILES]
        times = None if None in cycles else cycles[-1] / min(cycles)
        rows.append([what, scene_name(words["scene"]), *(show(c, "{:.1f}") for c in cycles),
                     show(times, "{:.2f}")])
    return report.table(["what", "scene"] + points.PROFILES + ["reference, times the cheapest"],
                        rows, left=2)


TABLES = {"profiles": profiles, "costs": costs, "scenes": scenes, "cyclescenes": cycle_scenes,
          "kinds": kinds, "width": width, "knobs": knobs, "rates": rates, "trades": trades,
          "model": model, "decibels": decibels}
