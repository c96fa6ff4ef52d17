# units.py - how busy each unit of the core was
# SPDX-License-Identifier: Apache-2.0
"""In Verilator the bench counts the clocks in which each unit works, and says what limits a pass
(docs/guide/simulation.md): counted(). Of other runs the counters of the core alone tell something:
least() has the clocks that units need which work by counters (`load` of machine.def). That is about
a lower bound, since a frame has parts that ask for different units."""
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

from ..pages import verilog

sys.path.insert(0, "sim")
import definition   # pylint: disable=wrong-import-position

Unit = namedtuple("Unit", "name clocks what")  # of an engine, or of the one memory port

LINE = 32       # its bytes
TEXELS = 8      # of a textured hit, at most


def said(*words):
    """What sim/cores.py prints."""
    return subprocess.run(["sim/cores.py", *words], check=True, capture_output=True,
                          text=True).stdout


def parameters(key, built, profile="standard"):
    """Parameters of the core: defaults of rt_core.v, the pace of its profile, and what the run was
    given. built: the list of sim/cores.py that it has."""
    found, _ = verilog.header(Path("rtl/core/rt_core.v"), {})
    values = {p.name: int(p.default) for p in found if p.default.isdigit()}
    sizes = said("profile", profile) + said("sizes", key.get("SIZES", ""))
    values.update((name, int(value)) for name, value in
                  (size.split("=") for size in sizes.split()))
    values.update((name, int(key[name])) for name in
                  ("ENGINES", "PIPES", "LEAF_UNITS", "SHADES", "ROOT_STEP", "QUOTIENT_STEP")
                  if key.get(name))
    values.update((name, int(value)) for name, value in
                  (part.split("=") for part in said("parameters", built).split()))
    values["WALKS"] = values["WALKS"] or (1 if values["PIPES"] == 1 else 2)
    for unit, rule in definition.Definition().units.items():
        values[unit] = definition.value(rule, values)
    return values


def lines_of(count, core):
    """Lines that caches asked for."""
    return count["node_misses"] + count["leaf_misses"] \
        + count["texel_misses"] * core["TEXTURE_GROUP"]


def counted(last):
    """Every unit that the core has, the busiest first, of a pass of report.json; none if nobody
    counted them."""
    found, cycles = [], last["counters"]["cycles"]
    for row in last.get("units", []):
        many = row["units"]
        said = f"{row['taken']} results"
        if row["taken"]:
            said += f", {row['clocks'] / row['taken']:.1f} clocks each"
        if cycles and row["turned_away"]:
            said += f", an operand waits in {row['turned_away'] / many / cycles:.1%}"
        found.append(Unit(row["name"], row["clocks"] / many,
                          said + (f"; {many} of them" if many > 1 else "")))
    return found


def units(last, machine, core):
    """counted(), or else least()."""
    return counted(last) or least(last["counters"], machine, core)


def least(count, machine, core):
    """Some units that had work, the busiest first, by what the counters tell. count: counters of
    the core by name; machine: of build.json; core: parameters()."""
    later = count["rays_reflected"] + count["rays_refracted"]
    words = core | machine["widths"] | count | {
        "N_LIGHTS": machine["lights"], "surfaces": count["quotients"],
        "rays": count["rays_primary"] + count["rays_shadow"] + later,
        "textured": count["texels"] // TEXELS}
    words["vectors"] = count["rays_primary"] + later + count["quotients"] * (1 + machine["lights"])
    found, lines = [], lines_of(count, core)
    defined = definition.Definition()
    for name, rule in defined.rates.items():
        words[name] = definition.value(rule, words)
    for name, (many, clocks) in defined.loads.items():
        many, clocks = definition.value(many, words), definition.value(clocks, words)
        if clocks:
            found.append(Unit(name, clocks / core["ENGINES"] / many,
                              f"{many} an engine" if many > 1 else ""))
    if lines:
        beats = 8 * LINE // core["MEM_DATA"]
        found.append(Unit("memory port", lines * beats, f"{lines} lines of {beats} beats"))
    return sorted(found, key=lambda unit: -unit.clocks)
