# seeds.py - the clocks of a core that was placed with several seeds
# SPDX-License-Identifier: Apache-2.0
"""FOLDER/SPEED-SEED has the placed.json of synth/place.sh, NETLIST what synth/core.sh left.
Writes the rows of the core into the table of lab/clocks.py, one for each speed grade. Rows of other
cores, and of other speed grades of this one, stay."""
import json
import re
from pathlib import Path

from .. import clocks, intact
from ..pages import data, measured


def rows(core, netlist, folder, seeds):
    """Rows of the table; seeds of which some were routed and some not, count apart."""
    yosys = re.search(r"Yosys [\w.]+", Path(netlist, "stat.json").read_text("utf-8"))[0]
    found = {}
    for seed in seeds:
        placed = json.loads(Path(folder, seed, "placed.json").read_text(encoding="utf-8"))
        found.setdefault((seed.split("-")[0], placed["routed"]), {})[seed] = placed
    for (speed, routed), some in found.items():
        command = (f"make study-seeds ROUTE={routed} SEEDS_CORE={core} "
                   f"SEEDS='{' '.join(some)}'")
        yield clocks.row_of(core, speed, list(some.values()), yosys, command, measured.commit())


def main(core, netlist, folder, *seeds):
    made = list(rows(core, netlist, folder, seeds))
    new = {tuple(row[:4]) for row in made}
    head, before = data.read(clocks.TABLE)
    table = made + [row for row in before if tuple(row[:4]) not in new]
    intact.write(data.FOLDER / f"{clocks.TABLE}.tsv", data.of_rows([head] + sorted(table)))
