#!/bin/sh
# cxxrtl.sh - rt_core as C++ that simulates it, by Yosys
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/cxxrtl.sh FILE.cpp PARAMETER=VALUE...     RTL is another source folder
set -eu
cd "$(dirname "$0")/.."
out=$1 rtl=${RTL:-rtl}
shift
. synth/folders.sh
. sim/beside.sh
beside "$out"
source=$(find "$rtl" -name rt_core.v)
yosys -q -p "verilog_defaults -add $include -DSYNTHESIS; read_verilog $source;
    chparam $set_all rt_core; hierarchy -check -top rt_core $library; proc; check -assert;
    write_cxxrtl -g0 $new"
named "$out"
