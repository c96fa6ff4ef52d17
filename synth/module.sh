#!/bin/sh
# module.sh - area for ecp5 of one module alone, with what is inside it, as a row of a table
# SPDX-License-Identifier: Apache-2.0
# usage: [NETLIST=FILE] synth/module.sh MODULE [PARAMETER=VALUE...]
# As core.sh maps it; LUT4eq = LUT4 + 2 CCU2C. Columns: parameters, MULT18X18D, LUT4eq, FF, DP16KD,
# TRELLIS_DPR16X4. NETLIST: keeps what it is mapped to, for synth/place.sh.
set -eu
cd "$(dirname "$0")/.."
top=$1
shift
set_all=
for p; do set_all="$set_all -set ${p%%=*} ${p#*=}"; done
folders=$(find rtl -name '*.v*' -exec dirname {} + | sort -u)
include='' library=''
for d in $folders; do include="$include -I$d" library="$library -libdir $d"; done
stat=$(mktemp)
trap 'rm -f "$stat"' EXIT
nice yosys -q -p "verilog_defaults -add $include -DSYNTHESIS;
    read_verilog -lib +/ecp5/cells_bb.v;
    read_verilog $(find rtl -name "$top.v"); ${set_all:+chparam $set_all $top;}
    hierarchy -check -top $top $library; synth_ecp5 -nowidelut -noflatten -top $top;
    check -assert; tee -q -o $stat stat; ${NETLIST:+write_rtlil $NETLIST}" >&2
# the last count is that of the whole: of the hierarchy, if there is one
awk -v name="$*" '/Number of cells/ { delete n } NF == 2 { n[$1] = $2 }
    END {
        printf "| %s | %d | %d | %d | %d | %d |\n", name, n["MULT18X18D"],
            n["LUT4"] + 2 * n["CCU2C"], n["TRELLIS_FF"], n["DP16KD"], n["TRELLIS_DPR16X4"]
    }' "$stat"
