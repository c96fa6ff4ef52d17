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
check "bart" nothing lab bart-page $results/texture_results.md empty 48x27 kitchen:400:50 \
    robot:3:2 museum:7:7
check "truth" nothing lab truth-page $results/accuracy.md empty docs/pictures/truth
check "study" nothing lab accuracy-page --only-tables $results/accuracy.md empty empty/study
check "area" nothing lab area-page $results/speed_and_area.md empty standard-ecp5-all-engines1
check "fuzz" nothing lab fuzz-page empty/runs.tsv $results/verification.md
check "one table" nothing lab place $results/verification.md "make host-page" events empty/events

# ---- what is there is put and stamped, what lacks something is not ----
cat >put.py <<'END'
from lab.pages import whole
from lab.pages.place import place
place("docs/results/trees.md", "make some", {
    "bih_full": "| scenario, spheres | tree | pipes | cycles a pixel |\n|---|---|---|---|\n"
                "| S1, 4 | bih1 | 1 | 2.0 |",
    "bih_work": lambda: "| a |\n|---|\n| 3 |",
    "bih_cycles": lambda: f"| a |\n|---|\n| {whole.load('empty/none.json') or '-'} |",
    "bih_time": lambda: whole.load("empty/other.json")["seconds"]})
END
row() { awk -F '\t' -v table="$1" '$1 == "trees" && $2 == table { print $3, $5 }' $record; }
old=$(row bih_cycles)
day=$(python3 -c 'from lab.pages import measured; print(measured.commit()[1])')
check "two tables are whole, two are not" python3 put.py
check "a whole table stands in its page" grep -qF '| S1, 4 | bih1 | 1 | 2.0 |' $results/trees.md
table() { awk '/^# table / { inside = $3 == "'"$1"'"; next } inside' "$2/data/trees.tsv"; }
same_table() { table "$1" before/results >old && table "$1" $results | diff old -; }
in_its_file() { table bih_work $results | grep -qx 3; }
check "... or in its file" in_its_file
check "... with its stamp" [ "$(row bih_full)" = "make some $day" ]
check "... also in the page" grep -q '^- \*bih_full\*, \*bih_work\*: `make some` at commit ' \
    $results/trees.md
check "a table of which something is missing stays" \
    same_table bih_cycles
check "... with its stamp" [ "$(row bih_cycles)" = "$old" ]
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
    before_it=$(row bih_listing) && python3 -c 'from lab.pages.place import place
place("docs/results/trees.md", "make more", {"bih_listing": "| a |\n|---|\n| 7 |"}, rest=True)' &&
        [ "$(row bih_listing)" = "$before_it" ] && python3 -m lab pages --check
}
check "a table of which some rows are new stays as old as it was" some_rows
cd - >said && check "the ages of all tables, by a command" python3 -m lab age trees
aged() {
    ! python3 -m lab age nothing 2>"$TMP/said" && grep 'no measured table in' "$TMP/said"
}
check "... of a page that has none" aged
done_testing
