# measures.py - what a job of a sweep runs, what its result depends on, and its figures
# SPDX-License-Identifier: Apache-2.0
"""Measures are counts (the golden model alone), accuracy (against the double reference), price
(of all profiles at once), cycles (the RTL, held against the model) and cells (Yosys). What a
profile or a core refuses is a result: {"refused": why}."""
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from ..jobs import store
from ..runner import PROTEIN, named
from ..synth import results
from . import axes

GUESS = {"counts": 1, "accuracy": 10, "price": 5, "cycles": 40, "cells": 120}  # seconds of a job
OPTIONS = {"levels": "--bg-levels", "samples": "--samples", "max_prims": "--max-prims",
           "max_tree_depth": "--max-tree-depth", "at": "--at", "truth": "--truth"}
ALWAYS = {"size": "--size", "profile": "--profile", "accel": "--accel", "depth": "--depth",
          "background": "--background", "traverse": "--traverse"}
OPT = os.environ.get("STUDY_OPT", "-O1")  # of the simulation: compiled once, run for seconds
RAYS = [f"rays_{kind}" for kind in ("primary", "shadow", "reflected", "refracted")]
MODEL = ["cmodel/*/*.[ch]", "cmodel/machine/machine.def", "lab/sweep/measures.py"]
RTL = ["rtl/*/*.v", "rtl/*/*.vh", "tb/core/*", "sim/core.sh", "make/core.mk"]


def call(command, **more):
    """Runs it; its outputs and exit code."""
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False, **more)


def fail(what, ran):
    sys.exit(f"sweep: {what}:\n{ran.stdout}{ran.stderr}")


def made(scene):
    """Whether a scene is KIND:N of `sphaera gen`, and no FILE:NAME."""
    return re.fullmatch("[a-z0-9_]+:[0-9]+", scene) and not os.path.exists(scene.split(":")[0])


def own_file(scene):
    """FILE or FILE:NAME of a scene that nothing makes."""
    file = scene.rpartition(":")[0] or scene
    return scene if os.path.exists(scene) or os.path.isfile(file) else named(scene)


def scene_file(tool, build, scene, seed="1"):
    """A file of the scene: of scenes/, anywhere, or made: KIND:N, protein."""
    if scene != "protein" and not made(scene):
        return own_file(scene)
    path = f"{build}/sweep/scenes/{scene.replace(':', '')}-{seed}.nff"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    ran = call([tool, "import", PROTEIN, "-o", path] if scene == "protein" else
               [tool, "gen", scene, "--seed", seed, "-o", path])
    if ran.returncode:  # whole or not at all, so two jobs may do it
        fail(scene, ran)
    return path


def scene_files(scene):
    """Files that a scene is made from: its own, and those that its words name, such as images."""
    if scene == "protein" or made(scene):
        return [PROTEIN] if scene == "protein" else []
    file = own_file(scene)
    if not os.path.isfile(file):
        file = file.rpartition(":")[0]
    found, todo = [], [Path(file)]
    while todo:
        path = todo.pop()
        if str(path) in found or not path.is_file():
            continue
        found.append(str(path))
        if path.suffix in (".nff", ".aff", ".obj", ".mtl", ".gltf"):
            text = path.read_text(encoding="utf-8", errors="replace")
            names = set(re.findall(r'[^\s",]+\.[A-Za-z0-9]+', text))
            todo += [path.parent / name for name in names if len(name) < 200]
    return sorted(found)


def options(w):
    """Words of a key as options of `sphaera build`."""
    said = []
    for name, option in ALWAYS.items():
        said += [option, w[name]] if w.get(name) else []
    for name, option in OPTIONS.items():
        said += [option, w[name]] if w.get(name) not in (None, "", axes.DEFAULTS[name]) else []
    # a core of one's own words that has no `camera` takes machines alone that lack nothing
    if not re.search(r"^(auto|all)\b|\bcamera\b", w.get("effects", "auto")):
        said += ["--effects", "all"]
    return said + (["--tree", w["tree"]] if w["tree"] != "auto" else []) + w["build_more"].split()


def refused(ran):
    """Why the builder refuses the scene in this profile, None: another failure."""
    text = ran.stderr.strip()
    return text.removeprefix("sphaera: ") if ran.returncode == 1 and "profile" in text else None


def reported(tool, build, w, command, *more):
    """(the report of a command of the tool, None) or (None, the refusal)"""
    ran = call([tool, command, scene_file(tool, build, w["scene"]), *options(w), *more, "--json",
                "-"])
    if ran.returncode:
        return None, {"refused": refused(ran)} if refused(ran) else fail(w["scene"], ran)
    return json.loads(ran.stdout), None


def counts(tool, build, w, temporary):
    del temporary
    report, no = reported(tool, build, w, "render", "--threads", "1")
    return no or {"counters": report["counters"],
                  "pixels": report["frame"]["width"] * report["frame"]["height"],
                  "picture": report["frame"]["picture_hash"],
                  "tree_bytes": report["machine"]["tree_bytes"],
                  "memory_bytes": report["machine"]["memory_bytes"]}


def accuracy(tool, build, w, temporary):
    del temporary
    report, no = reported(tool, build, w, "accuracy", "--threads", "1")
    if no:
        return no
    if report["errors"]:
        sys.exit(f"sweep: {w['scene']}: errors of the machine: {report['errors']}")
    return {"accuracy": report["accuracy"], "counters": report["counters"],
            "grid_step": report["machine"]["grid_step"], "cpu_seconds": report["cpu_seconds"],
            "build_seconds": report["build"]["seconds"],
            "reference_cpu_seconds": report["reference_cpu_seconds"]}


def price(tool, build, w, temporary):
    """The rows of `sphaera price`: what a profile's picture is like, and clocks a pixel."""
    del temporary
    report, no = reported(tool, build, w, "price", "--pixels", "0", "--threads", "1")
    return no or {"rows": report["price"]["rows"]}


def variables(w):
    """The environment of sim/core.sh and sim/cores.py, which the names of units are."""
    return {name.upper(): w[name] for name in ["effects", *axes.UNITS]}


def cycles(tool, build, w, temporary):
    machine, report = f"{temporary}/scene.sph", f"{temporary}/report.json"
    scene = scene_file(tool, build, w["scene"], w["seed"])
    ran = call([tool, "build", scene, *options(w), "-o", machine])
    if ran.returncode:
        return {"refused": refused(ran)} if refused(ran) else fail(w["scene"], ran)
    ran = call(["sh", "sim/core.sh", "--machine", machine, "--latency", w["latency"], "--stall",
                w["stall"], "--seed", w["seed"], "--memory", w["memory"], "--core-mhz",
                w["core_mhz"], *["--warm"] * (w["warm"] == "1"), "--json", report],
               env=dict(os.environ, BUILD=build, OPT=OPT, JOBS="1", MAKEFLAGS="", **variables(w)))
    if ran.returncode:
        fail("model and RTL, or the core", ran)
    with open(report, encoding="utf-8") as f:
        run = json.load(f)
    caches = run["warm" if w["warm"] == "1" else "cold"]
    limit = {name: caches["limit"][name] for name in ("binds", "unit", "busy")}
    return {"counters": caches["counters"], "pixels": run["pixels"], "limit": limit,
            "cpu": run["cpu_seconds"]}


def synthesised(build, w):
    """The folder of a core that make/area.mk has synthesised."""
    ran = call(["sim/cores.py", "key", w["profile"], w["effects"], w["target"]],
               env=dict(os.environ, **variables(w)))
    if ran.returncode:
        fail("synthesis", ran)
    version = ""
    if w["yosys"] != "yosys":
        version = "-" + call([w["yosys"], "-V"]).stdout.split()[1]
    return f"{build}/synth{version}/{ran.stdout.strip()}"


def cells(tool, build, w, temporary):
    del tool, temporary
    ran = call(["make", "-s", "-f", "make/area.mk", "results", f"B={build}",
                f"TARGETS={w['target']}", f"PROFILES={w['profile']}", f"YOSYS={w['yosys']}",
                *(f"{name}={value}" for name, value in variables(w).items())],
               env={k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")})
    if ran.returncode:
        fail("synthesis", ran)
    run = results.read(synthesised(build, w))
    return {"core": run["core"], "depth": run["depth"], "yosys": run["yosys"],
            "seconds": run["seconds"]}


MEASURES = {"counts": counts, "accuracy": accuracy, "price": price, "cycles": cycles,
            "cells": cells}


def tools(w):
    """Tools whose version a result depends on."""
    return {"cycles": ["verilator"], "cells": [w.get("yosys", "")]}.get(w["measure"], [])


def version(tool):
    """As a table shows it: `Verilator 5.006`."""
    return re.sub(r"^[^:]*: ", "", store.version(tool).decode().strip())


def sources(build, w):
    """Patterns of the files that a result depends on, and tools."""
    if w["measure"] == "cells":
        with open(f"{synthesised(build, w)}/sources.d", encoding="utf-8") as f:
            found = f.readlines()[-1].rstrip(":\n").split() + ["lab/sweep/measures.py"]
    else:
        found = MODEL + scene_files(w["scene"]) + RTL * (w["measure"] == "cycles")
    return found + [store.TOOL + tool for tool in tools(w)]


def main(tool, build, folder, key):
    """One job; nothing if its result is there and counts. Exit code 1: it failed, nothing was
    written."""
    w = axes.words(key)
    if store.look(folder, key)[1] is None:
        return
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="sphaera-sweep-") as temporary:
        result = MEASURES[w["measure"]](tool, build, w, temporary)
    store.save(folder, key, sources(build, w), result, time.monotonic() - began)


# ---- figures ----
def _counted(result, pixels):
    counters = result["counters"]
    rays = sum(counters.get(name, 0) for name in RAYS)
    found = {f"{name}_counted" if name in axes.KNOWN else name: n for name, n in counters.items()}
    found["rays"] = rays
    for name in ("node_visits", "leaf_tests", "facet_tests", "cycles"):
        if name in counters:
            found[f"{name}_per_pixel"] = round(counters[name] / pixels, 6)
            found[f"{name}_per_ray"] = round(counters[name] / rays, 6) if rays else ""
    return found


def figures(w, result):
    """{name: number or text} of a result, nothing that a clock of this machine says; w has the
    profile, which `price` needs."""
    if "refused" in result:
        return {"refused": result["refused"]}
    measure = w["measure"]
    if measure == "counts":
        return dict(_counted(result, result["pixels"]), picture=result["picture"],
                    tree_bytes=result["tree_bytes"], memory_bytes=result["memory_bytes"])
    if measure == "cycles":
        limit = result["limit"]
        return dict(_counted(result, result["pixels"]),
                    limit=limit["unit"] if limit["binds"] else "no unit",
                    busy=round(limit["busy"], 6))
    if measure == "accuracy":
        found = result["accuracy"]
        return {"psnr": "equal" if found["psnr"][-1] is None else round(found["psnr"][-1], 6),
                **{name: found[name] for name in ("silhouette", "wrong_id", "shadow", "reflected",
                                                  "refracted")},
                "t_worst": round(found["t_worst"], 6), "t_mean": round(found["t_mean"], 6)}
    if measure == "cells":
        return dict(result["core"], depth=result["depth"])
    row = next((row for row in result["rows"] if row["profile"] == w["profile"]), None)
    if not row or not row["measured"]:
        return {"refused": row["why"] if row else f"price has no profile {w['profile']}"}
    return {"price_psnr": row["measured"]["psnr"], "price_wrong": row["measured"]["wrong"],
            "price_cycles_per_pixel": round(row["cycles_per_pixel"], 6), "price_core": row["core"]}
