#!/bin/sh
# test_coverage.sh - benches that meet every line, branch and bit of their module; what is told else
# SPDX-License-Identifier: Apache-2.0
# What all benches and frames meet is `make coverage`.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
build=${BUILD:-build}
coverage() { python3 -m lab coverage --least "$build" "$1" >"$TMP/told" 2>&1; }
BENCH_BUILD=$build python3 -m lab benches --tools || exit 1
for module in rt_square rt_fifo; do
    check "$module is met" coverage $module
done
misses() { # without what is waived, from what was kept
    ! python3 -c "import sys; from lab import coverage as c
c.WAIVED = '/dev/null'
sys.exit(c.main('$build', 'rt_square', least=True))" >"$TMP/told" 2>&1 &&
        grep 'never: rt_square.v:.* bits s1_q' "$TMP/told"
}
patterns() { # bits and lines that a waiver names, and those beside them
    python3 -c "import sys; from lab.coverage import named as n
w = 'ab*[3:1],c[7:4/8],d,line9'
yes, no = ('abc[1]', 'ab[3]', 'c[4]', 'c[15]', 'd'), ('abc[0]', 'ab[4]', 'c[3]', 'c[8]', 'd[1]')
sys.exit(not (all(n(w, x, '5') for x in yes) and not any(n(w, x, '5') for x in no)
              and n(w, '3 if', '9') and not n(w, '3 if', '99')))"
}
unknown() { ! coverage rt_none && grep 'no program rt_none' "$TMP/told"; }
check "what is not met is told" misses
check "what a waiver names" patterns
check "a program that is none" unknown
done_testing
