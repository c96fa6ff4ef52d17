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
given() { # file: NAME=value of the parameters that it gives rt_core
    tr ',' '\n' <"$1" | sed -n 's/^ *\.\([A-Z_]*\)(\([0-9]*\)).*/\1=\2/p'
}
sed -n 's/^    parameter \([A-Z_]*\) *= \([0-9]*\).*/\1=\2/p' rtl/core/rt_effects.vh \
    rtl/core/rt_core_parameters.vh >"$TMP/defaults"
changes() { # what it gives is a parameter, and not the default
    given "$1" >"$TMP/changed"
    [ -s "$TMP/changed" ] && while IFS='=' read -r name value; do
        grep "^$name=" "$TMP/defaults" | grep -qvx "$name=$value" ||
            { echo "$name=$value" && return 1; }
    done <"$TMP/changed"
}
check "it names the parameters that it changes, and no other" changes "$TMP/tracer.v"

# ---- a room with images and mirrors ----
"$SPHAERA" build scenes/texture/hall.nff --profile standard -o "$TMP/hall.sph" >"$TMP/text" 2>&1
asks=$("$SPHAERA" info "$TMP/hall.sph" | sed -n 's/^core *//p')
draws() { # file: its core can do what the scene asks for
    sh sim/parameters.sh "$asks" | tr ' ' '\n' | grep -vE '^(RECT|SPANS|CONES)=' >"$TMP/asked"
    { cat "$TMP/defaults" && given "$1"; } >"$TMP/given"
    awk -F= 'NR == FNR { has[$1] = $2; next } $2 > has[$1] { print; few = 1 }
        END { exit few || FNR < 10 }' "$TMP/given" "$TMP/asked"
}
check "it draws such a scene" draws "$TMP/tracer.v"

# ---- what these checks notice ----
noticed() { # sed expression, check
    sed "$1" "$TMP/tracer.v" >"$TMP/broken.v"
    shift
    ! "$@"
}
check "a port of another width is noticed" noticed 's/\[34:0\] pix_key/[33:0] pix_key/' \
    elaborates "$TMP/broken.v"
check "a parameter that is not there is noticed" noticed 's/\.LIGHTS(3)/.LIGHT(3)/' \
    elaborates "$TMP/broken.v"
check "an input without a value is noticed" noticed 's/\.start_i(start), //' \
    elaborates "$TMP/broken.v"
check "an effect that the scene needs is noticed" noticed 's/\.SPREAD(1)/.SPREAD(0)/' \
    draws "$TMP/broken.v"
check "a parameter that has its default is noticed" noticed 's/\.SPANS(0)/.SPANS(1)/' \
    changes "$TMP/broken.v"
done_testing
