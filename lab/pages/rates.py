# rates.py - frames a second of the pages, from measured clocks a pixel and the clocks of cores
# SPDX-License-Identifier: Apache-2.0
"""A table of a page has clocks that were measured; the rates that follow stand in the region
`rates NAME`, of RATES, and in words within a line. So a core that is routed anew changes them all,
and a rate of a core that nobody routed says so. Nothing else of a page tells MHz or frames a
second: told.py looks for them."""
from typing import Callable, NamedTuple

from .. import clocks, known
from . import data, markdown

BART = "shadow+reflect2+lights6+facets+smooth+clear+turned+texture+boxes"
BART_SIZES = "slots=128,node_lines=1024,leaf_lines=1024"
TEXTURED = "shadow+reflect2+lights2+inside+facets+texture+spread+turned+boxes"
# of these the one that is routed: one pipe, fewer units; before it is, one with two units for keys
BART_NEAREST = clocks.key("standard", BART.replace("+lights6", ""),
                          SIZES="texture_coords=1," + BART_SIZES)
if clocks.clock(BART_NEAREST) is None:
    BART_NEAREST = BART_NEAREST.replace("-texture_coords", "-divisions2-texture_coords")
SPHERES = "shadow+reflect2+lights3+inside"
PIPES = SPHERES + "+spans"
THESIS = "lights1+facets"
TOP = clocks.key("standard", "shadow+reflect2+lights1") + "-top"
PARK_MHZ = 84  # the clock of Park et al. 2011


def bart_core(row):
    """A scene's frames have the profile of its middle one."""
    head, found = data.read("texture_results.bart_frames")
    profile = next(r[head.index("profile")] for r in found if r[0] == row["scene"])
    return clocks.key(profile, BART, SIZES=BART_SIZES, PIPES=row["pipes"])


def moving_core(row):
    """Frames without shadows and mirrors; 100 000 spheres take profile fine."""
    profile = "fine" if row["scenario, spheres"].endswith(" 100000") else "standard"
    return clocks.key(profile, THESIS + ("+bih" if row["tree"] == "BIH" else ""))


class Rate(NamedTuple):
    """How a table's clocks become rates."""
    table: str                    # as data.read() takes it
    left: list                    # its columns that stand in front
    clocks: str                   # its column of clocks a pixel, or of million clocks a frame
    size: str                     # of the frame
    core: Callable                # the key of a row's core
    columns: list                 # of COLUMNS, in their order
    right: tuple = ()             # its columns that stand behind


def pixels(size):
    width, height = size.split("x")
    return int(width) * int(height)


def _frames(row, rate):
    return clocks.frames(rate.core(row), float(row[rate.clocks]) * pixels(rate.size), "{:.2f}")


def _paper_clock(row, rate):
    """At the clock of Park et al., to compare clock for clock."""
    return f"{PARK_MHZ * 1e6 / float(row[rate.clocks]) / pixels(rate.size):.2f}"


def _alternating(build):
    """Frames a second where the next machine is built and written while one is drawn."""
    def of(row, rate):
        found = clocks.clock(rate.core(row))
        if not found:
            return clocks.NOT
        upload, draw = (float(row[name]) / found.mhz for name in
                        ("upload, million clocks", rate.clocks))
        return f"{1 / max(1e-3 * float(row[build]) + upload, draw):.1f}"
    return of


def _even(build):
    """The clock at which building and writing take as long as drawing."""
    def of(row, rate):
        more = float(row[rate.clocks]) - float(row["upload, million clocks"])
        return f"{1e3 * more / float(row[build]):.0f}"
    return of


def _rays(row, rate):
    found = clocks.clock(rate.core(row))
    return f"{found.mhz * float(row['rays a pixel']) / float(row[rate.clocks]):.1f}" if found \
        else clocks.NOT


def _cells(row):
    """LUT4eq and MULT of a row's core, as it was last synthesised."""
    return known.cells().get((row["profile"], row["core"], 1), "--")


def _energy(row, rate):
    """nJ a pixel by the fit of silicon.md, with a ~."""
    wanted = [row["scene"], rate.size, row["core"], row.get("profile", "standard")]
    return next((cell for *of, cell in data.read("silicon.pixels")[1]
                 if [word.strip("`") for word in of] == wanted), "-")


COLUMNS = {
    "MHz": lambda row, rate: clocks.mhz(rate.core(row)),
    "MHz, worst to best": lambda row, rate: clocks.spread(rate.core(row)),
    "nJ a pixel": _energy,
    "LUT4eq": lambda row, rate: _cells(row)[0],
    "MULT": lambda row, rate: _cells(row)[1],
    "frames/s": _frames,
    "ms a frame": lambda row, rate: clocks.milliseconds(
        rate.core(row), float(row[rate.clocks]) * pixels(rate.size)),
    f"at the paper's {PARK_MHZ} MHz": _paper_clock,
    "million rays/s": _rays,
    "MHz for 30 frames/s": lambda row, rate:
        f"{30e-6 * float(row[rate.clocks]) * pixels(rate.size):.0f}",
    "frames/s, built": _alternating("build, ms"),
    "frames/s by the rule": _alternating("build by the rule, ms"),
    "even at, MHz, built": _even("build, ms"),
    "even at, by the rule": _even("build by the rule, ms"),
}
OURS, CLOCK_FOR_CLOCK = ["MHz", "frames/s"], f"at the paper's {PARK_MHZ} MHz"
RATES = {
    "kinds": Rate("accuracy.kinds", ["what", "scene", "profile", "dB", "cycles a pixel"],
                  "cycles a pixel", "320x180",
                  lambda row: clocks.key(row["profile"], row["core"]),
                  ["ms a frame", "MHz, worst to best", "nJ a pixel", "LUT4eq", "MULT"]),
    "effects": Rate("effects.costs", ["scene", "LUT4eq of all", "FF of all", "MULT",
                                      "cycles of all", "model of all", "time"], "cycles", "160x90",
                    lambda row: clocks.key("standard", row["core"]), ["nJ a pixel"]),
    "bart": Rate("texture_results.bart_clocks", ["scene", "pipes", "clocks a pixel"],
                 "clocks a pixel", "800x480", bart_core, [*OURS, CLOCK_FOR_CLOCK],
                 ("the paper's",)),
    "textures": Rate("texture_results.speed", ["scene", "filter", "a pixel"], "a pixel", "800x480",
                     lambda row: clocks.key("standard", TEXTURED), [*OURS, CLOCK_FOR_CLOCK],
                     ("the paper's",)),
    "pipes": Rate("speed_and_area.pipes_rate", ["scene", "pipes", "clocks a pixel"],
                  "clocks a pixel", "1280x720",
                  lambda row: clocks.key("standard", PIPES, PIPES=row["pipes"]),
                  [*OURS, "million rays/s", "MHz for 30 frames/s"]),
    "scenarios": Rate("trees.bih_full", ["scenario, spheres", "tree", "pipes", "cycles a pixel"],
                      "cycles a pixel", "640x1088",
                      lambda row: clocks.key("standard", THESIS + "+bih", PIPES=row["pipes"]),
                      OURS),
    "moving": Rate("trees.moving", ["scenario, spheres", "tree", "build, ms", "refit, ms",
                                    "upload, million clocks", "draw, million clocks",
                                    "more refitted, %"],
                   "draw, million clocks", "640x1088", moving_core,
                   ["MHz", "frames/s, built", "frames/s by the rule", "even at, MHz, built",
                    "even at, by the rule"]),
    "swarm": Rate("trees.swarm", ["who", "tree", "how", "clocks a pixel"], "clocks a pixel",
                  "1280x720", lambda row: TOP, OURS),
}


def _plain(head, row):
    return dict(zip(head, (cell.strip("`") for cell in row)))


def rows(name, found=None):
    """The rows of the table, or those found, each with its rates: column: cell."""
    rate = RATES[name]
    head, all_rows = data.read(rate.table)
    for cells in all_rows if found is None else found:
        row = dict(zip(head, (cell.strip("`") for cell in cells)))
        yield dict(zip(head, cells)) | {c: COLUMNS[c](row, rate) for c in rate.columns}


def column(name, wanted, **where):
    """One column of the rows whose columns are as given."""
    return [row[wanted] for row in rows(name) if all(row[c] == x for c, x in where.items())]


def table(name):
    """The rows that shown.txt chooses of the table, with their rates."""
    rate = RATES[name]
    head = [*rate.left, *rate.columns, *rate.right]
    return markdown.table(head, [[row[c] for c in head]
                                 for row in rows(name, data.chosen(rate.table)[1])])


def against(pipes):
    """What each of BART's scenes draws with so many pipes at the clock of BART_NEAREST, in words,
    and the paper beside it."""
    told, faster = [], []
    for row in rows("bart"):
        if row["pipes"] != pipes:
            continue
        ours = _frames(row, RATES["bart"]._replace(core=lambda _: BART_NEAREST))
        theirs = row["the paper's"]
        told.append(f"{row['scene']} {ours} ({theirs})")
        faster += [row["scene"]] if float(ours) > float(theirs) else []
    verdict = {0: "in none of them faster", len(told): "in all of them faster"}
    return (f"{', '.join(told)} frames a second, the paper's in brackets; "
            + verdict.get(len(faster), f"in {' and '.join(faster)} alone faster"))


def clocks_of(*arguments):
    """Clocks of a frame: a number, or `SIZE; TABLE; ROW; COLUMN` with clocks a pixel."""
    if len(arguments) == 1:
        return float(arguments[0])
    size, *place = " ".join(arguments).split("; ")
    return pixels(size) * float(data.cell("; ".join(place)).split()[0])


def frames(core, *arguments):
    """Frames a second in words."""
    return clocks.frames(core, clocks_of(*arguments))


def milliseconds(core, *arguments):
    """Milliseconds of a frame, in words."""
    return clocks.milliseconds(core, clocks_of(*arguments), "{:.1f}")


def nearest():
    """MHz of BART_NEAREST."""
    return clocks.mhz(BART_NEAREST)


def routed():
    """The table of clocks, without what repeats it."""
    wanted = ["core", "speed grade", "after", "seeds", "worst, MHz", "median, MHz", "best, MHz",
              "commit"]
    head, found = data.read(clocks.TABLE)
    return markdown.table(wanted, [[row[head.index(c)] for c in wanted] for row in found])
