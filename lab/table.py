# table.py - what `python3 -m lab` can do: its commands, and the experiments, which make runs too
# SPDX-License-Identifier: Apache-2.0
"""A command is (name, module or module:function of lab, arguments, what it does). Of the arguments
NAME has to be there, [NAME] may be, NAME... are one or more, [NAME...] any number; --name is an
option without a value, --name=VALUE one that has one; ... alone: the
module reads them itself. `python3 -m lab NAME --help` adds what the module says of itself.

An experiment is (name, what it does, steps, files). A step is a module or module:function with
arguments, in which TOOL is the command-line tool and BUILD the folder of all that is built. files:
a module whose tasks(BUILD) are made before (tasks.py); with ENGINE=slurm on a cluster, if it has
OF: a result counts while the files of these patterns are the same. `make NAME` makes the tool and
runs all of it, `python3 -m lab NAME` without the tool, `python3 -m lab NAME STEP` a step."""
from collections import namedtuple

Command = namedtuple("Command", "name run arguments text")
Experiment = namedtuple("Experiment", "name text steps files", defaults=(None,))

EXPERIMENTS = [Experiment(*row) for row in (
    ("background", "ways of background separation compared: docs/results/background.md",
     ["background:synthesised BUILD", "background docs/results/background.md BUILD"], "background"),
    ("textures", "experiments of the texture paper: docs/results/texture_results.md; ten minutes",
     ["textures.page docs/results/texture_results.md docs/results/accuracy.md BUILD/textures "
      "docs/pictures/textures 480x270 160x90 kitchen robot museum"], "textures.runs"),
    ("bart", "the texture paper's own scenes, in the folder BART: docs/results/bart.md; an hour",
     ["bart.runs:tables docs/results/bart.md BUILD"], "bart.runs"),
    ("scenarios", "a BIH on the scenes of its thesis: docs/results/scenarios.md",
     ["scenarios.measure TOOL BUILD/scenarios",
      "scenarios.measure:pictures TOOL BUILD/scenarios docs/pictures/bih",
      "scenarios.page docs/results/scenarios.md BUILD/scenarios"]),
    ("scenarios-rtl", "their frames on the RTL, for the tables of cycles; an hour",
     ["scenarios.measure TOOL BUILD/scenarios --rtl"]),
    ("scenarios-rtl-small", "the small ones of these frames; five minutes",
     ["scenarios.measure TOOL BUILD/scenarios --rtl-small"]),
    ("effects", "cells and time of each effect of each scene: docs/results/effects.md; 50 minutes",
     ["effects.scenes TOOL BUILD/effects BUILD/synth", "effects.scenes:cores BUILD",
      "effects.run:every TOOL BUILD/effects",
      "effects.page docs/results/effects.md BUILD/effects BUILD/synth"]),
    ("moving", "build, refit, upload and draw, frame by frame: docs/results/moving.md",
     ["moving:measure TOOL BUILD/moving", "moving:page docs/results/moving.md BUILD/moving"]),
    ("papers", "the three papers claim by claim: docs/results/claims.md; five minutes",
     ["papers.measure TOOL BUILD/papers", "papers.why TOOL BUILD/papers",
      "papers.pictures BUILD/papers docs/pictures/papers",
      "papers.page docs/results/claims.md BUILD/papers BUILD/synth"]),
    ("trees", "trees beside each other and against a bound: docs/results/trees.md; two minutes",
     ["trees TOOL BUILD/trees docs/results/trees.md"]),
    ("kinds", "kinds of trees beside each other, a kd-tree too: docs/results/trees.md",
     ["trees:kinds TOOL BUILD/trees docs/results/trees.md"]),
    ("summary", "cycles a pixel of scenes at the profile that auto takes: summary.md",
     ["summary:profiles BUILD", "summary BUILD docs/results/summary.md"]),
    ("pipes", "cycles of 1 to 4 traversal pipes: docs/results/pipes.md; half an hour",
     ["rate.pipes BUILD docs/results/pipes.md"]),
    ("pipes-cells", "cells of these cores: docs/results/pipes.md; Yosys, six minutes",
     ["rate.cells BUILD docs/results/pipes.md"]),
    ("board-rate", "clocks of frames of 1280x720, that frames a second follow from: pipes.md",
     ["rate.board BUILD docs/results/pipes.md"]),
    ("shadow-acne", "falsely dark pixels of triangles: docs/design/facet.md; ten minutes",
     ["shadow_acne TOOL BUILD/test/shadow_acne BUILD/shadow_acne docs/design/facet.md"]),
)]

GROUPS = {
    "pages": (
        ("pages", "pages.fill", "--check [PAGE...]",
         "regions of README and docs, from the sources"),
        ("cores", "pages.cores", "--check", "cells of the cores that pages name, if they are old"),
        ("names", "pages.names", "[FILE...]", "names in comments and pages that nothing has"),
        ("typed", "pages.typed", "--everything [PAGE...]", "figures that somebody typed"),
        ("told", "pages.told", "", "MHz and frames a second that a page tells by hand"),
        ("age", "pages.age", "[PAGE...]", "commit and day of each measured table"),
        ("place", "pages.place", "PAGE COMMAND NAME FILE", "puts a measured table into a page"),
        ("commit", "pages.board:commit", "", "commit and day of the sources as they are"),
        ("board-data", "pages.board", "BOARD FOLDER", "cells and clocks of a board's bitstream"),
        ("profiles", "summary:profiles", "BUILD [FILE]", "what auto takes for the scenes of pages"),
        ("bart-page", "bart.page", "PAGE FOLDER SIZE SCENE...", "docs/results/bart.md"),
        ("textures-page", "textures.page", "PAGE ACCURACY FOLDER PICTURES SIZE RTL_SIZE NAME...",
         "docs/results/texture_results.md"),
        ("fuzz-page", "fuzz", "RUNS PAGE", "what make fuzz has run"),
    ),
    "what a run left": (
        ("report", "report.main", "--csv=FILE FOLDER", "report.html of make sim"),
        ("film-report", "report.film", "FOLDER [COMMAND]", "the same of frames on rt_top"),
        ("image-times", "top.frames", "FOLDER", "time to image of those frames"),
        ("gallery", "report.gallery", "FOLDER PAGE", "all scenes on a page"),
        ("browse", "report.browser", "--there [PAGE] [PICTURE] [WIDTH] [HEIGHT] [COLOURS]",
         "a page as Chromium shows it"),
        ("ratios", "bench", "TOOL FOLDER", "one way of the golden model against another"),
        ("speed", "speed", "TOOL FOLDER PAGE [EMBREE]", "the golden model beside others"),
        ("clock", "clocks", "CORE [CLOCKS]", "MHz of a core, or frames a second of so many clocks"),
        ("tree-options", "tree_options", "NAME", "options of sphaera build for a tree"),
    ),
    "jobs": (
        ("jobs", "jobs.run", "ENGINE LIST",
         "runs a list of jobs here (make) or on a cluster (slurm)"),
        ("study-plan", "study.plan", "--short --kinds=KIND,... TOOL BUILD RESULTS LIST",
         "jobs of the study that have no result"),
        ("study-job", "study.run", "TOOL BUILD RESULTS KEY", "one of them"),
        ("study-page", "study.page", "--only-tables PAGE RESULTS FOLDER [TOOL]",
         "what accuracy costs"),
        ("study-times", "study.times", "FOLDER", "... as a plot, in milliseconds"),
        ("seeds", "study.seeds", "CORE FOLDER SPEED-SEED...", "clocks of a core placed with seeds"),
        ("target-plan", "jobs.targets:write", "WHAT BUILD RESULTS LIST PATTERN,... TARGET...",
         "targets of make as jobs"),
        ("target-job", "jobs.targets:one", "BUILD RESULTS KEY PATTERN,...", "one of them"),
    ),
    "synthesis": (
        ("area", "synth.report", "FOLDER KEY...", "tables of synthesised cores"),
        ("area-page", "synth.page", "PAGE FOLDER KEY...", "docs/results/area.md"),
        ("budget", "synth.budget", "FOLDER BUDGET...", "is a core within its budget?"),
        ("clock-budget", "synth.clock_budget", "BUILD BUDGET [BLOCK...]",
         "are blocks, routed alone, as fast as they must be?"),
        ("placed", "synth.placed", "REPORT LOG ROUTED SECONDS VERSION",
         "what nextpnr says, in short"),
        ("slow-paths", "synth.families", "SDF [LINES]", "slow paths of a placed core"),
    ),
    "faults and proofs": (
        ("faults", "faults.__main__", "...", "plants those of tests/faults, tells who notices"),
        ("mutants", "faults.drawn.__main__", "COMMAND BUILD [WORD...]", "faults by Yosys, as jobs"),
        ("mutants-left", "faults.drawn.left", "BUILD [BENCH...]", "what is left, tried again"),
        ("mutants-c", "faults.drawn.model", "BUILD COUNT SEED MINUTES [WORD...]",
         "faults in the C model"),
        ("mutants-c-left", "faults.drawn.left_c", "BUILD SUITE[=FILE]...", "what is left of those"),
        ("equivalents", "faults.drawn.equivalent", "",
         "entries of the lists of equivalent faults that match nothing"),
        ("coverage", "coverage", "BUILD [MODULE...]", "branches and bits that benches meet"),
        ("hard-campaign", "campaign", "COMMAND HARD RESULTS FILE [OPTION...]",
         "hard cases, as jobs"),
        ("hard-page", "hard", "PAGE COMMAND FAMILY PICTURE LIST TABLE...",
         "docs/results/hard_cases.md"),
        ("reset", "reset", "BUILD [MODULE...]", "a clock of reset makes every module quiet"),
    ),
    "checks of sources and blocks": (
        ("layers", "lint_layers", "OBJECT...", "folders of cmodel are layers"),
        ("slang", "lint_slang", "FOLDERS FILE...", "Verilog as SystemVerilog, with pyslang"),
        ("rdl", "top.rdl", "FILE", "registers of rt_top, with systemrdl-compiler"),
        ("cocotb", "top.cocotb_run", "FOLDER MACHINE FRAME DATA NAME=VALUE...", "rt_top in cocotb"),
        ("show-files", "top.show_files", "FOLDER MACHINE FRAME", "a machine for tb_show_icarus"),
        ("litex-board", "litex.ulx3s", "FOLDER NAME=VALUE...", "a LiteX system of a ULX3S"),
        ("litex-sim", "litex.sim", "FOLDER MACHINE NAME=VALUE...",
         "LiteX's simulator as the board"),
        ("litex-check", "litex.check", "LOG MACHINE FRAME", "what it drew"),
        ("notebook", "notebook", "--write FILE", "a notebook's outputs are what is stored"),
        ("povray", "checks.povray", "TOOL FOLDER TABLE", "the reference against POV-Ray's pixels"),
        ("truth-scenes", "truth.measure", "TOOL FOLDER [NAME...]",
         "scenes drawn by POV-Ray and here"),
        ("truth-page", "truth.page", "PAGE FOLDER PICTURES", "docs/results/truth.md"),
        ("truth-grids", "truth.grids", "TOOL FOLDER SCENE...", "the reference on rounded grids"),
        ("truth-points", "truth.points", "FOLDER NAME...", "tests/reference/povray.txt"),
    ),
    "files of the tree that a program writes": (
        ("texture-images", "textures.images", "[FOLDER]", "images of scenes/texture"),
        ("texture-scenes", "textures.scenes", "[FOLDER]", "scenes of scenes/texture"),
        ("asks", "effects.asks", "TOOL", "docs/results/data/asks.tsv: what each scene asks for"),
    ),
}
COMMANDS = {row[0]: Command(*row) for rows in GROUPS.values() for row in rows}
