#!/bin/sh
# test_reset.sh - one clock of reset makes modules quiet, and a reset that is gone is noticed
# SPDX-License-Identifier: Apache-2.0
# `make formal` tries each module, and so does ALL=1 here.
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../edit.sh"
cd "$(dirname "$0")/../.." || exit 1
quiet() { python3 -m lab.reset "$TMP/build" "$@"; }
if [ -n "${ALL:-}" ]; then
    check "each module is quiet after one clock of reset" quiet
else
    check "modules are quiet after one clock of reset" \
        quiet rt_slots rt_cache rt_video rt_traversal_stack
fi

# ---- a reset that is gone: module that is looked at, file, text that becomes another ----
mkdir "$TMP/tree"
cp -r rtl lab formal "$TMP/tree/"
notices() { # module, file, FROM, TO
    FROM=$3 TO=$4 NEW=$TMP/new
    export FROM TO NEW
    edit "$TMP/tree/$2" || return
    (cd "$TMP/tree" && python3 -m lab.reset "$TMP/build" "$1")
    rc=$?
    cp "$2" "$TMP/tree/$2"
    [ $rc -eq 1 ] && grep -q '^not ok.* is [x1] in clock' "$TMP/out"
}
check "a pixel that waits is not forgotten: rt_slots" notices rt_slots rtl/engine/rt_slots.v \
    "r_valid_q <= 1'b0; p_valid_q <= 1'b0; end" "r_valid_q <= 1'b0; end"
check "a queue that keeps its pointer: rt_fifo" notices rt_fifo rtl/memory/rt_fifo.v \
    "wr_q <= {(AB+1){1'b0}};" ""
check "a delay that keeps what is in it: rt_facet" notices rt_facet rtl/math/rt_delay_valid.v \
    "if (rst) line_q <= {(CYCLES+1){1'b0}};" "if (rst) line_q[0] <= 1'b0;"
check "a line that is full: rt_mem_arbiter" notices rt_mem_arbiter rtl/memory/rt_mem_arbiter.v \
    "beat_q <= 2'd0; full_q <= 1'b0;" "beat_q <= 2'd0;"
check "an address on the bus: rt_axi_write" notices rt_axi_write rtl/bus/rt_axi_write.v \
    "if (rst || forget_i) begin m_awvalid <= 1'b0;" "if (rst || forget_i) begin"
done_testing
