# summary.py - cycles of scenes at the profile that auto takes: `make summary`
# SPDX-License-Identifier: Apache-2.0
"""A headline figure is told at the profile that `sphaera build` takes by itself, since a narrower
one draws a picture that misses what --error asks for. AUTO says which that is for each scene that a
page draws, and what was measured of profile standard; the region `misses` of a page tells of those
scenes whose figures it has at standard."""
import json
import tempfile
from pathlib import Path

from . import intact
from .pages import data
from .pages.place import place
from .runner import said, scene_file
from .synth import report

SIZE = "320x180"
# table `speed`: scene, size
RUNS = [("sphereflake2", SIZE), ("sphereflake2", "1280x720"), ("sphereflake:3", SIZE),
        ("sphereflake:4", SIZE), ("paper100", SIZE), ("random:256", SIZE), ("random:4096", SIZE),
        ("protein", SIZE), ("interpenetrating", SIZE), ("paper5", "1280x720"), ("inside", SIZE)]
SCENES = ["sphereflake2", "sphereflake:3", "sphereflake:4", "paper100", "random:256",
          "random:4096", "protein", "interpenetrating", "huge_tiny", "paper5", "inside",
          "facets/room", "refraction/nested", "texture/hall", "texture/kitchen", "texture/museum",
          "texture/robot"]
AUTO = "profiles"
ENOUGH = 45  # dB, what --error asks for by itself


def drawn(build, path, profile, folder):
    """The profile of a scene's picture and its dB."""
    said(f"{build}/sphaera", "accuracy", path, "--profile", profile, "--size", SIZE, "--depth", 2,
         "--json", f"{folder}/x.json")
    found = json.loads(Path(folder, "x.json").read_text("utf-8"))
    return found["machine"]["profile"], f"{found['accuracy']['psnr'][-1]:.1f}"


def auto(build):
    """Lines of AUTO: the profile that build takes, dB of its picture and of that of standard."""
    rows = []
    for scene in SCENES:
        with tempfile.TemporaryDirectory(prefix="sphaera-summary-") as folder:
            path = scene_file(f"{build}/sphaera", scene, f"{folder}/scene.nff")
            taken, psnr = drawn(build, path, "auto", folder)
            of_standard = psnr if taken == "standard" else drawn(build, path, "standard", folder)[1]
        rows.append([f"`{scene}`", taken, psnr, of_standard])
    return data.of_rows([["scene", "auto takes", "dB", "dB of standard"], *rows])


def speed(build):
    """From cold caches, one core of the host, so that the frame is one piece."""
    rows = []
    with tempfile.TemporaryDirectory(prefix="sphaera-summary-") as folder:
        for scene, size in RUNS:
            path = scene if scene != "protein" else \
                scene_file(f"{build}/sphaera", scene, f"{folder}/scene.nff")
            words = [f"SCENE={path}", f"SIZE={size}", "PROFILE=auto", "LATENCY=100",
                     "BACKGROUND=rect", "JOBS=1", f"B={build}"]
            said("make", "--no-print-directory", "sim", *words)
            at = Path(said("make", "-s", "--no-print-directory", "sim-folder", *words).strip())
            drawn, built = (json.loads((at / f"{name}.json").read_text("utf-8"))
                            for name in ("report", "build"))
            cold = drawn["cold"]
            rows.append([f"`{scene}`" + (f", {size}" if size != SIZE else ""),
                         built["machine"]["spheres"], drawn["profile"],
                         f"{cold['cycles_per_pixel']:.2f}", f"{cold['cycles_per_visit']:.2f}",
                         f"{100 * cold['issue_port_busy']:.1f} %"])
            print("  RUN ", *rows[-1], flush=True)
    return report.table(["`SCENE`", "spheres", "profile", "cycles a pixel", "cycles a visit",
                         "issue port busy"], rows)


def misses(*scenes):
    """For a page: of which scenes standard misses what auto holds to."""
    head, rows = data.read(AUTO)
    known = {row[0].strip("`"): dict(zip(head, row)) for row in rows}
    missed = [known[scene] for scene in scenes
              if float(known[scene]["dB of standard"]) < ENOUGH]
    if not missed:
        return f"Profile standard is what `auto` takes for all of them, {ENOUGH} dB."
    told = ", ".join(f"{row['scene']} ({row['dB of standard']})" for row in missed)
    return (f"At standard, which misses the {ENOUGH} dB that `--profile auto` holds to for these: "
            f"{told} dB measured.")


def profiles(build, name=data.FOLDER / f"{AUTO}.tsv"):
    """The table AUTO, or into another file."""
    intact.write(name, auto(build))


def main(build, page):
    place(page, "make summary", {"speed": lambda: speed(build)})
