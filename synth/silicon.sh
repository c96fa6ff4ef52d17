#!/bin/sh
# silicon.sh - a module as cells of a standard-cell library, its memories as macros
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/silicon.sh LIB MODULE FILE.json PARAMETER=VALUE...
#   YOSYS is another one than that of the PATH; RTL another source folder; CLOCK_GATES=0: none
# FILE.json holds the flat netlist, FILE.stat what Yosys counted, FILE.log what it said. Memories
# are cells $mem_v2 in it; a table without a write port is logic. Where LEAST flip-flops or more
# wait for the same enable, a gate RT_CLOCK_GATE stops their clock: its output follows clk in clocks
# before which en was high. Modules are mapped one by one and then put together. Yosys 0.23 knows
# neither gates of clocks nor multipliers of Booth, which newer ones make.
set -eu
cd "$(dirname "$0")/.."
lib=$1 top=$2 out=${3%.json} rtl=${RTL:-rtl} yosys=${YOSYS:-yosys}
LEAST=4
shift 3
. synth/folders.sh
. sim/beside.sh
knows() { "$yosys" -p "help $1" | grep -q -e "$2"; }
booth='' gates=''
! knows synth -booth || booth=-booth
beside "$out.json"
if [ "${CLOCK_GATES:-1}" = 1 ] && knows clockgate -pos; then
    echo 'module RT_CLOCK_GATE (input en, input clk, output gclk); endmodule' >"$out.gate.v"
    # resets become logic, and clocks of them such in which a flip-flop is enabled
    only='-cell $_DFF_P_ x -cell $_DFFE_PP_ x'
    gates="dfflegalize $only -cell \$_SDFF_PP?_ x -cell \$_SDFFCE_PP?P_ x;
        dffunmap -srst-only; dfflegalize $only; opt_merge; opt_clean;
        read_verilog -lib $out.gate.v;
        clockgate -pos RT_CLOCK_GATE en:clk:gclk -min_net_size $LEAST;"
fi
# YoWASP takes paths below its own folder alone: the library is brought there.
cp "$lib" "$out.lib"
driver=$(python3 -m lab silicon-buffer "$lib")
printf 'set_driving_cell %s\nset_load 0.05 [all_outputs]\n' "$driver" >"$out.constr"
nice "$yosys" -q -l "$out.log" -p "verilog_defaults -add $include -DSYNTHESIS;
    read_verilog $(find "$rtl" -name "$top.v"); ${set_all:+chparam $set_all $top;}
    hierarchy -check -top $top $library; read_liberty -lib -ignore_miss_func $out.lib;
    synth $booth -top $top -run begin:fine; memory_map -rom-only;
    opt -fast -full; opt -undriven -fine; techmap; opt -fast; opt_clean;
    $gates dfflibmap -liberty $out.lib; opt -fast; abc -liberty $out.lib -constr $out.constr;
    opt_clean; setundef -zero; check -assert;
    flatten; opt_clean; tee -q -o $out.stat stat -liberty $out.lib;
    attrmap -remove src -remove hdlname; write_json $new" >"$out.errors" 2>&1 || {
    tail -n 5 "$out.errors" >&2
    exit 1
}
named "$out.json"
