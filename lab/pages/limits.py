# limits.py - what limits a run of the RTL, for tables
# SPDX-License-Identifier: Apache-2.0
"""A conclusion about time names the units that the run itself names (docs/use/simulation.md,
"What limits a run"); a table has them by parts() of a pass of report.json."""

LEAST = 0.05  # of the frame: a smaller part is not told


def parts(run):
    """The units that bind, with the percent of the frame's clocks in which they do; `none` for
    those in which none does; a dash if nobody counted."""
    if "units" not in run:
        return "-"
    cycles = run["counters"]["cycles"]
    shares = sorted(((unit["binds"] / cycles, unit["name"]) for unit in run["units"]),
                    reverse=True)
    told = [(share, name) for share, name in shares if share >= LEAST]
    rest = 1 - sum(share for share, _ in shares)
    if rest >= LEAST:
        told.append((rest, "none"))
    return ", ".join(f"{name} {100 * share:.0f} %" for share, name in told)
