#!/bin/sh
# test_readme.sh - the core as README instantiates it, elaborated: every port and effect, no warning
# SPDX-License-Identifier: Apache-2.0
#
# The text between ```verilog and ``` is elaborated as it stands, in Icarus.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
folders=$(find rtl -type d | sed 's/.*/-y & -I &/')

sed -n '/^```verilog$/,/^```$/p' README.md | sed '1d;$d' >"$TMP/tracer.v"
check "README has a module" grep -q '^module tracer (' "$TMP/tracer.v"
elaborates() { # file: in silence
    # shellcheck disable=SC2086  # a list of words on purpose
    iverilog -g2005 -Wall -Wno-timescale $folders -s tracer -t null "$1" >"$TMP/said" 2>&1
    rc=$?
    cat "$TMP/said"
    [ $rc -eq 0 ] && [ ! -s "$TMP/said" ]
}
check "it elaborates, in silence" elaborates "$TMP/tracer.v"
ports() { # those of rt_core, and those that README connects
    sed -n '/^) (/,/^);/p' rtl/core/rt_core.v | sed 's,//.*,,' |
        grep -oE '\b(clk|rst|[a-z_]+_[io])\b' | sort -u >"$TMP/ports"
    grep -oE '\.(clk|rst|[a-z_]+_[io])\(' "$TMP/tracer.v" | tr -d '.(' | sort -u |
        diff "$TMP/ports" -
}
check "every port of the core is connected" ports
effects() { # words of the list of effects, as parameters
    sh sim/parameters.sh none | tr ' ' '\n' | sed 's/=.*//' | sort >"$TMP/effects"
    sed -n '/rt_core #(/,/) u_core/p' "$TMP/tracer.v" | grep -oE '\.[A-Z_]+\(' | tr -d '.(' |
        sort >"$TMP/given"
    ! comm -23 "$TMP/effects" "$TMP/given" | grep .
}
check "every effect is a parameter there" effects

# ---- what these checks notice ----
noticed() { # sed expression, check
    sed "$1" "$TMP/tracer.v" >"$TMP/broken.v"
    shift
    ! "$@"
}
check "a port of another width is noticed" noticed 's/\[34:0\] pix_key/[33:0] pix_key/' \
    elaborates "$TMP/broken.v"
check "a parameter that is not there is noticed" noticed 's/\.ENGINES(1)/.ENGINE(1)/' \
    elaborates "$TMP/broken.v"
check "an input without a value is noticed" noticed 's/\.start_i(start), //' \
    elaborates "$TMP/broken.v"
done_testing
