#!/bin/sh
# netlist.sh - a module as its netlist for an FPGA, to be simulated in the place of its RTL
# SPDX-License-Identifier: Apache-2.0
#
# usage: [FAMILY=ecp5|xc7] synth/netlist.sh MODULE FOLDER PARAMETER=VALUE...
# Leaves in FOLDER:
#   stat, log  what Yosys said
#   rtl/       MODULE.v: the module's head as it is in rtl/, and in it the flat netlist; beside it
#              the family's cells, models of Yosys and, where it has none, of tb/netlist; headers
# xc7 has memories and products of LUTs: Yosys has no model of its block RAM. Whole cores with these
# and with DSP48E1: synth/cells.sh, which says why there are no shift registers of LUTs.
set -eu
cd "$(dirname "$0")/.."
case ${FAMILY:=ecp5} in
ecp5) map='synth_ecp5 -nowidelut' cells=ecp5 free= ;;
xc7)
    map='synth_xilinx -family xc7 -flatten -nobram -nodsp -nosrl -noiopad -noclkbuf' cells=xilinx
    free='setattr -unset ram_style -unset ram_block */*;'
    ;;
*)
    echo "netlist.sh: FAMILY: $FAMILY is neither ecp5 nor xc7" >&2
    exit 2
    ;;
esac
top=$1 out=$2 rtl=rtl
shift 2
source=$(find rtl -name "$top.v")
. synth/folders.sh
mkdir -p "$out/rtl"
${NICE:-nice} yosys -q -l "$out/log" -p "verilog_defaults -add $include -DSYNTHESIS;
    read_verilog $source; ${set_all:+chparam $set_all $top;}
    hierarchy -check -top $top $library; $free $map -top $top; check -assert;
    tee -q -o $out/stat stat; rename -top netlist; splitnets;
    write_verilog -noattr $out/netlist.v" >"$out/errors" 2>&1 || {
    cat "$out/errors" >&2
    exit 1
}

# ---- cells: the heads of all are Yosys's ----
cells=$(sed -n "s/^Parsing Verilog input from .\(.*$cells\)\/cells_sim.v' .*/\1/p" "$out/log" |
    head -n 1)
names=$({ # those of the carry cell, too
    [ $FAMILY = xc7 ] || printf '%s\n' LUT2 LUT4
    awk '/Number of cells/ { on = 1; next } on && NF == 2 { print $1 }' "$out/stat"
} | sort -u)
quiet() { # what Verilator would say of code that is not ours
    for word in WIDTH UNUSED UNDRIVEN DECLFILENAME MULTIDRIVEN INITIALDLY PINMISSING UNOPTFLAT; do
        echo "/* verilator lint_off $word */"
    done
}
one() { # module, its own body if that is given
    awk -v name="$1" -v body="${2:-}" '
        $1 == "module" && $2 ~ "^" name "\\(?$" || $0 ~ "^module " name "[ (]" { on = 1 }
        on && $1 == "specify" { off = 1 }
        on && $1 == "endmodule" && body { exit }
        on && !off
        $1 == "endspecify" { off = 0 }
        on && $1 == "endmodule" { exit }' "$cells/cells_sim.v" $(ls "$cells/cells_bb.v" 2>/dev/null)
    [ -z "${2:-}" ] || cat "$2"
}
{
    quiet
    echo '`timescale 1ns / 1ps'
    echo '`include "rt_check.vh"'
    for name in $names; do
        body=tb/netlist/$name.vh
        [ -f "$body" ] || body=
        one "$name" "$body"
    done
} >"$out/rtl/cells.v"

# ---- the module: its own head, so that a harness sees no difference ----
find rtl -name '*.vh' -exec cp {} "$out/rtl/" \;
{
    quiet
    sed '/^);/q; s/output reg /output wire/' "$source"
    echo '    netlist u_netlist ('
    awk '/^);/ { exit } /^ *(input|output) / {
            sub(/ *\/\/.*/, ""); sub(/,$/, "")
            printf "%s        .%s(%s)", (n++ ? ",\n" : ""), $NF, $NF
        }
        END { print "\n    );\nendmodule" }' "$source"
    echo '`default_nettype wire'
    cat "$out/netlist.v"
} >"$out/rtl/$top.v"
rm "$out/netlist.v"
