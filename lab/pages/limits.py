# limits.py - what limits a run of the RTL, for tables
# SPDX-License-Identifier: Apache-2.0
"""A conclusion about time names the units that the run itself names (docs/guide/simulation.md,
"What limits a run"); a table has them by parts() of a pass of report.json."""

LEAST = 0.05  # of the frame: a smaller part is not told
# units that a token goes through one after the other at the same pace: which of them is busiest, is
# a matter of a clock here and there
TOGETHER = {"node cache": "visits", "node visits": "visits", "next nodes": "visits",
            "records to tests": "exact tests", "exact tests of spheres": "exact tests",
            "exact tests of facets": "exact tests"}


def parts(run):
    """The units that bind, with the percent of the frame's clocks in which they do; `none` for
    those in which none does; a dash if nobody counted."""
    if "units" not in run:
        return "-"
    shares, cycles = {}, run["counters"]["cycles"]
    for unit in run["units"]:
        name = TOGETHER.get(unit["name"], unit["name"])
        shares[name] = shares.get(name, 0) + unit["binds"] / cycles
    shares["none"] = 1 - sum(shares.values())
    told = sorted(((share, name) for name, share in shares.items() if share >= LEAST),
                  key=lambda part: (part[1] == "none", -part[0]))
    return ", ".join(f"{name} {100 * share:.0f} %" for share, name in told)
