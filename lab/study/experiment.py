# experiment.py - make study, study-page, study-seeds, study-paths and study-estimate
# SPDX-License-Identifier: Apache-2.0
"""A sweep (sweep/run.py says where its results lie, and what runs it), whose points points.py has.
KINDS are those of its measures that are run, accuracy, cycles, cells and price (all).
Clocks are those of SEEDS_CORE placed with SEEDS, SPEED-SEED each, and routed if ROUTE is 1, by the
nextpnr-ecp5 of the PATH, or of BUILD/study/pnr, which is installed where there is none: the native
one of Debian 13 if that can be, else a pinned one of PyPI (NATIVE=0: in any case; synth/pnr.sh)."""
import os
import shutil
import subprocess
import sys

from .. import tasks
from ..sweep import axes, run
from ..pages import fill
from ..synth import families
from . import page, points, seeds, times


def chosen(short=False, measures=None):
    """Keys of the jobs."""
    wanted = (measures or os.environ.get("KINDS") or ",".join(axes.SHAPES)).split(",")
    if set(wanted) - set(axes.SHAPES):
        sys.exit(f"study: {','.join(wanted)}: kinds are {', '.join(axes.SHAPES)}")
    return [key for key in (points.short() if short else points.plan())
            if axes.words(key)["measure"] in wanted]


def plan(tool, build, results, name, short=False, measures=None):
    run.write(name, tool, build, results, chosen(short, measures), "study")


def jobs(tool, build, short=False):
    """Every job that has no result that counts. Returns how `lab jobs` ended."""
    return run.run(tool, build, chosen(short), "study")


def pages(tool, build, name):
    """From the results that are there; tables of which one is missing stay as they are."""
    page.main(name, run.folder(build), f"{build}/study", tool)
    times.main(f"{build}/study")


def study(tool, build, name):
    ended = jobs(tool, build)
    pages(tool, build, name)
    sys.exit(ended)


def short(tool, build):
    sys.exit(jobs(tool, build, True))


# ---- clocks ----
def install(build):
    """synth/pnr.sh, unless it was run."""
    folder = f"{build}/study/pnr"
    if not os.path.exists(f"{folder}/nextpnr-ecp5"):
        subprocess.run(["sh", "synth/pnr.sh", folder], check=True)


def there(build):
    """A nextpnr-ecp5, installed where the PATH has none."""
    if not shutil.which("nextpnr-ecp5"):
        install(build)


def synthesised(build):
    """SEEDS_CORE and the folder of its netlist."""
    core = os.environ.get("SEEDS_CORE") or sys.exit("SEEDS_CORE is not set: make study-seeds")
    folder = f"{build}/synth/{core}"
    subprocess.run(["make", "-s", "-f", "make/area.mk", f"B={build}", f"{folder}/stat.json"],
                   check=True, env=tasks.clean())
    return core, folder


def placed(build, count=None, **environment):
    """SEEDS_CORE placed with the first of SEEDS: (core, folders of its netlist and of the seeds,
    these seeds)."""
    chosen = (os.environ.get("SEEDS") or sys.exit("SEEDS is not set: make study-seeds")).split()
    chosen = chosen[:count]
    there(build)
    core, netlist = synthesised(build)
    folder = f"{build}/study/seeds/{core}"
    for word in chosen:
        speed, _, seed = word.partition("-")
        os.makedirs(f"{folder}/{word}", exist_ok=True)
        subprocess.run(["sh", "synth/place.sh", netlist, f"{folder}/{word}"], check=True,
                       env=dict(os.environ, BUILD=build, SEED=seed, SPEED=speed, **environment))
    return core, netlist, folder, chosen


def clocks(build):
    core, netlist, folder, chosen = placed(build)
    seeds.main(core, netlist, folder, *chosen)
    times.main(f"{build}/study")
    return fill.main()


def paths(build):
    *_, folder, chosen = placed(build, 1, SDF="1")
    families.main(f"{folder}/{chosen[0]}/delays.sdf")


def estimate(build):
    """Slow paths of SEEDS_CORE by what its wires are expected to take, without nextpnr."""
    _, folder = synthesised(build)
    flat = f"{folder}/flat.json"
    subprocess.run(["yosys", "-q", "-p", f"read_rtlil {folder}/netlist.il; flatten; "
                    f"opt_clean -purge; write_json {flat}"], check=True)
    families.main(flat)
