#!/bin/sh
# test_stamps.sh - a measured table and its stamp are written together, by a run that has all of it
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
cp -r docs lab sim synth make rtl tb formal scenes cmodel Makefile README.md CONTRIBUTING.md \
    VERSION "$TMP"
cd "$TMP" || exit 1
mkdir empty
results=docs/results record=docs/results/data/measured.tsv

# ---- commands without any result: each page, its tables and the record stay ----
cp -r docs before
nothing() { # command: it may fail, with a message of its own
    "$@" >said 2>&1
    head -n 3 said
    ! grep Traceback said && grep -q 'stays as it is' said || return 1
    ! diff -r before docs | head -n 5 | grep .
}
lab() { python3 -m lab "$@"; }
for name in scenarios papers moving effects; do
    check "$name" nothing lab $name page --build empty
done
check "background" nothing lab background background --build empty
check "textures" nothing lab textures-page $results/texture_results.md $results/accuracy.md \
    empty docs/pictures 48x27 24x14 kitchen robot museum
check "bart" nothing lab bart-page $results/bart.md empty 48x27 kitchen:400:50 robot:3:2 museum:7:7
check "truth" nothing lab truth-page $results/truth.md empty docs/pictures/truth
check "study" nothing lab accuracy-page --only-tables $results/accuracy.md empty empty/study
check "area" nothing lab area-page $results/area.md empty standard-ecp5-all-engines1
check "fuzz" nothing lab fuzz-page empty/runs.tsv $results/mutants.md
check "one table" nothing lab place $results/mutants.md "make host-page" events empty/events

# ---- what is there is put and stamped, what lacks something is not ----
cat >put.py <<'END'
from lab.pages import whole
from lab.pages.place import place
place("docs/results/scenarios.md", "make some", {
    "full": "| scenario, spheres | tree | cycles a pixel |\n|---|---|---|\n| S1, 4 | bih1 | 2.0 |",
    "work": lambda: "| a |\n|---|\n| 3 |",
    "cycles": lambda: f"| a |\n|---|\n| {whole.load('empty/none.json') or '-'} |",
    "time": lambda: whole.load("empty/other.json")["seconds"]})
END
row() { awk -F '\t' -v table="$1" '$1 == "scenarios" && $2 == table { print $3, $5 }' $record; }
old=$(row cycles) day=$(python3 -c 'from lab.pages import measured; print(measured.commit()[1])')
check "two tables are whole, two are not" python3 put.py
check "a whole table stands in its page" grep -qF '| S1, 4 | bih1 | 2.0 |' $results/scenarios.md
check "... or in its file" grep -qx 3 $results/data/scenarios.work.tsv
check "... with its stamp" [ "$(row full)" = "make some $day" ]
check "... also in the page" grep -q '^- \*full\*, \*work\*: `make some` at commit ' \
    $results/scenarios.md
check "a table of which something is missing stays" \
    cmp before/results/data/scenarios.cycles.tsv $results/data/scenarios.cycles.tsv
check "... with its stamp" [ "$(row cycles)" = "$old" ]
check "all of it is as the record has it" python3 -m lab pages --check

# ---- results that are older than what they were made of ----
old_result() {
    echo '{}' >empty/a.json && touch -d '2001-01-01' empty/a.json &&
        python3 -c 'from lab.pages import whole
assert whole.load("empty/a.json") == {} and whole.load("empty/a.json", "rtl/**/*.v") is None
assert whole.LACKING == ["empty/a.json is older than rtl/**/*.v"], whole.LACKING'
}
check "a result from before the sources changed is none" old_result

# ---- some rows alone are new ----
some_rows() {
    before_it=$(row listing) && python3 -c 'from lab.pages.place import place
place("docs/results/scenarios.md", "make more", {"listing": "| a |\n|---|\n| 7 |"}, rest=True)' &&
        [ "$(row listing)" = "$before_it" ] && python3 -m lab pages --check
}
check "a table of which some rows are new stays as old as it was" some_rows
cd - >said && check "the ages of all tables, by a command" python3 -m lab age scenarios
aged() {
    ! python3 -m lab age nothing 2>"$TMP/said" && grep 'no measured table in' "$TMP/said"
}
check "... of a page that has none" aged
done_testing
