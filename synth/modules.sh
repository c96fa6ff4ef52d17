#!/bin/sh
# modules.sh - modules of a core as it is elaborated, without mapping: seconds
# SPDX-License-Identifier: Apache-2.0
# usage: synth/modules.sh LIST    (sim/cores.py); prints one name a line, sorted
set -eu
cd "$(dirname "$0")/.."
set_all=$(sim/cores.py parameters "$1" | sed 's/\([A-Z]*\)=\([0-9]*\)/-chparam \1 \2/g')
folders=$(find rtl -name '*.v*' -exec dirname {} + | sort -u)
include='' library=''
for d in $folders; do include="$include -I$d" library="$library -libdir $d"; done
yosys -q -p "verilog_defaults -add $include -DSYNTHESIS; read_verilog rtl/core/rt_core.v;
    hierarchy -check -top rt_core $set_all $library; tee -q -o /dev/stdout ls" |
    grep -o 'rt_[a-z0-9_]*' | sort -u
