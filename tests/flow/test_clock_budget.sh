#!/bin/sh
# test_clock_budget.sh - blocks of the shell, routed alone, are as fast as their budget says
# SPDX-License-Identifier: Apache-2.0
#
# With nextpnr-ecp5 alone: that of the PATH or of `make study-pnr`. Shows that the check can fail: a
# budget that is above what is reached, a line that is none and a block without a line are noticed.
#   ALL=1  every block (`make clock-budget`)
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
if ! command -v yosys >"$TMP/which" ||
    ! { command -v nextpnr-ecp5 >"$TMP/which" || [ -x "$BUILD/study/pnr/nextpnr-ecp5" ]; }; then
    echo "ok 1 - # SKIP no yosys, or no nextpnr-ecp5: make study-pnr"
    echo "1..1"
    exit 0
fi
budget() { # file, blocks
    BLOCK=$2 python3 -c "from lab.synth import clock_budget
clock_budget.main('$BUILD', '$1')" >"$TMP/told" 2>&1
    rc=$?
    cat "$TMP/told"
    return $rc
}
noticed() { # pattern, file, blocks
    ! budget "$2" "$3" && grep -q -- "$1" "$TMP/told"
}
blocks='rt_frame_groups rt_scan rt_counters'
check "blocks within synth/clock_budget.txt" \
    budget synth/clock_budget.txt "$([ -n "${ALL:-}" ] || echo "$blocks")"
echo 'rt_frames 999' >"$TMP/high"
check "a block that is too slow is noticed" noticed '^not ok - rt_frames: ' "$TMP/high" ''
echo 'rt_frames fast' >"$TMP/word"
check "a line that is none is told" noticed "$TMP/word:1: not .module MHz" "$TMP/word" ''
check "a block without a line is told" noticed 'not in .*: rt_nowhere;' "$TMP/high" rt_nowhere
done_testing
