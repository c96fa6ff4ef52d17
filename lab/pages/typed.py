# typed.py - figures that somebody typed into README and the results pages
# SPDX-License-Identifier: Apache-2.0
"""usage: python3 -m lab.pages.typed [--list] [PAGE...]
A figure is a number with a unit of what is measured: MHz, cycles, LUT4eq, dB, ms, %... In prose it
is a region of the page (data.py: `cell`), so that it follows its table, or a line of ALLOWED, which
says why it stands there by hand: `PAGE: FIGURE: reason`, a star for any page or figure. Code,
tables, regions and addresses do not count. Prints each figure that neither is, or --list all of
them, and exits with 1 if there is one; so with a line of ALLOWED that no figure needs."""
import re
import sys
from pathlib import Path

ALLOWED = Path("lab/pages/typed.txt")
UNITS = (r"MHz|kHz|GHz|MULT18X18D|LUT4eq|LUTs?|LUT4|FFs?|flip-flops|DP16KD|DPR16X4|multipliers|"
         r"cycles|clocks|dB|decibels?|ms|milliseconds|ns|µs|us|seconds|minutes|hours|"
         r"frames(?: a second|/s)?|bytes|KB|MB|GB|pixels|visits|rays|tests|times|faults|mismatches|"
         r"%|percent")
FIGURE = re.compile(rf"(?<![\w.,/:-])[-+~]?(\d+(?: \d{{3}})*(?:\.\d+)?(?:[eE^]\d+)?)(?: ({UNITS})\b| ?(%)|"
                    rf"-(fold|bit)\b)")
LEFT_OUT = (
    re.compile(r"^```.*?^```", re.S | re.M),                    # code, drawings
    re.compile(r"<!-- begin: .*?<!-- end -->", re.S),           # generated
    re.compile(r"<!-- [a-z0-9_]+ -->.*?<!-- end -->", re.S),    # measured tables
    re.compile(r"<!--.*?-->", re.S),
    re.compile(r"^ *\|.*$", re.M),                              # tables
    re.compile(r"(?:(?<=\n\n)|\A)(?: {4}.*\n)+(?=\n|\Z)"),      # commands, listings
    re.compile(r"`[^`\n]*`"),
    re.compile(r"!?(?<=\])\([^)]*\)"),                          # addresses of links
)
