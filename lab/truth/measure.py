#!/usr/bin/env python3
# measure.py - draws scenes with POV-Ray, the double reference and the model, and compares
# SPDX-License-Identifier: Apache-2.0
"""Leaves NAME.json and NAME.png in FOLDER for each scene of scenes.py, or for those named; a result
that is younger than the tool is kept. Of surfaces in one place exact numbers are the judge, not
POV-Ray: exact/NAME.json. Says what to install and exits with 1 without POV-Ray."""
import json
import os
import shutil
import subprocess
import sys
import tempfile

from .. import intact
from . import doubt, exact, pictures, scenes

POVRAY = "povray"
RULES = (), ("--unlimited",), ("--unlimited", "--total")  # the machine's rules to POV-Ray's


def stop(text):
    sys.exit(f"truth: {text}")


class Runner:
    def __init__(self, tool, folder):
        self.tool, self.folder = tool, folder
        os.makedirs(folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def sphaera(self, *words):
        """Runs the tool; its exit code, and the last line that it complained with."""
        done = subprocess.run([self.tool, *map(str, words)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, check=False)
        said = done.stderr.strip().splitlines()
        return done.returncode, said[-1] if said else ""

    def must(self, *words):
        code, said = self.sphaera(*words)
        if code:
            stop(f"{words[0]} failed: {said}")

    def povray(self, scene, to, *declared):
        """One picture: EXR of linear light, or PNG of flat colours by the name's ending."""
        width, height = scenes.SIZE
        how = ["+FE"] if to.endswith(".exr") else ["+FN8", "File_Gamma=1.0"]
        words = [POVRAY, f"+I{scene}", f"+O{to}", f"+W{width}", f"+H{height}", "-A", "-D", "-GA",
                 *how, *(f"Declare={name}={value}" for name, value in declared)]
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        if done.returncode or not os.path.exists(to):
            stop(f"{' '.join(words)} failed:\n{done.stdout[-2000:]}")

    def truth(self, name, scene, depth):
        """A surface at the last reflection counts whole where `blend` would lessen it: so the
        picture is that of lessened surfaces to one reflection before, and of whole ones what the
        last reflection adds."""
        pov = self.path(name + ".pov")
        self.must("export", scene, "--depth", depth, "--size", "%dx%d" % scenes.SIZE, "-o", pov)
        last, before, less, flat = (self.path(f"{name}.{part}") for part in
                                    ("last.exr", "before.exr", "less.exr", "ids.png"))
        self.povray(pov, flat, ("Ids", 1))
        self.povray(pov, last, ("Whole", 1), ("Reflections", depth))
        parts = [(1, last)]
        if depth:
            self.povray(pov, before, ("Whole", 1), ("Reflections", depth - 1))
            self.povray(pov, less, ("Reflections", depth - 1))
            parts = [(1, less), (1, last), (-1, before)]
        return pictures.povray(parts, flat, self.path(name + ".ppm"))

    def frame(self, name, *words):
        """The frame that a command of the tool draws; None and why if it is refused."""
        to = self.path(name + ".frame")
        code, said = self.sphaera(*words, *scenes.FILTER, "--size", "%dx%d" % scenes.SIZE,
                                  "--frame", to)
        return (None, said) if code else (pictures.frame(to), "")

    def reference(self, name, scene, depth, *rules):
        """What the double reference draws."""
        return self.frame(name, "reference", scene, "--depth", depth, *rules)[0]

    def doubtful(self, name, scene, depth, still):
        """For each pixel whether it is another if the eye moves by next to nothing."""
        found = [False] * len(still[3])
        for sign in (1, -1):
            to = os.path.join(os.path.dirname(scene), f".{name}.nudged.nff")  # beside its images
            try:
                doubt.nudged(scene, to, sign)
                moved = self.reference(name, to, depth, *RULES[-1])
            finally:
                os.remove(to)
            most = pictures.off(still, moved)
            found = [was or m > pictures.FAR_OFF for was, m in zip(found, most)]
        return found

    def younger(self, target):
        return (os.path.exists(target) and
                os.path.getmtime(target) > os.path.getmtime(self.tool))

    def coincident(self, name, scene):
        """Pixels that show another object than exact numbers do, where doubles can tell."""
        os.makedirs(self.path("exact"), exist_ok=True)
        target, report = self.path(f"exact/{name}.json"), self.path(name + ".report")
        if self.younger(target):
            return
        print(f"  EXACT {name}", flush=True)
        ids, near = exact.see(scene, scenes.SIZE)

        def wrong(frame):
            return sum(a != b and not n for a, b, n in zip(ids, frame[3], near))
        result = {"near": sum(near), "reference": wrong(self.reference(name, scene, 0)),
                  "model": {}}
        for profile in scenes.PROFILES:
            model, why = self.frame(name, "accuracy", scene, "--profile", profile, "--depth", 0,
                                    "--json", report)
            result["model"][profile] = {"refused": why} if model is None else {
                "wrong": wrong(model)}
            if model:
                with open(report, encoding="utf-8") as f:
                    result["undecidable"] = json.load(f)["accuracy"]["undecidable"]
        intact.write(target, json.dumps(result, indent=1))

    def scene(self, name, scene, depth):
        """Measures one scene, unless that is done."""
        target = self.path(name + ".json")
        if self.younger(target):
            return
        print(f"  POV  {name}", flush=True)
        truth = self.truth(name, scene, depth)
        away = pictures.inner(truth)
        ours, unlimited, theirs = (self.reference(name, scene, depth, *rules) for rules in RULES)
        doubtful = self.doubtful(name, scene, depth, theirs)
        result = {"depth": depth, "pixels": len(away), "away": sum(away),
                  "doubtful": sum(doubtful),
                  "reference": pictures.compare(truth, theirs, away),
                  "limited": pictures.compare(truth, ours, away), "model": {}}
        for profile in scenes.PROFILES:
            report = self.path(name + ".report")
            model, why = self.frame(name, "accuracy", scene, "--depth", depth, "--profile", profile,
                                    "--json", report)
            if model is None:
                result["model"][profile] = {"refused": why}
                continue
            far = doubt.beyond(scene, scenes.SIZE, nearest(report))
            causes = pictures.causes(truth, model, {"doubtful": doubtful, "beyond": far},
                                     {"arithmetic": ours, "limit": unlimited, "total": theirs})
            result["model"][profile] = dict(
                pictures.compare(truth, model, away), own=pictures.decibel(ours, model),
                why=pictures.counts(causes), rest=pictures.rest(truth, model, causes))
            if profile == "standard" and model:
                pictures.strip(self.path(name + ".png"), truth, model)
        intact.write(target, json.dumps(result, indent=1))


def nearest(report):
    """How near the eye sees planes beyond the grid of a report's machine; None: nowhere."""
    with open(report, encoding="utf-8") as f:
        cut = json.load(f)["build"].get("planes_cut") or {}
    return cut.get("nearest")


def listed(runner):
    """{name: (path, words that make it, if it is none of the tree)} of every scene."""
    found = {name: (path, ()) for name, path in scenes.named() + scenes.coincident()}
    for kind in scenes.GENERATED:
        name = kind.replace(":", "")
        found[name] = runner.path(name + ".nff"), ("gen", kind)
    if os.path.exists(scenes.PROTEIN):
        found["protein"] = runner.path("protein.nff"), ("import", scenes.PROTEIN)
    return found


def main(tool, folder, *names):
    if not shutil.which(POVRAY):
        stop(f"no {POVRAY} here: `make truth-setup` installs it")
    runner = Runner(tool, folder)
    every = listed(runner)
    unknown = set(names) - set(every)
    if unknown:
        stop(f"no scene {min(unknown)}; there are: {' '.join(every)}")
    for name in names or [name for name in every if every[name][0] not in scenes.BY_NAME]:
        path, words = every[name]
        if words:
            runner.must(*words, "-o", path)
        if (name, path) in scenes.coincident():
            runner.coincident(name, path)
        else:
            runner.scene(name, path, scenes.depth(path))


def scale(tool, folder):
    """FOLDER/scale.txt: scenes of other sizes and places, as tests/tool/test_scale.sh measures."""
    said = os.path.abspath(f"{folder}/scale.txt")
    with tempfile.TemporaryDirectory() as made:
        part = f"{made}/scale.txt"
        subprocess.run(["sh", "tests/tool/test_scale.sh"], check=True, stdout=subprocess.DEVNULL,
                       env=dict(os.environ, TMP=made, SPHAERA=os.path.abspath(tool), SCALE=part))
        shutil.copyfile(part, said)
