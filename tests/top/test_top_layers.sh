#!/bin/sh
# test_top_layers.sh - rt_top with layers: Rendering, L1 and L2 stored side by side, shown by MUX
# SPDX-License-Identifier: Apache-2.0
# Around the golden model in place of the core every check of rt_top, and those of layers, with
# ALL=1 on buses of 128 bits too; around the core frames of `make sim TOP=1 LAYERS=1`.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
plain_make() { env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory "$@"; }

shell() { # bits of the buses
    words=$(plain_make B="$BUILD" top-shell) && eval "set -- DATA=$1 $words" || return 1
    set -- -f make/rt_top.mk B="$BUILD" BENCH=tb_shell LAYERS=1 SEED=1 "$@"
    plain_make "$@" top >"$TMP/made" 2>&1 || { cat "$TMP/made" && return 1; }
    plain_make "$@" run >"$TMP/said" && cat "$TMP/said" &&
        grep -q '^ok .*layers shown.* conditions$' "$TMP/said"
}
plain_make B="$BUILD" "$BUILD"/top/paper5.sph "$BUILD"/top/interpenetrating.sph
for data in 64 ${ALL:+128}; do
    check "every check of rt_top, with layers, $data bits" shell "$data"
done

simulated() {
    plain_make B="$BUILD" sim TOP=1 LAYERS=1 SCENE=moving/orbit SIZE=24x16 PROFILE=draft \
        FRAMES=0..1 STALL=20 >"$TMP/said" && cat "$TMP/said" &&
        grep -q '^ok 1 - Rendering, L1 and L2 of every frame equal ' "$TMP/said" &&
        run=$(sed -n 's/^report in \(.*\)\//\1/p' "$TMP/said")
}
differ() { # what the store holds of a frame: the machine shows its deepest
    set -- "$run/rendering-$1.ppm" "$run/l1-$1.ppm" "$run/l2-$1.ppm" "$run/shown-$1.ppm"
    ! cmp -s "$1" "$2" && ! cmp -s "$2" "$3" && ! cmp -s "$1" "$3" && cmp "$3" "$4"
}
page() { [ "$(grep -o '<figcaption>' "$run/report.html" | wc -l)" = 3 ]; }
check "two frames, each of their layers as the golden model has it" simulated
check "the layers of a frame are three pictures" differ 0000
check "so are those of the next" differ 0001
check "the report shows them" page
refused() { # words of make
    plain_make B="$BUILD" sim SCENE=paper5 SIZE=8x6 "$@" >"$TMP/said" 2>&1
    [ $? -eq 2 ] && cat "$TMP/said" && grep -q LAYERS "$TMP/said"
}
check "layers without rt_top are refused" refused LAYERS=1
check "two of them too" refused TOP=1 LAYERS=2
done_testing
