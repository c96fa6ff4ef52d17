#!/bin/sh
# test_netlist.sh - the models of memories in netlists, by netlists of three memories
# SPDX-License-Identifier: Apache-2.0
# A fault in a model shows that the comparison can fail.
#   ALL=1  the netlist of rt_build in its bench, too: some processor minutes
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
run() { # bench, module, parameters of the bench: its netlist, which is in $TMP/net
    iverilog -g2005 -I"$TMP/net/rtl" -s "$1" -o "$TMP/tb" $3 "tb/netlist/$1.v" \
        "$TMP/net/rtl/cells.v" "$TMP/net/rtl/$2.v" >"$TMP/build" 2>&1 || cat "$TMP/build"
    vvp -n "$TMP/tb" >"$TMP/said" && cat "$TMP/said" && grep -q '^ok' "$TMP/said"
}
net() { # family, parameters
    FAMILY=$1
    export FAMILY
    shift
    sh synth/netlist.sh rt_slot_ram "$TMP/net" "$@"
}
while read -r family parameters; do
    # shellcheck disable=SC2086  # a list of words
    check "netlist of rt_slot_ram for $family, $parameters" net $family $parameters
    set_all=$(echo " $parameters" | sed 's/ / -Ptb_slot_ram./g')
    check "it is the memory, $parameters" run tb_slot_ram rt_slot_ram "$set_all"
done <<END
xc7 WIDTH=5 SLOTS=64 OLD=1
ecp5 WIDTH=66 SLOTS=512 OLD=1
ecp5 WIDTH=5 SLOTS=4096 OLD=1
END
sed -i 's/if (a_writes) begin/if (a_writes \&\& !a_at[5]) begin/' "$TMP/net/rtl/cells.v"
beside() { ! run tb_slot_ram rt_slot_ram "$set_all" && grep -q '^not ok' "$TMP/said"; }
check "words that are not written are noticed" beside

builds() { # the bench of rt_build around its netlist
    python3 - "$TMP/build" "${BUILD:-build}" <<'END' >"$TMP/bench" || return 1
import sys
from lab.benches import Line
out, build = sys.argv[1:]
bench = Line("small rt_build tb_build W=8 FW=6 COUNT=16", build)
print(bench.around(f"{out}/tb", ["--language", "1364-2005", "-Wno-fatal", f"-I{out}/rtl",
                                 *(f"-G{n}={v}" for n, v in bench.parameters),
                                 f"{out}/rtl/cells.v", f"{out}/rtl/rt_build.v"]))
END
    "$(tail -n 1 "$TMP/bench")" 1 60
}
if [ -n "${ALL:-}" ]; then
    check "netlist of rt_build for ecp5" \
        env FAMILY=ecp5 sh synth/netlist.sh rt_build "$TMP/build" W=8 FW=6 COUNT=16
    mkdir -p "$TMP/build/tb"
    check "it builds trees as the model does" builds
fi
done_testing
