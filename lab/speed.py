# speed.py - the golden model beside Embree and POV-Ray, and how it grows: `make bench`
# SPDX-License-Identifier: Apache-2.0
"""EMBREE: sim/embree.c, compiled; without it, or without POV-Ray, tables that have them are shown
on the terminal alone. All that is compared runs in turn in one call, with one thread; times are
those of the processor, so that other programs disturb them little. SIZES of the environment:
spheres of the growth, such as "100 1000", whose table is then shown alone; TABLES: those to make,
of "rays frames growth"."""
import json
import os
import re
import shutil
import statistics
import subprocess
import sys
from functools import partial

from .pages import whole
from .pages.place import place
from .synth.report import table

FRAME = "640x360"
ROUNDS = 5
SCENES = ["random:256", "random:4096", "random:100000", "sphereflake:3"]
FACETS = [("kitchen", ()), ("kitchen, bih", ("--accel", "bih"))]  # scenes of triangles
SIZES = "100 1000 10000 100000 1000000 10000000"
STANDARD = 1000000  # more spheres have profile fine: the grid of standard merges some of them
MEMORY = "16G"
NO_EMBREE = "no Embree: make bench-setup"
CHART = """set terminal svg noenhanced size 900,480 font "sans,13" background "white"
set output "{out}"
set title "Random spheres, processor time"
set logscale xy
set xlabel "spheres"
set ylabel "seconds"
set grid lc rgb "#cccccc"
set key left top
set datafile missing "-"
plot {lines}
"""
LINES = {"tree, s": ("tree and memory image", 1), "frame, ms": ("frame of 640x360", 1e-3),
         "Embree builds, s": ("Embree's tree", 1)}
PICTURE = "docs/pictures/growth.svg"


def run(*command):
    """Its standard output, and the most memory that it had, MB."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          env=dict(os.environ, SPHAERA_MEMORY=MEMORY)) as process:
        said = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"speed: {' '.join(command)} failed")
    return said, usage.ru_maxrss / 1024


class Bench:
    def __init__(self, tool, folder, embree):
        self.tool, self.folder, self.embree = tool, folder, embree
        os.makedirs(folder, exist_ok=True)

    def facets(self, name, words):
        """Machine file of a scene of triangles."""
        machine = os.path.join(self.folder, name.replace(", ", ".") + ".sph")
        run(self.tool, "build", f"scenes/texture/{name.split(',')[0]}.nff", "--profile", "standard",
            "--depth", "0", "--size", FRAME, *words, "-o", machine)
        return machine

    def machine(self, kind, profile="standard"):
        """Scene file, machine file, report and memory of build."""
        stem = os.path.join(self.folder, kind.replace(":", ""))
        run(self.tool, "gen", kind, "--resolution", FRAME, "-o", stem + ".nff")
        said, memory = run(self.tool, "build", stem + ".nff", "--profile", profile, "--depth", "0",
                           "-o", stem + ".sph", "--json", "-")
        return stem + ".nff", stem + ".sph", json.loads(said), memory

    def rays(self, machine):
        return json.loads(run(self.embree, machine, str(ROUNDS))[0])

    def frame(self, machine, *words):
        """Seconds of processor of a frame, one thread."""
        said, _ = run(self.tool, "render", machine, "-t", "1", *words, "--json", "-")
        return json.loads(said)["cpu_seconds"]

    def povray(self, scene):
        """Seconds of processor that POV-Ray says it traced, one thread."""
        to = scene[:-4] + ".pov"
        run(self.tool, "export", scene, "--depth", "0", "-o", to)
        width, height = FRAME.split("x")
        done = subprocess.run(["povray", f"+I{to}", f"+O{to[:-4]}.png", f"+W{width}", f"+H{height}",
                               "-A", "-D", "+WT1"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        found = re.search(r"Trace Time:[^:]*?with ([\d.]+) CPU-seconds", done.stdout)
        if done.returncode or not found:
            sys.exit(f"speed: POV-Ray failed on {to}:\n{done.stdout[-1000:]}")
        return float(found[1])


def ratio(ours, other):
    """Median of how many times as fast, and its spread, of runs that were made in turn."""
    each = sorted(b / a for a, b in zip(ours, other))
    return f"{statistics.median(each):.2f} ({each[0]:.2f}..{each[-1]:.2f})"


def beside_embree(bench):
    if not bench.embree:
        return whole.lack(NO_EMBREE)
    rows = []
    for kind in SCENES:
        _, machine, _, _ = bench.machine(kind)
        found = bench.rays(machine)
        for of in "primary", "shadow":
            r = found[of]
            rows.append([kind, of, r["rays"], f"{min(r['embree']) / r['rays'] * 1e9:.0f}",
                         *(ratio(r[way], r["embree"]) for way in ("literal", "fast", "packet")),
                         f"{100 * r['same'] / r['rays']:.4f}"])
    return table(["scene", "rays", "number", "Embree, ns", "literal", "fast",
                  "packets", "same, %"], rows, 2)


def frames(bench):
    """Whole frames, shading too; POV-Ray reads its file only once."""
    rows, povray = [], shutil.which("povray") or whole.lack("no POV-Ray: make truth-setup")
    for kind in SCENES:
        scene, machine, _, _ = bench.machine(kind)
        literal, fast, packets, other = [], [], [], []
        for _ in range(ROUNDS):
            literal.append(bench.frame(machine, "--literal"))
            fast.append(bench.frame(machine))
            packets.append(bench.frame(machine, "--packets"))
            if povray and len(other) < 2:
                other.append(bench.povray(scene))
        rows.append([kind, f"{min(fast) * 1e3:.0f}", ratio(fast, literal), ratio(packets, fast),
                     f"{min(other) / min(fast):.2f}" if other else "-"])
    for name, words in FACETS:
        machine = bench.facets(name, words)
        literal, fast = [], []
        for _ in range(ROUNDS):
            literal.append(bench.frame(machine, "--literal"))
            fast.append(bench.frame(machine))
        rows.append([name, f"{min(fast) * 1e3:.0f}", ratio(fast, literal), "-", "-"])
    return table(["scene", "fast, ms", "literal / fast", "fast / packets", "POV-Ray / fast"], rows)


def growth(bench):
    rows, sizes = [], os.environ.get("SIZES", SIZES)
    if sizes != SIZES:
        whole.lack(f"sizes {sizes} alone")
    if not bench.embree:
        whole.lack(NO_EMBREE)
    for size in sizes.split():
        profile = "standard" if int(size) <= STANDARD else "fine"
        _, machine, report, memory = bench.machine(f"random:{size}", profile)
        took = [bench.frame(machine) for _ in range(3)]
        row = [size, f"{report['build']['tree_seconds']:.2f}", f"{memory:.0f}",
               f"{min(took) * 1e3:.0f}"]
        if bench.embree:
            found = bench.rays(machine)
            row += [f"{found['embree_build']:.2f}",
                    *(ratio(found[of]["fast"], found[of]["embree"]) for of in
                      ("primary", "shadow"))]
        rows.append(row)
    head = ["spheres", "tree, s", "MB", "frame, ms"]
    return table(head + (["Embree builds, s", "primary", "shadow"] if bench.embree else []), rows)


def chart(text, picture):
    """The columns of a growth table that are seconds; 0.00 has no place on the axis."""
    head, _, *rows = [[c.strip() for c in line.strip()[1:-1].split("|")]
                      for line in text.strip().splitlines()]
    data, lines = "", []
    for n, (name, (title, unit)) in enumerate((k, v) for k, v in LINES.items() if k in head):
        data += f"$d{n} << end\n"
        for row in rows:
            value = float(row[head.index(name)]) * unit
            data += f"{row[0]} {value:.6f}\n" if value > 0 else ""
        data += "end\n"
        lines.append(f'$d{n} using 1:2 with linespoints pt 7 lw 2 title "{title}"')
    subprocess.run(["gnuplot"], input=data + CHART.format(out=picture, lines=", ".join(lines)),
                   text=True, check=True)


def main(tool, folder, page, embree=None):
    bench, texts = Bench(tool, folder, embree), {}
    wanted = os.environ.get("TABLES", "rays frames growth").split()

    def kept(name, table):
        texts[name] = table(bench)
        print(f"{name}:\n{texts[name]}\n", flush=True)
        return texts[name]
    tables = {"rays": beside_embree, "frames": frames, "growth": growth}
    put = place(page, "make bench", {name: partial(kept, name, table)
                                     for name, table in tables.items() if name in wanted})
    if "growth" in put:
        chart(texts["growth"], PICTURE)
