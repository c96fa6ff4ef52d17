#!/bin/sh
# test_hard.sh - hard cases: named, generated, resumed; faults in the model are noticed
# SPDX-License-Identifier: Apache-2.0
#
#   MUTANT=pattern  faults in the model whose name or judge has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
export BUILD TMP
hard=$BUILD/test/hard

# ---- named cases ----
"$hard" --named >"$TMP/named" 2>&1
awk -v at="$TMP/named." '/^(not )?ok /{ n++ } { print >(at (n + 0)) }' "$TMP/named"
names=$(grep -cE '^(not )?ok ' "$TMP/named")
for n in $(seq "$names"); do
    IFS= read -r line <"$TMP/named.$n"
    case $line in
    ok*) tap 0 "case ${line#ok }" "$TMP/named.$n" ;;
    *) tap 1 "case ${line#not ok }" "$TMP/named.$n" ;;
    esac
done
all_named() { [ "$names" -eq 87 ]; }
check "87 named cases" all_named
block() { # what stands behind a mark of a page
    sed -n "/^<!-- $1 -->\$/,/^<!-- end -->\$/p" "docs/results/$2.md" | sed '1d;$d'
}
campaign() { # every family in each profile, nothing wrong
    "$hard" --list | sed -n 's/^| `\([a-z0-9_]*\)` .*/\1/p' >"$TMP/families"
    awk -F '\t' -v families="$(wc -l <"$TMP/families")" '
        NR == FNR { family[$1]; next }
        /^# table / { campaign = $0 == "# table campaign" }
        !campaign { next }
        $5 ~ "/" && ($5 != "0/0/0" || $6 != 0) { print; bad = 1 }
        $1 in family { rows[$2]++ }
        $1 in family && $3 < 5e6 { print; bad = 1 }
        END {
            for (p in rows) {
                n++
                if (rows[p] != families) { print p, rows[p]; bad = 1 }
            }
            exit bad || n != 4
        }' "$TMP/families" docs/results/data/hard_cases.tsv
}
check "table campaign: 5 million cases of every family in each profile, 0 wrong" campaign
pictures() { # the same pixels and counts; the model shows no other sphere
    mkdir -p "$TMP/pictures" || return 1
    "$hard-pictures" tests/hard/pictures "$TMP/pictures" >"$TMP/counts" || return 1
    block counts hard_cases | diff - "$TMP/counts" || return 1
    for file in "$TMP"/pictures/*.png docs/pictures/hard_*.png; do
        picture=$(basename "$file")
        "$SPHAERA" compare "docs/pictures/$picture" "$TMP/pictures/$picture" || return 1
    done
}
check "docs/results/hard_cases.md: pictures and counts of make hard-pictures" pictures

# ---- generated cases ----
run() { "$hard" --seed "${SEED:-1}" "$@"; }
short() {
    run --cases 40000 --exhaustive 16 --processes 2 --json "$TMP/hard.json" >"$TMP/table" &&
        grep -q ' 0 wrong$' "$TMP/table" && grep -q '"family": "filter"' "$TMP/hard.json" ||
        { cat "$TMP/table" && return 1; }
}
check "generated and exhaustive cases: hard --cases 40000 --exhaustive 16 --seed ${SEED:-1}" short
resumed() { # in three runs the same as in one
    set -- --cases 5000 --exhaustive 0
    run "$@" | grep '^|' >"$TMP/whole"
    run "$@" --state "$TMP/state" --chunks 33 | grep 'not all of it' || return 1
    run "$@" --state "$TMP/state" --chunks 20 --processes 2 | grep 'not all of it' || return 1
    run "$@" --state "$TMP/state" --processes 2 | grep '^|' | diff - "$TMP/whole"
}
check "a campaign in three runs is the same as in one" resumed
parts() { # in three parts that are put together the same as in one
    set -- --cases 5000 --exhaustive 0
    for p in 0 1 2; do run "$@" --part $p/3 --state "$TMP/part$p" || return 1; done
    run "$@" --state "$TMP/parts" --merge "$TMP/part2" "$TMP/part0" "$TMP/part1" &&
        run "$@" --state "$TMP/parts" >"$TMP/all" && grep '^0 cases in' "$TMP/all" &&
        grep '^|' "$TMP/all" | diff - "$TMP/whole"
}
check "a campaign in three parts is the same as in one" parts
spread() { # numbers 0 to 9 and 10 to 19 are other cases
    run --cases 200 --exhaustive 0 | grep '^|' >"$TMP/a"
    run --cases 200 --exhaustive 0 --first 10 | grep '^|' >"$TMP/b"
    ! cmp -s "$TMP/a" "$TMP/b"
}
check "--first goes on to other cases" spread
sanitized() {
    "$hard.sanitized" --cases 2000 --exhaustive 2000 --seed "${SEED:-1}" || return 1
    for n in 4 7 20 24 25 38 39 40 41 43 50 56 59 71 73 74 77 85 87; do
        "$hard.sanitized" --named=$n || return 1
    done
}
check "the same under the sanitizers" sanitized
check "one case, repeated" run --case pair:reference:77
refused() {
    name=$1
    shift
    "$hard" "$@" >"$TMP/out" 2>&1 && rc=0 || rc=$?
    [ $rc -eq 2 ] && rc=0 || rc=1
    tap $rc "$name" "$TMP/out"
}
refused "a family that is none" --family none
kind() { # all of a kind, and no others
    run --cases 700 --exhaustive 0 --family facets | grep -c '^| [a-z]* *| draft' | grep -x 10
}
check "a kind of families" kind
refused "a number that is none" --cases 1k
refused "a case that is none" --case pair:reference
refused "a named case that is none" --named=88
refused "a part that is none" --part 3/3 --state "$TMP/none"
refused "a part twice" --cases 5000 --exhaustive 0 --seed "${SEED:-1}" --state "$TMP/none" \
    --merge "$TMP/part0" "$TMP/part0"
refused "the state of another campaign" --cases 5001 --exhaustive 0 --state "$TMP/state"
head -n 9 "$TMP/state" >"$TMP/damaged"
refused "a damaged state" --cases 5000 --exhaustive 0 --state "$TMP/damaged" --seed "${SEED:-1}"
refused "a state that cannot be written" --cases 20 --exhaustive 0 --state "$TMP/none/state"

# ---- faults in the model ----
repeats() { # a failing case is printed with a command that shows it again
    wrong=$TMP/tangent-hits
    python3 -m lab faults program tangent-hits "$wrong" || return 1
    "$wrong" --cases 400 --exhaustive 0 --family graze0 >"$TMP/failing" && return 1
    grep -q '[1-9][0-9]* wrong$' "$TMP/failing" || return 1
    again=$(sed -n 's/^  repeat: //p' "$TMP/failing" | head -n 1)
    [ -n "$again" ] || return 1
    $again >"$TMP/again" && return 1
    grep 'wrong hit: hits' "$TMP/again"
}
check "a failing case is printed and can be repeated" repeats
done_testing
python3 -m lab faults run --by hard,test
