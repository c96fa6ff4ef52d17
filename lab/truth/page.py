#!/usr/bin/env python3
# page.py - puts the tables of docs/results/accuracy.md in their places, and its pictures beside it
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab truth-page PAGE FOLDER PICTURES
FOLDER is what measure.py left. A picture that the page shows is copied to PICTURES. A dash: the
profile cannot draw the scene, or the pictures are equal."""
import json
import re
import shutil
from pathlib import Path

from ..pages import whole
from ..pages.place import place
from ..synth.report import table
from . import scenes

WHY = {"edge": "edge", "object": "other object", "doubtful": "doubtful",
       "beyond": "beyond the grid", "arithmetic": "arithmetic", "limit": "light above 1",
       "total": "total reflection", "rule": "rule"}
KEPT = 45.0  # dB that `auto` is to keep
EQUAL = 99.0  # dB, for means, where pictures are equal


def results(folder):
    """{name: result}, by name."""
    found = {}
    for path in sorted(Path(folder).glob("*.json")):
        found[path.stem] = json.loads(path.read_text(encoding="utf-8"))
    return found


def coincident(folder):
    """Pixels that show another object than exact numbers do."""
    found, rows = results(Path(folder, "exact")), []
    for name, _ in scenes.coincident() or [(f"any scene of {scenes.COINCIDENT}", None)]:
        if name not in found:
            return whole.lack(f"no result of {name}")
        r = found[name]
        rows.append([name, r["near"], r["undecidable"], r["reference"]] +
                    ["-" if "refused" in r["model"][p] else r["model"][p]["wrong"]
                     for p in scenes.PROFILES])
    return table(["scene", "within 10^-12", "undecidable", "double reference"] + scenes.PROFILES,
                 rows)


def lacking(found):
    """Notes the scenes that were not drawn; whether there are any."""
    wanted = [name for name, _ in scenes.files()] + ["protein"] + [
        kind.replace(":", "") for kind in scenes.GENERATED]
    for name in set(wanted) - set(found):
        whole.lack(f"no result of {name}")
    return bool(whole.LACKING)


def decibel(value):
    return "equal" if value is None else f"{value:.1f}"


def reference(found):
    """The double reference against POV-Ray."""
    rows = []
    for name, r in found.items():
        whole, limited = r["reference"], r["limited"]
        rows.append([name, r["depth"], f"{100 * r['away'] / r['pixels']:.0f} %",
                     decibel(whole["psnr"]), whole["wrong"], whole["far_off"],
                     decibel(limited["psnr"]), limited["far_off"]])
    return table(["scene", "depth", "inner", "dB", "other object", "far off", "limited, dB",
                  "limited, far off"], rows)


def cells(found, show):
    return [[name] + ["-" if "refused" in r["model"][p] else show(r, r["model"][p])
                      for p in scenes.PROFILES] for name, r in found.items()]


def column(found, profile):
    """dB of every scene that the profile draws."""
    drawn = (r["model"][profile] for r in found.values() if "refused" not in r["model"][profile])
    return [EQUAL if m["psnr"] is None else m["psnr"] for m in drawn]


def model(found):
    """The model against POV-Ray: dB of all pixels."""
    rows = cells(found, lambda r, m: decibel(m["psnr"]))
    every = [column(found, p) for p in scenes.PROFILES]
    rows.append(["mean"] + [decibel(sum(c) / len(c)) for c in every])
    rows.append(["worst"] + [decibel(min(c)) for c in every])
    return table(["scene"] + scenes.PROFILES, rows)


def wrong(found):
    """Pixels whose object is another one: all of them, and inner ones."""
    rows = cells(found, lambda r, m: f"{m['wrong']} / {m['wrong_away']}")
    return table(["scene"] + scenes.PROFILES, rows)


def why(found):
    """Causes of what is far off at standard."""
    rows = []
    for name, r in found.items():
        m = r["model"]["standard"]
        if "refused" not in m:
            rows.append([name, m["far_off"]] + [m["why"][key] for key in WHY])
    return table(["scene", "far off"] + list(WHY.values()), rows)


def below(found):
    """Causes of what is far off at auto, of scenes below KEPT; dB under the machine's own rules;
    dB against POV-Ray of all pixels but those far off by doubt, planes' ends and rules."""
    rows = []
    for name, r in found.items():
        m = r["model"]["auto"]
        if "refused" not in m and m["psnr"] is not None and m["psnr"] < KEPT:
            rows.append([name, decibel(m["psnr"]), decibel(m["own"]), decibel(m["rest"])] +
                        [m["why"][key] for key in WHY])
    return table(["scene", "dB", "own rules, dB", "rest, dB"] + list(WHY.values()), rows)


def scale(folder):
    """Lines of tests/tool/test_scale.sh, names as words."""
    rows = [line.split() for line in Path(folder, "scale.txt").read_text("utf-8").splitlines()]
    return table(["paper5", "dB", "other object"],
                 [[name.replace("_", " "), *said] for name, *said in rows])


def main(page, folder, shown):
    found = results(folder)
    made = {"reference": reference, "model": model, "wrong": wrong, "why": why, "below": below}
    alone = {"truth_scale": lambda: scale(folder), "truth_coincident": lambda: coincident(folder)}
    place(page, "make truth", alone | {
        "truth_" + name: lambda table=table: None if lacking(found) else table(found)
        for name, table in made.items()})
    Path(shown).mkdir(parents=True, exist_ok=True)
    text = Path(page).read_text(encoding="utf-8")
    for name in re.findall(rf"{Path(shown).name}/(\w+)\.png", text):
        picture = Path(folder, name + ".png")
        if picture.exists():
            shutil.copy(picture, shown)
