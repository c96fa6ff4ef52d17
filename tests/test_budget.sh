#!/bin/sh
# test_budget.sh - the standard core for ecp5 stays within synth/budget.txt
# SPDX-License-Identifier: Apache-2.0
#
# Synthesises it if a source changed (a minute), and shows that the check can fail: a budget that
# is one multiplier or one LUT short, or names what is not there, is noticed.
set -u
. "$(dirname "$0")/tap.sh"
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
key=standard-ecp5-all-engines1
run=$BUILD/synth/$key

if ! command -v yosys >"$TMP/yosys"; then
    echo "ok 1 - # SKIP no yosys"
    echo "1..1"
    exit 0
fi
check "synthesis; no loop, no undriven net" \
    env -u MAKEFLAGS -u MFLAGS make -s -f synth/area.mk results B="$BUILD" PROFILES=standard
[ -f "$run/stat.json" ] || {
    done_testing
    exit 1
}

python3 synth/budget.py "$run" synth/budget.txt >"$TMP/budget"
while read -r line; do
    case $line in ok*) rc=0 ;; *) rc=1 ;; esac
    echo "$line" >"$TMP/line"
    tap $rc "${line#*- }" "$TMP/line"
done <"$TMP/budget"

over() { ! python3 synth/budget.py "$run" "$1" && [ "$2" = "$(python3 synth/budget.py "$run" \
    "$1" | grep -c '^not ok')" ]; }
core=$(sed -n 's/.* rt_core: \([0-9]*\) of [0-9]* MULT18X18D, \([0-9]*\) of .*/\1 \2/p' \
    "$TMP/budget")
mult=${core% *} lut4eq=${core#* }
echo "rt_core $mult $lut4eq" >"$TMP/exact"
check "what the core takes is within a budget of just that" \
    python3 synth/budget.py "$run" "$TMP/exact"
echo "rt_core $((mult - 1)) $lut4eq" >"$TMP/multiplier"
check "one multiplier too many is noticed" over "$TMP/multiplier" 1
echo "rt_core $mult $((lut4eq - 1))" >"$TMP/lut"
check "one LUT4 too many is noticed" over "$TMP/lut" 1
echo "rt_nowhere 1 1" >"$TMP/nowhere"
check "a module that is gone is noticed" over "$TMP/nowhere" 1
check "no latch" sh -c "! grep '^Latch inferred' '$run/log'"
check "no memory but the block and distributed ones fell apart" sh -c \
    "! grep 'using FF mapping for memory' '$run/log'"
check "every rt_slot_ram is block RAM, every rt_slot_file distributed" python3 -c "
import sys; sys.path.insert(0, 'synth'); import results
m = results.read('$run')['modules']
ram, words = m['rt_slot_ram']['own'], m['rt_slot_file']['own']
print(ram, words)
assert ram['ff'] == 0 and ram['dpr'] == 0 and ram['bram'] >= m['rt_slot_ram']['instances']
assert words['ff'] == 0 and words['bram'] == 0 and words['dpr'] >= m['rt_slot_file']['instances']"
done_testing
