#!/bin/sh
# test_vip.sh - the verification IP: its examples against the core, and against planted faults
# SPDX-License-Identifier: Apache-2.0
#
# Verilator compiles for minutes, cocotb comes by `make bus-setup`: with ALL=1, as in `make vip`;
# what is absent is skipped. tests/flow/test_python.sh tries scoreboard and units themselves.
# VERILATOR names another one than that of the PATH.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD verilator=${VERILATOR:-verilator} major=$(cut -d. -f1 VERSION)
skip() { echo "ok $((checks += 1)) - # SKIP $1"; }
has() { grep -qE -- "$1" "$2"; } # pattern, file

# ---- what every bench is made of ----
files=$(sed '/^ *\/\//d' rtl/sphaera.f)
lint() { # top module
    # shellcheck disable=SC2086  # words
    "$verilator" --lint-only --timing -Wno-fatal -Wno-lint -Wno-DECLFILENAME --top-module "$1" \
        tb/vip/sphaera_pkg.sv "examples/verification/$1.sv" $files
}
for top in core_tb units_tb; do
    check "Verilator takes $top" lint $top
done
if [ -z "${ALL:-}" ]; then
    skip "Verilator and cocotb run with ALL=1: make vip"
    done_testing
    exit 0
fi

env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s B="$BUILD" library >"$TMP/text" 2>&1 ||
    cat "$TMP/text"
mkdir "$TMP/lib"
cp "$BUILD/dist/libsphaera.so.$(cat VERSION)" "$TMP/lib/libsphaera.so.$major"
"$SPHAERA" build scenes/interpenetrating.nff --profile draft --size 12x8 --depth 1 \
    --interpenetrate off -o "$TMP/tiny.sph" >"$TMP/text" 2>&1
core() { # the parameters of core_tb: -GNAME=VALUE of those that it has
    "$SPHAERA" export --hex "$TMP/tiny" "$TMP/tiny.sph" &&
        sed -n '3,4s/^\/\///p' "$TMP/tiny.mem.hex" | grep -oE '[A-Z]+=[0-9]+' | sed 's/^/-G/'
}

# ---- SystemVerilog: Verilator ----
# folder of the RTL, top module, folder, options
bench() {
    rtl=$1 top=$2 to=$3
    shift 3
    # shellcheck disable=SC2046  # words
    "$verilator" --binary --timing -j "${JOBS:-2}" -Wno-fatal -Wno-lint -O1 -CFLAGS -O0 \
        --top-module "$top" -Mdir "$to" "$@" "$root/tb/vip/sphaera_pkg.sv" \
        "$root/examples/verification/$top.sv" \
        $(sed '/^ *\/\//d' rtl/sphaera.f | sed "s,rtl/,$rtl/,") -LDFLAGS \
        "-L$TMP/lib -l:libsphaera.so.$major -Wl,-rpath,$TMP/lib"
}
wrong() { # program, pattern, arguments: it ends badly and says so
    program=$1 pattern=$2
    shift 2
    ! "$program" "$@" >"$TMP/said" 2>&1 && cat "$TMP/said" && has "$pattern" "$TMP/said"
}
sound() { "$@" >"$TMP/said" 2>&1 && cat "$TMP/said" && has '^ok: ' "$TMP/said"; }
cp -r rtl "$TMP/bad"
plant() { python3 -m lab faults edit "$TMP/bad/$1" "$2" "$3"; } # file, from, to
check "a fault of the quotient is planted" plant math/rt_quotient.v \
    "mant_q[MW-1 -: PQ];" "mant_q[MW-1 -: PQ] ^ 1'b1;"
check "... and one of keys" plant prim/rt_sphere_key.v "b + (out_far_o" "b - 1'b1 + (out_far_o"
check "units: built" bench rtl units_tb "$TMP/units"
check "... all are the model's" sound "$TMP/units/Vunits_tb"
check "units with faults: built" bench "$TMP/bad" units_tb "$TMP/units-bad"
check "... and the quotient is named" wrong "$TMP/units-bad/Vunits_tb" '^quotient of .*expected'
# shellcheck disable=SC2046  # words
check "core: built" bench rtl core_tb "$TMP/core" $(core)
check "... two frames are the model's" sound "$TMP/core/Vcore_tb" "+machine=$TMP/tiny.sph"
# shellcheck disable=SC2046  # words
check "core with a fault: built" bench "$TMP/bad" core_tb "$TMP/core-bad" $(core)
check "... its first pixel is shown with the stages of its rays" wrong "$TMP/core-bad/Vcore_tb" \
    'ray 0 primary [|] set-up' "+machine=$TMP/tiny.sph"
check "a machine file that is none" wrong "$TMP/core/Vcore_tb" 'sphaera: .*README.md: ' \
    +machine=README.md

# ---- cocotb in Icarus ----
venv=$BUILD/venv/bus
if [ ! -x "$venv/bin/python" ]; then
    skip "cocotb is absent: make bus-setup"
    done_testing
    exit 0
fi
agent() { # example, folder, RTL: in the environment of make bus-setup
    env PATH="$venv/bin:$PATH" "$venv/bin/python" examples/verification/run.py "$1" \
        "$TMP/tiny.sph" "$2" "$3" >"$TMP/said" 2>&1
    rc=$?
    cat "$TMP/said"
    return $rc
}
check "the package sphaera is there" env B="$BUILD" "$venv/bin/pip" install -q --no-deps \
    --disable-pip-version-check --no-build-isolation --no-index .
bad_agent() { # example, pattern
    ! agent "$1" "$TMP/cocotb-$1-bad" "$TMP/bad" && has "$2" "$TMP/said"
}
check "cocotb, core: frames as the model draws them, every bin met" agent core "$TMP/cocotb-core" \
    rtl
check "... with a fault its pixel is shown with its stages" bad_agent core \
    'ray 0 primary [|] set-up'
check "cocotb, top: a frame as the model draws it, every bin met" agent top "$TMP/cocotb-top" rtl
check "... with a fault its pixel is shown with its stages" bad_agent top 'ray 0 primary [|] set-up'
done_testing
