#!/bin/sh
# place.sh - places and routes a synthesised core for ECP5 between registers
# SPDX-License-Identifier: Apache-2.0
#
# usage: [BUILD=build] [ROUTE=0] [SEED=1] [SPEED=8] [LIMIT=seconds] [SDF=1] \
#            synth/place.sh CORE FOLDER
#   CORE    folder of synth/core.sh, target ecp5
#   FOLDER  gets placed.json (a summary), the netlist, report.json and log of nextpnr
# nextpnr-ecp5 is that of the PATH, or the one that `make study-pnr` puts into build/study/pnr.
# Device LFE5UM5G-85F, or LFE5U-85F for speed grades 6 and 7, which the former has not. ROUTE=0
# stops after placement; wires are estimated. 125 MHz are asked for, and the placer weighs paths by
# the fourth power of how critical they are. LIMIT: seconds of a processor that nextpnr may take; if
# it is over while wires are routed, the result is that of ROUTE=0. SDF=1 writes delays.sdf, too,
# which `python3 -m lab slow-paths` reads.
# Exit code 3: there is no nextpnr-ecp5.
set -eu
cd "$(dirname "$0")/.."
core=$1 out=$2
BUILD=${BUILD:-build} ROUTE=${ROUTE:-1} SEED=${SEED:-1} SPEED=${SPEED:-8}
LIMIT=${LIMIT:-unlimited}
case $BUILD in /*) ;; *) BUILD=$(pwd)/$BUILD ;; esac
pnr=$BUILD/study/pnr/nextpnr-ecp5
if command -v nextpnr-ecp5 >"$out/which"; then
    pnr=nextpnr-ecp5
elif [ ! -x "$pnr" ]; then
    echo "no nextpnr-ecp5 in PATH, nor in $BUILD/study/pnr: make study-pnr" >&2
    exit 3
fi

python3 -m lab placed-between "$core/netlist.il" >"$out/placed.v"
# The core is mapped already; around it there are registers and their exclusive ors.
yosys -q -l "$out/yosys.log" -p "read_rtlil $core/netlist.il; read_verilog $out/placed.v
    hierarchy -check -top placed; proc; flatten; opt_clean -purge
    synth_ecp5 -nowidelut -top placed -run map_ffs:; check -assert
    write_json $out/netlist.json" >"$out/yosys.out" 2>&1 || {
    cat "$out/yosys.out" >&2
    exit 1
}
device=um5g-85k options=
[ "$SPEED" = 8 ] || device=85k
[ "$ROUTE" = 1 ] || options=--no-route
[ "${SDF:-0}" = 0 ] || options="$options --sdf delays.sdf"
start=$(date +%s)
rm -f "$out/report.json"
# In the folder: that of study-pnr sees no other.
# shellcheck disable=SC2086  # options or none
(cd "$out" && ulimit -t "$LIMIT" && "$pnr" "--$device" --speed "$SPEED" --package CABGA381 \
    --json netlist.json --freq 125 --placer-heap-critexp 4 --placer-heap-timingweight 20 \
    --seed "$SEED" --timing-allow-fail --lpf-allow-unconstrained --report report.json $options \
    -q -l log >pnr.out 2>&1) || {
    [ "$LIMIT" != unlimited ] && grep -q '^Info: Max frequency for clock' "$out/log" || {
        tail -n 20 "$out/pnr.out" >&2
        exit 1
    }
    ROUTE=0
}
seconds=$(($(date +%s) - start))
version=$("$pnr" --version 2>&1 | sed -n 's/.*(Version \([^)]*\)).*/\1/p')
python3 -m lab placed "$out/report.json" "$out/log" "$ROUTE" "$seconds" "$version" \
    >"$out/placed.json"
