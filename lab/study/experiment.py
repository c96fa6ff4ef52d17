# experiment.py - make study, study-page, study-seeds, study-paths and study-estimate
# SPDX-License-Identifier: Apache-2.0
"""RESULTS is the folder of results (BUILD/study/results): put those of several machines together.
KINDS are kinds of jobs, accuracy, cycles, cells and price (all), ENGINE and JOBS what runs them
(docs/guide/simulation.md). points.py says which runs these are, jobs/store.py how a result is kept.
Clocks are those of SEEDS_CORE placed with SEEDS, SPEED-SEED each, and routed if ROUTE is 1, by the
nextpnr-ecp5 of the PATH, or of BUILD/study/pnr, which is installed where there is none: the native
one of Debian 13 if that can be, else a pinned one of PyPI (NATIVE=0: in any case; synth/pnr.sh)."""
import os
import shutil
import subprocess
import sys

from .. import tasks
from ..pages import fill
from ..synth import families
from . import keys, page, plan, seeds, times

def results(build):
    return os.environ.get("RESULTS") or f"{build}/study/results"


def jobs(tool, build, short=False):
    """Every job that has no result that counts. Returns how `lab jobs` ended."""
    listed = f"{build}/study/jobs"
    plan.main(tool, build, results(build), listed, short,
              os.environ.get("KINDS") or ",".join(keys.FIELDS))
    count = os.environ.get("JOBS") or "1"
    environment = {k: v for k, v in os.environ.items() if k != "MFLAGS"}
    environment["MAKEFLAGS"] = f"-j{count}"
    return subprocess.run([sys.executable, "-m", "lab", "jobs", os.environ.get("ENGINE") or "make",
                           listed], check=False, env=environment).returncode


def pages(tool, build, name):
    """From the results that are there; tables of which one is missing stay as they are."""
    page.main(name, results(build), f"{build}/study", tool)
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
