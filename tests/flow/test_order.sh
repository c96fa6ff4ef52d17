# test_order.sh - a traversal order of one's own: the example of docs/design/extending.md
# SPDX-License-Identifier: Apache-2.0
#
# In a copy of the tree examples/order/far_first.patch changes two files. There the literal model,
# the fast one and the RTL agree, its bench too, and a sweep tells what the order is worth beside
# that of the tree as it is.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD tool=$(realpath "${SPHAERA:-${BUILD:-build}/sphaera}")
export CCACHE_BASEDIR="$root"
copy=$TMP/copy
mkdir -p "$copy" && cp -r Makefile VERSION cmodel driver examples lab make rtl scenes sim \
    synth tb tests "$copy" || exit 1
cd "$copy" || exit 1
unset BUILD SPHAERA TESTING # of the tree
plain() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u SPHAERA_JOBS "$@"; }

check "the patch fits" patch -p1 -i examples/order/far_first.patch
check "... and changes two files" [ "$(grep -c '^+++ ' examples/order/far_first.patch)" = 2 ]
check "the tool" plain make tool -j"${JOBS:-2}" CFLAGS="-std=c11 -D_GNU_SOURCE -O1 -Icmodel" \
    CXXFLAGS="-std=c++17 -O0 -Icmodel"
own=$copy/build/sphaera

drawn() { # tool, file, options: the picture and the work, as counted
    t=$1 to=$2
    shift 2
    "$t" render "$@" --size 48x27 --json "$TMP/json" >"$TMP/log" 2>&1 &&
        sed -n '/"frame": {/,/}/p; /"counters": {/,/}/p' "$TMP/json" >"$TMP/$to"
}
same() { cmp "$TMP/$1" "$TMP/$2"; }
pictures() { sed -n '/picture_hash/p' "$TMP/$1" >"$TMP/p1" &&
    sed -n '/picture_hash/p' "$TMP/$2" | cmp - "$TMP/p1" && [ -s "$TMP/p1" ]; }
for scene in random:1000 balls:3 scenes/facets/room.nff; do
    check "$scene: as it is" drawn "$tool" before "$scene"
    check "... far children first" drawn "$own" after "$scene"
    check "... the picture is the same" pictures before after
    check "... the work is another" sh -c "! cmp '$TMP/before' '$TMP/after'"
    check "... the literal model has the same" drawn "$own" literal "$scene" --literal
    check "... byte by byte" same after literal
done

# ---- the RTL: frames of spheres and of boxes, and the bench, which knows the model alone ----
rtl() { # command line of make sim: mismatches
    plain make sim SIM=icarus SIZE=12x9 PROFILE=standard "$@" >"$TMP/log" 2>&1
    tail -n 30 "$TMP/log"
    grep -o ' 108 pixels, [0-9]* mismatches' "$TMP/log" >"$TMP/mismatches"
}
agrees() { rtl "$@" && grep -q ' 0 mismatches' "$TMP/mismatches"; }
differs() { rtl "$@" && ! grep -q ' 0 mismatches' "$TMP/mismatches"; }
check "the RTL draws what the model does, in spheres" agrees SCENE=balls:3 ACCEL=bvh4
check "... in boxes" agrees SCENE=facets/room ACCEL=box4
check "the bench of rt_traverse" plain python3 -m lab benches tb_traverse/standard 1 3000
cp "$root/rtl/trace/rt_traverse.v" rtl/trace/rt_traverse.v
check "the RTL as it was is noticed" differs SCENE=balls:3 ACCEL=bvh4

# ---- what it is worth ----
check "a sweep as it is" plain RESULTS="$TMP/r1" "$tool" sweep "$root/examples/order/sweep.txt" \
    --size 24x14 --out "$TMP/before_sweep"
check "... and with the order, beside it" sh -c "env -u MAKEFLAGS -u MFLAGS -u SPHAERA_JOBS \
    RESULTS='$TMP/r2' '$own' sweep examples/order/sweep.txt --size 24x14 \
    --beside '$TMP/before_sweep/sweep.csv' --out '$TMP/after_sweep' >'$TMP/said' 2>&1 &&
    cat '$TMP/said' && grep -qE '^balls:3 .* [01][.][0-9]{3}$' '$TMP/said'"
done_testing
