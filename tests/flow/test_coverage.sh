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
unknown() { ! coverage rt_none && grep 'no program rt_none' "$TMP/told"; }
check "what is not met is told" misses
check "a program that is none" unknown
done_testing
