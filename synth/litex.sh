#!/bin/sh
# litex.sh - generates the LiteX system of a ULX3S, lints it, links its firmware
# SPDX-License-Identifier: Apache-2.0
#
# usage: LITEX=PYTHON synth/litex.sh FOLDER
# Of what LiteX writes errors are looked for alone (pins of both directions it
# declares as inputs, and Verilator cannot follow them),
# of rt_top's connections missing ones too.
set -eu
cd "$(dirname "$0")/.."
out=$1
mkdir -p "$out"
# shellcheck disable=SC2046  # lists of words on purpose
"$LITEX" -m lab litex-board "$out" $(sim/cores.py profile standard) \
    $(sim/cores.py parameters shadow+reflect2+lights1+inside+rect) >"$out/litex.log" 2>&1 || {
    tail -n 20 "$out/litex.log" >&2
    exit 1
}
top=$out/gateware/sphaera_ulx3s.v
parts=$(dirname "$(dirname "$(command -v yosys)")")/share/yosys/ecp5
cpu=$("$LITEX" -c 'import pythondata_cpu_vexriscv as cpu; print(cpu.data_location)')
# shellcheck disable=SC2046
verilator --lint-only -Wno-fatal -Wno-ASSIGNIN --language 1364-2005 --timescale 1ns/1ps \
    --top-module sphaera_ulx3s $(find rtl -type d | sed 's/.*/-y & -I&/') -I"$out/gateware" \
    "$cpu/VexRiscv_Lite.v" "$top" -I"$parts" "$parts/cells_sim.v" \
    "$parts/cells_bb.v" >"$out/lint.log" 2>&1 ||
    if grep '^%Error' "$out/lint.log" | grep -vE 'Unsupported: tristate|Exiting due to' >&2; then
        exit 1
    fi
at=$(grep -n '^) rt_top (' "$top" | cut -d: -f1)
if [ -z "$at" ] || grep "^%Warning-PINMISSING: $top:$at:" "$out/lint.log" >&2; then
    echo "litex: rt_top is not wholly connected" >&2
    exit 1
fi
package=$("$LITEX" -c 'import litex; print(litex.__path__[0])')
rc=0
sh synth/firmware.sh "$package" "$out" ram || rc=$?
case $rc in
0) linked='firmware linked for rv32im' ;;
3) linked='firmware compiled for rv32im, not linked: no linker, make litex-setup' ;;
*) exit 1 ;;
esac
echo "ok - litex: $(wc -l <"$top") lines of Verilog, rt_top connected, $linked"
