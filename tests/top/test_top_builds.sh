#!/bin/sh
# test_top_builds.sh - rt_top that builds trees: words, frames, errors, resets, silent buses
# SPDX-License-Identifier: Apache-2.0
# Around the golden model in place of the core every check of rt_top, and those of builds, with
# ALL=1 on buses of 128 and 256 bits too; around the core frames of `make sim TOP=1 BUILD=hw`.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
plain_make() { env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory "$@"; }

shell() { # bits of the buses
    words=$(plain_make B="$BUILD" top-shell) && eval "set -- DATA=$1 $words" || return 1
    set -- -f make/rt_top.mk B="$BUILD" BENCH=tb_shell TREES=64 SEED=1 "$@"
    plain_make "$@" top >"$TMP/made" 2>&1 || { cat "$TMP/made" && return 1; }
    plain_make "$@" run >"$TMP/said" && cat "$TMP/said" &&
        grep -q '^ok .*trees of any spheres.* conditions$' "$TMP/said"
}
plain_make B="$BUILD" "$BUILD"/top/paper5.sph "$BUILD"/top/interpenetrating.sph
for data in 64 ${ALL:+128 256}; do
    check "every check of rt_top, with a builder, $data bits" shell "$data"
done

elaborated() { # parameters of rt_top
    # shellcheck disable=SC2046  # lists of words
    verilator --lint-only --language 1364-2005 --top-module rt_top \
        $(find rtl -name '*.v*' -exec dirname {} + | sort -u | sed 's/.*/-I& -y &/') \
        $(printf ' -G%s' "$@") rtl/top/rt_top.v >"$TMP/said" 2>&1
}
illegal() { # message, parameters
    message=$1
    shift
    ! elaborated "$@" && cat "$TMP/said" && grep -q "$message" "$TMP/said"
}
check "16 spheres are the fewest" elaborated BUILD=16
while read -r message parameters; do
    # shellcheck disable=SC2086  # a list of words
    check "refused: $parameters" illegal "$message" $parameters
done <<'END'
rt_top_BUILD_must_be_0_or_a_power_of_two_of_16_to_65536 BUILD=8
rt_top_BUILD_must_be_0_or_a_power_of_two_of_16_to_65536 BUILD=131072
rt_top_BUILD_must_be_0_or_a_power_of_two_of_16_to_65536 BUILD=48
rt_top_BUILD_excludes_ACCEL_and_BOXES BUILD=64 ACCEL=1 FIRST=0
rt_top_BUILD_excludes_ACCEL_and_BOXES BUILD=64 BOXES=1 FIRST=0
END

simulated() { # words of make
    plain_make B="$BUILD" sim TOP=1 BUILD=hw SIZE=24x16 PROFILE=draft FRAMES=0..3 "$@" \
        >"$TMP/said" && cat "$TMP/said" &&
        grep -q '^ok 1 - every frame equals ' "$TMP/said" &&
        grep -q '^tree by rt_top: ' "$TMP/said" &&
        run=$(sed -n 's/^report in \(.*\)\//\1/p' "$TMP/said")
}
told() { # a sphere is a line: those that moved, and no more, were written
    python3 - "$run/report.json" <<'END'
import json, sys
frames = json.load(open(sys.argv[1]))["frames"]
assert [f["upload_bytes"] for f in frames[1:]] == 3 * [5 * 32], frames
assert all(f["build_cycles"] > 100 for f in frames), frames
END
}
check "frames whose trees rt_top builds" simulated SCENE=moving/orbit STALL=20
check "records that moved were written" told
check "as the schema has it" python3 -W ignore -m jsonschema -i "$run/report.json" \
    docs/reference/report.schema.json
check "background of each frame beside it" simulated SCENE=moving/orbit BACKGROUND=spans
for tree in hw1 hw2; do
    check "frames of tree $tree" simulated SCENE=moving/orbit TREE=$tree
done
refused() { # what is said, words of make
    said=$1
    shift
    plain_make B="$BUILD" sim SIZE=8x6 "$@" >"$TMP/said" 2>&1
    [ $? -ne 0 ] && cat "$TMP/said" && grep -q "$said" "$TMP/said"
}
check "refused: without rt_top" refused 'BUILD=hw: with TOP=1 alone' SCENE=paper5 BUILD=hw
check "refused: another builder" refused 'BUILD=hv: is none of host, hw' SCENE=paper5 TOP=1 BUILD=hv
check "refused: triangles" refused 'tree hw is of spheres' SCENE=facets/room TOP=1 BUILD=hw
check "refused: a tree that it does not build" refused 'with TREE=hw, hw1 or hw2' \
    SCENE=paper5 TOP=1 BUILD=hw TREE=balanced
check "refused: more than it may be built for" refused '70000 spheres, of 65536 at most' \
    SCENE=random:70000 TOP=1 BUILD=hw PROFILE=reference
done_testing
