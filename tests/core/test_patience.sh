#!/bin/sh
# test_patience.sh - a bench says "mismatch" only when it read its inputs and the core had its time
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
"$SPHAERA" build scenes/paper5.nff --profile draft --size 12x8 -o "$TMP/m.sph" >"$TMP/log" || exit 1

core() { # simulator, more options
    sim=$1
    shift
    env -u MAKEFLAGS SIM="$sim" EFFECTS=auto BUILD="$BUILD" \
        sh sim/core.sh --machine "$TMP/m.sph" "$@"
}
ends() { # exit code, pattern of what is printed, command...
    want=$1 pattern=$2 rc=0
    shift 2
    "$@" >"$TMP/said" 2>&1 || rc=$?
    cat "$TMP/said"
    echo "exit code $rc"
    [ "$rc" = "$want" ] && grep -q -e "$pattern" "$TMP/said"
}
quiet_of_mismatches() { ! grep -i mismatch "$TMP/said"; }
for sim in verilator icarus; do
    # a line of memory comes every 400 clocks, the first pixel after some thousands
    check "$sim: who is slow has time" ends 0 ' 96 pixels, 0 mismatches; ' \
        core $sim --latency 400 --watchdog 500
    check "$sim: who does nothing is given up" ends 4 '^given up: core .*: 0 of 96 pixels; ' \
        core $sim --latency 5000 --watchdog 1000
    check "... and nothing is called a mismatch" quiet_of_mismatches
    check "... but told" grep -q 'no progress for' "$TMP/said"
done

# Icarus opens no file whose name has a letter beyond ASCII or an apostrophe, and goes on.
folder=$(core icarus --folder)
odd="$TMP/B'aume äöü"
mkdir -p "$odd"
cp "$folder/tb_core.vvp" "$odd/bench.vvp"
check "a bench in a folder of any name" ends 0 ' 96 pixels, 0 mismatches; ' \
    "$BUILD/sim/tb_core_icarus" --engine "$odd/bench.vvp" --machine "$TMP/m.sph"
unread() { # plusargs
    timeout 20 vvp -n "$odd/bench.vvp" +out=/dev/stdout "$@" >"$TMP/said" 2>&1
    cat "$TMP/said"
    grep -q '^n no [a-z]* from ' "$TMP/said" && ! grep -q '^[pceh] ' "$TMP/said"
}
check "a bench without its inputs simulates nothing" unread "+regs=$TMP/none" "+mem=$TMP/none"
done_testing
