# run.py - runs one job of a study and keeps its result
# SPDX-License-Identifier: Apache-2.0
"""KEY as keys.py has it. Does nothing if the result is there and counts. Exit code 1: the job
failed, nothing was written. A profile that refuses a scene is a result: {"refused": why}."""
import json
import os
import subprocess
import sys
import tempfile
import time

from .. import tree_options
from ..jobs import store
from ..synth import results
from . import keys

OPT = os.environ.get("STUDY_OPT", "-O1")  # of the simulation: compiled once, run for seconds


def call(command, **more):
    """Runs it; its outputs and exit code."""
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False, **more)


def fail(what, ran):
    sys.exit(f"study: {what}:\n{ran.stdout}{ran.stderr}")


def scene_file(tool, build, scene):
    """A file of the scene: NAME in scenes/, KIND:N of `sphaera gen`, or protein."""
    if scene != "protein" and ":" not in scene:
        return f"scenes/{scene}.nff"
    kind, _, number = scene.partition(":")
    path = f"{build}/study/scenes/{kind}{number}.nff"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if scene == "protein":
        command = [tool, "import", keys.PROTEIN, "-o", path]
    else:
        command = [tool, "gen", scene, "-o", path]
    ran = call(command)  # whole or not at all, so two jobs may do it
    if ran.returncode:
        fail(scene, ran)
    return path


def options(w):
    """Words of a key as options of `sphaera build`."""
    background, _, level = w["background"].partition("-")
    return ["--profile", w["profile"], "--size", w["size"], "--traverse", w["traverse"],
            "--background", background, "--depth", w["depth"]] \
        + tree_options.options(w["tree"]) + (["--bg-levels", level] if level else [])


def refused(ran):
    """Why the builder refuses the scene in this profile, None: another failure."""
    text = ran.stderr.strip()
    return text.removeprefix("sphaera: ") if ran.returncode == 1 and "profile" in text else None


def accuracy(tool, build, w, temporary):
    ran = call([tool, "accuracy", scene_file(tool, build, w["scene"]), *options(w), "--truth",
                w["truth"], "--threads", "1", "--json", "-"])
    if ran.returncode:
        return {"refused": refused(ran)} if refused(ran) else fail(w["scene"], ran)
    report = json.loads(ran.stdout)
    if report["errors"]:
        fail("errors of the machine", ran)
    return {"accuracy": report["accuracy"], "counters": report["counters"],
            "grid_step": report["machine"]["grid_step"], "cpu_seconds": report["cpu_seconds"],
            "build_seconds": report["build"]["seconds"],
            "reference_cpu_seconds": report["reference_cpu_seconds"]}


def cycles(tool, build, w, temporary):
    machine, report = f"{temporary}/scene.sph", f"{temporary}/report.json"
    ran = call([tool, "build", scene_file(tool, build, w["scene"]), *options(w), "-o", machine])
    if ran.returncode:
        return {"refused": refused(ran)} if refused(ran) else fail(w["scene"], ran)
    ran = call(["sh", "sim/core.sh", "--machine", machine, "--latency", "20", "--json", report],
               env=dict(os.environ, BUILD=build, EFFECTS=w["core"], ENGINES=w["engines"],
                        ROOT_STEP=w["root"], QUOTIENT_STEP=w["quotient"], OPT=OPT, JOBS="1",
                        MAKEFLAGS=""))
    if ran.returncode:
        fail("model and RTL, or the core", ran)
    with open(report, encoding="utf-8") as f:
        run = json.load(f)
    return {"counters": run["cold"]["counters"], "cpu": run["cpu_seconds"]}


def price(tool, build, w, temporary):
    """The rows of `sphaera price`: what a profile's picture is like, and clocks a pixel."""
    del temporary
    ran = call([tool, "price", scene_file(tool, build, w["scene"]), "--size", w["size"], "--accel",
                w["accel"], "--inside", w["inside"], "--pixels", "0", "--threads", "1", "--json",
                "-"])
    if ran.returncode:
        fail(w["scene"], ran)
    return {"rows": json.loads(ran.stdout)["price"]["rows"]}


def synth_key(w):
    return results.key(w["profile"], w["core"], "ecp5", w["engines"], w["root"], w["quotient"])


def cells(tool, build, w, temporary):
    ran = call(["make", "-s", "-f", "make/area.mk", "results", f"B={build}", "TARGETS=ecp5",
                f"PROFILES={w['profile']}", f"EFFECTS={w['core']}", f"ENGINES={w['engines']}",
                f"ROOT_STEP={w['root']}", f"QUOTIENT_STEP={w['quotient']}"],
               env={k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS")})
    if ran.returncode:
        fail("synthesis", ran)
    run = results.read(f"{build}/synth/{synth_key(w)}")
    return {"core": run["core"], "depth": run["depth"], "yosys": run["yosys"],
            "seconds": run["seconds"]}


def sources(build, w):
    """Patterns of the files that a result depends on, and tools."""
    kind = w["kind"]
    if kind in ("accuracy", "price"):
        return keys.MODEL + keys.scene_files(w["scene"])
    if kind == "cycles":
        return keys.RTL + ["tool:verilator"] + keys.BUILD + keys.scene_files(w["scene"])
    with open(f"{build}/synth/{synth_key(w)}/sources.d", encoding="utf-8") as f:
        return f.readlines()[-1].rstrip(":\n").split() + ["tool:yosys"]


def main(tool, build, folder, key):
    w = keys.words(key)
    if store.look(folder, key)[1] is None:
        return
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="sphaera-study-") as temporary:
        kinds = {"accuracy": accuracy, "cycles": cycles, "cells": cells, "price": price}
        result = kinds[w["kind"]](tool, build, w, temporary)
    store.save(folder, key, sources(build, w), result, time.monotonic() - began)
