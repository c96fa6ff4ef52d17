# cycles.py - clocks of frames as `sphaera price` foretells them, against the RTL's
# SPDX-License-Identifier: Apache-2.0
"""measure() simulates every row of docs/results/data/cycles.tsv, 160 x 120 pixels from memory that
answers after 100 clocks, or those of SCENEs alone, and writes the table anew; a new row needs its
first four columns alone.
check() takes the RTL's clocks from the table and tells where the model's are farther off than a
class of scenes is allowed: some seconds. The classes stand in BOUNDS, as the tool prints them."""
import json
import sys
import tempfile
from pathlib import Path

from . import intact
from .pages import data
from .runner import said, scene_file

TABLE, SIZE, LATENCY = "cycles", "160x120", "100"
HEAD = ["scene", "profile", "accel", "pipes", "RTL", "model", "ratio", "limit"]
TEXELS = ("texture/robot", "texture/hall")  # levels to texels, longitudes bind: no counter has them
BOUNDS = {True: 0.25, False: 0.07}


def foretold(tool, scene, profile, accel, pipes):
    """Clocks of the frame, and the unit that limits most of it."""
    with tempfile.TemporaryDirectory() as folder:
        file = scene_file(tool, scene, f"{folder}/scene.nff")
        report = json.loads(said(tool, "price", file, "--size", SIZE, "--profile", profile,
                                 "--accel", accel, "--effects", "all", "--json", "-",
                                 *(["--more"] if pipes != "1" else [])))["price"]
    row = next(row for row in report["rows"]
               if row["profile"] == profile and str(row["pipes"]) == pipes)
    return row["cycles_per_pixel"] * report["width"] * report["height"], row["limit"]["unit"]


def simulated(scene, profile, accel, pipes):
    """Clocks of the frame on the RTL."""
    words = [f"SCENE={scene}", f"PROFILE={profile}", f"ACCEL={accel}", f"PIPES={pipes}",
             f"SIZE={SIZE}", f"LATENCY={LATENCY}", "BUILD_MORE=--effects all"]
    said("make", "sim", *words)
    folder = said("make", "-s", "sim-folder", *words).split()[-1]
    report = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))
    return report["cold"]["counters"]["cycles"]


def rows():
    return [dict(zip(HEAD, row)) for row in data.read(TABLE)[1]]


def measure(tool, *scenes):
    found = []
    for row in rows():
        key = [row[name] for name in HEAD[:4]]
        if scenes and row["scene"] not in scenes:
            found.append(list(row.values()))
            continue
        clocks, (model, limit) = simulated(*key), foretold(tool, *key)
        found.append(key + [str(clocks), f"{model:.0f}", f"{model / clocks:.3f}", limit])
        print(*found[-1], sep="\t")
    intact.write(data.FOLDER / f"{TABLE}.tsv", data.of_rows([HEAD] + found))


def check(tool):
    """1 if a row is off by more than its class may be, or is another one than the table has."""
    wrong, ratios = 0, []
    for row in rows():
        model, _ = foretold(tool, *(row[name] for name in HEAD[:4]))
        ratios.append(model / int(row["RTL"]))
        off, most = abs(ratios[-1] - 1), BOUNDS[row["scene"] in TEXELS]
        if off > most or f"{model:.0f}" != row["model"]:
            wrong = 1
            print(f"{row['scene']} {row['profile']} {row['accel']} {row['pipes']}: {model:.0f} "
                  f"clocks, {off:.1%} off the RTL's {row['RTL']}; the table has {row['model']}")
    near = sum(abs(ratio - 1) <= 0.05 for ratio in ratios)
    print(f"{len(ratios)} frames, {near} within 5 %: {min(ratios):.3f} to {max(ratios):.3f}")
    sys.exit(wrong)
