# page.py - the page of the study on results that are made up: every figure can be told beforehand
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.checks.page FOLDER"""
import re
import shutil
import subprocess
import sys
import xml.dom.minidom
from pathlib import Path

from ..pages import markdown
from ..jobs import store
from ..study import gather, points, tables
from ..sweep import axes

folder = sys.argv[1]
results, page = folder + "/results", folder + "/docs/results/accuracy.md"
beside = Path(page).parent / "data"  # tables that are too long for the page
beside.mkdir(parents=True)
shutil.copy("docs/results/data/accuracy.tsv", beside)


def page_of(*options):
    shutil.copy("docs/results/accuracy.md", page)
    ran = subprocess.run([sys.executable, "-m", "lab", "accuracy-page", *options, page, results,
                          folder + "/plots"],
                         check=True, stdout=subprocess.PIPE, text=True)
    text = ran.stdout + markdown.REGION.sub("", Path(page).read_text(encoding="utf-8"))
    found = [[c.strip() for c in line.split("|")[1:-1]] for line in text.splitlines()
             if line.startswith("| ")]
    for path in sorted(beside.glob("*.tsv")):
        found += [line.split("\t") for line in path.read_text(encoding="utf-8").splitlines()]
    return ran.stdout, found


def row(rows, *start):
    found = [r for r in rows if r[:len(start)] == list(start)]
    assert found, (start, rows)
    return found


def accuracy(psnr, **more):
    counts = dict(silhouette=1, wrong_id=2, shadow=3, reflected=4, worst=9, t_worst=1.5,
                  t_mean=0.25, **more)
    return {"accuracy": dict(counts, psnr=[None, None, psnr]), "cpu_seconds": 0.5,
            "counters": {"rays_primary": 10, "rays_shadow": 0, "rays_reflected": 0,
                         "node_visits": 20}, "reference_cpu_seconds": 0.25}


# ---- nothing is there: dashes, no plot ----
said, rows = page_of()
assert f"0 of {len(points.plan())} results" in said and "0 plots" in said, said
assert row(rows, "`standard`")[0][1:3] == ["-", "-"]
assert row(rows, "`standard`")[1][1:] == ["-"] * 9

# ---- draft and standard are there; an equal picture counts as 70 dB ----
for profile, base in ("draft", 40.0), ("standard", 50.0):
    for i, scene in enumerate(points.SCENES):
        psnr = None if profile == "standard" and scene == "paper100" else base + i
        key = axes.job("accuracy", profile=profile, scene=scene, size=points.PICTURE)
        refused = profile == "draft" and scene == "huge_tiny"
        store.save(results, key, [], {"refused": "too small"} if refused else accuracy(psnr))
        counters = {"cycles": 100000, "rays_primary": 5000, "rays_shadow": 3000,
                    "rays_reflected": 2000}
        store.save(results, axes.job("cycles", scene=scene, size=points.FRAME,
                                    **gather.core_of(profile)), [],
                   {"counters": counters, "cpu": 2.0})
    core = {"lut4eq": 10000 if profile == "draft" else 17900, "ff": 9000, "bram": 80, "mult": 64}
    store.save(results, axes.job("cells", **gather.core_of(profile)), [],
              {"core": core, "yosys": "Yosys 0.23 (git)"})
said, rows = page_of()

draft, standard = row(rows, "`draft`"), row(rows, "`standard`")
# scenes 0, 1, 2 and 4 of five: 40 41 42 44; 50 51 70 54
assert draft[0][1:3] == ["41.8", "refused"] and standard[0][1:3] == ["56.2", "53.0"], (draft, rows)
assert standard[0][3:7] == ["4", "8", "12", "16"], standard
assert standard[0][7:] == ["1.5", "0.25"], standard
# 100000 cycles, 96*54 pixels
cost = standard[1]
assert cost[1:4] == ["100000", "19.29", "10.00"], cost
# half a second for 320 x 180 pixels of the model, two for a frame of the simulated core
assert cost[4:] == ["17900", "9000", "80", "64", "45", "2e+03"], cost
step = row(rows, "`draft` to `standard`")[0]
assert step[1:3] == ["14.5", "+544.8"], step
assert "70.0 (1 2 3 4; 1.5)" in [r[2] for r in row(rows, "`paper100`")]
assert row(rows, "W", "`standard:w=14`")[0][2] == "-"
text = Path(page).read_text(encoding="utf-8")
assert "Yosys 0.23 ([speed_and_area.md](" in text, "a link was taken"
assert "2 plots" in said, said
for name in "multipliers", "luts":
    svg = f"{folder}/docs/pictures/accuracy/pareto_{name}.svg"
    text = xml.dom.minidom.parse(svg).toxml()
    assert "standard" in text and "draft" in text, svg

# ---- what lacks a result is told, and stays as it was in the page; the rest has its stamp ----
text = Path(page).read_text(encoding="utf-8")
assert "the table profiles stays as it is: no result of " in said, said
assert not re.search(r"`standard` *\| 56\.2 ", text), text
record = beside / "measured.tsv"
stamped = {line.split("\t")[1] for line in record.read_text(encoding="utf-8").splitlines()
           if not line.startswith("#")} if record.exists() else set()
told = set(re.findall(r"the table (\w+) stays as it is", said))
assert told == set(tables.TABLES) and not stamped, (told, stamped)
