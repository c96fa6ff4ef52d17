#!/bin/sh
# cells.sh - rt_core as cells of an FPGA, for tb/netlist to simulate
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/cells.sh ecp5|xc7 FILE.json PARAMETER=VALUE...     RTL is another source folder
# FILE.json holds the flat netlist, FILE.stat what Yosys counted, FILE.log what it said.
# Modules are mapped one by one, as synth/core.sh does it, and then put together: flat before it is
# mapped, the standard core with all effects takes Yosys more than a quarter of an hour.
# What Yosys 0.23 does wrong for xc7 is kept out: it writes the upper parity bits of a 72-bit memory
# with the lower ones (`== 71` in its map of block RAM, which is mended in a copy), and its shift
# registers of LUTs lose the enable that the flip-flops had (-nosrl).
set -eu
cd "$(dirname "$0")/.."
family=$1 out=${2%.json} rtl=${RTL:-rtl}
shift 2
. synth/folders.sh
. sim/beside.sh
beside "$out.json"
case $family in
ecp5) map='synth_ecp5 -nowidelut -noflatten -top rt_core' ;;
xc7)
    share=$(dirname "$(command -v yosys)")/../share/yosys/xilinx
    sed 's/PORT_W_WIDTH == 71/PORT_W_WIDTH == 72/' "$share/brams_xc6v_map.v" >"$out.map.v"
    xilinx='synth_xilinx -family xc7 -nosrl -noiopad -noclkbuf -top rt_core'
    map="$xilinx -run begin:map_memory;
        memory_libmap -logic-cost-rom 0.015625 -lib +/xilinx/lutrams_xc5v.txt
            -lib +/xilinx/brams_xc4v.txt -D HAS_SIZE_36 -D HAS_CASCADE -D HAS_MIXWIDTH_SDP;
        techmap -map +/xilinx/lutrams_xc5v_map.v; techmap -I $share -map $out.map.v;
        $xilinx -run map_ffram:"
    ;;
*)
    echo "cells.sh: $family is neither ecp5 nor xc7" >&2
    exit 2
    ;;
esac
map=$(echo "$map" | tr '\n' ' ')
nice yosys -q -l "$out.log" -p "verilog_defaults -add $include -DSYNTHESIS;
    read_verilog $(find "$rtl" -name rt_core.v); chparam $set_all rt_core;
    hierarchy -check -top rt_core $library; $map; check -assert;
    flatten; tee -q -o $out.stat stat; attrmap -remove src -remove hdlname;
    write_json $new" >"$out.errors" 2>&1 || {
    cat "$out.errors" >&2
    exit 1
}
named "$out.json"
