#!/bin/sh
# test_fuzz_page.sh - lab.fuzz: runs of one machine on a page that has those of others
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
page=$TMP/page.md runs=$TMP/runs.tsv
cp docs/results/verification.md "$page"
table() { sed -n '/^<!-- runs -->/,/^<!-- end -->/p' "$1"; }
row() { table "$page" | grep "^| $1 |"; }
run() { # harness, how, seed, runs, digest
    printf '2030-01-02\t%s\t%s\t%s\t3\t%s\t7\t0\t%s\n' "$1" "$2" "$3" "$4" "$5" >>"$runs"
}
placed() { python3 -m lab fuzz-page "$runs" "$page"; }
others() { # file: all but the row of nff and of what is new
    grep -v '^| nff |\|^| new |' "$1"
}
names() { table "$page" | sed -n 's/^| \([a-z]*\) |.*/\1/p' | tr '\n' ' '; }
before=$(names)

# ---- no run ----
without() { # what is said, and the page stays
    ! placed >"$TMP/said" 2>&1 && cat "$TMP/said" &&
        grep -q "^fuzz: $runs: no run is there; $page stays as it is" "$TMP/said" &&
        cmp docs/results/verification.md "$page"
}
check "no file of runs: the page stays" without
: >"$runs"
check "a file without a run: the page stays" without

# ---- a harness of the page, one that it lacks ----
run new plain 5 1000 0000aaaa
run nff afl 1 900 0000aaaa
run nff afl 1 1500 0000bbbb
run nff plain 2 1000000 0000bbbb
check "runs of two harnesses" placed
check "... the page's order, what is new behind it" [ "$(names)" = "${before}new " ]
check "... of nff its last sources are added up" [ "$(row nff)" = \
    "| nff | 1 001 500 | 1 500 | 1 000 000 | 6 | 7 | 0 | 1 2 | 2030-01-02 | 0000bbbb |" ]
check "... the new one's" [ "$(row new)" = \
    "| new | 1 000 | 0 | 1 000 | 3 | 7 | 0 | 5 | 2030-01-02 | 0000aaaa |" ]
others docs/results/verification.md >"$TMP/others"
others "$page" >"$TMP/now"
check "... other rows, and the page around them, stay" cmp "$TMP/others" "$TMP/now"
cp "$page" "$TMP/once"
check "the same runs again" placed
check "... change nothing" cmp "$TMP/once" "$page"
done_testing
