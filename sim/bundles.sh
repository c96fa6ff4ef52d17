#!/bin/sh
# bundles.sh - the Verilog and the C++ header of the engine's bundles from their one definition
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/bundles.sh VERILOG_HEADER C_HEADER
set -eu
here=$(dirname "$0")
. "$here/beside.sh"
for job in "v $1" "c $2"; do
    to=${job#* }
    beside "$to"
    awk -v lang="${job%% *}" -f "$here/bundles.awk" "$here/../rtl/engine/bundles.def" >"$new"
    named_anew "$to"
done
