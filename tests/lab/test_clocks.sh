#!/bin/sh
# test_clocks.sh - MHz and frames a second: of that very core, from the one table of clocks, or none
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

check "no page tells MHz or frames a second by hand" python3 -m lab told
check "the plot of times is of these clocks: python3 -m lab study-times FOLDER" python3 -c "
from pathlib import Path
from lab.study import times
drawn = Path(times.PICTURE).read_text(encoding='utf-8')
missing = [name for _, dots in times.series()[0] for *_, name in dots if f'>{name}<' not in drawn]
assert not missing, missing"

# faults in a copy of the tree
cp -r cmodel docs formal lab make rtl scenes sim synth tb Makefile VERSION README.md \
    CONTRIBUTING.md "$TMP"
cd "$TMP" || exit 1
given=docs/results/data/given.txt claims=lab/papers/claims.py
told() { # command, file, sed expression, what is said
    command=$1 file=$2
    cp "$file" kept
    sed -i "$3" "$file" && ! cmp -s kept "$file" &&
        ! python3 -m lab $command >said 2>&1 && cat said && grep -q -- "$4" said
    rc=$?
    cp kept "$file"
    return $rc
}
check "a clock that is typed" told told README.md '$s/$/\nIt reaches 127 MHz./' \
    'README.md:[0-9]*: 127 MHz is told by hand'
check "a rate that is typed, over two lines" told told docs/results/texture_results.md \
    '$s/$/\nIt draws 17.4 frames\na second./' '17.4 frames a second is told by hand'
check "a column of rates" told told docs/results/trees.md \
    '$s/$/\n| a | frames\/s |\n|---|---|\n| b | 7 |/' 'the column frames/s'
check "a measured table that has rates" told told docs/results/data/trees.tsv \
    's/^scenario, spheres/&, fps/' 'trees.moving: the column scenario, spheres, fps'
check "a figure that is given, and told no more" told told $given \
    '$s/$/\nREADME.md; 3 MHz; x/' \
    'README.md does not tell 3 MHz'
check "a rate that a claim tells by hand" told "pages --check docs/results/papers.md" $claims \
    's/{moving_rate}/9.6 frames a second/' '9.6 frames a second is told by hand'
check "rates of a core that is not in the table: not routed" \
    python3 -m lab.checks.clocks "$TMP/seeds"
done_testing
