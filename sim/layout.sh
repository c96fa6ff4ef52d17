#!/bin/sh
# layout.sh - the two layout headers from their one definition, machine.def
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/layout.sh C_HEADER VERILOG_HEADER
set -eu
here=$(dirname "$0")/../cmodel/machine
for job in "c $1" "v $2"; do
    to=${job#* }
    awk -v lang="${job%% *}" -f "$here/gen_layout.awk" "$here/machine.def" >"$to.tmp"
    mv "$to.tmp" "$to"
done
