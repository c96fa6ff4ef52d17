#!/bin/sh
# test_stages.sh - rays followed stage by stage: the core's lines are the model's, word for word
# SPDX-License-Identifier: Apache-2.0
#
# Pixels of scenes with spheres, mirrors, insides, triangles, planes, textures, refraction, over
# every kind of tree, with several engines and pipes, random latency and stalls. Then faults in
# copies of the RTL, one a stage, of which the first line that differs is of that stage.
#   CORE=pattern  only the frames and faults whose name has the pattern in it
#   ALL=1         every core, and a fault in each stage, not in every other one
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
SEED=${SEED:-1} BUILD=${BUILD:-build} CORE=${CORE:-}
export BUILD OPT=-O0 JOBS=1

machine() { # NAME SCENE OPTION...
    file=$TMP/$1.sph scene=$2
    shift 2
    "$SPHAERA" build "$scene" --size 16x12 --profile draft --accel bvh4 \
        "$@" -o "$file" >"$TMP/said" 2>&1
}
followed() { # SETTINGS MACHINE PIXEL: model and RTL agree
    # shellcheck disable=SC2086  # settings
    env $1 sh sim/core.sh --machine "$TMP/$2.sph" --latency $((SEED % 60 + 9)) --stall 30 \
        --seed "$SEED" --pixel "$3" >"$TMP/log" 2>&1 || { cat "$TMP/log" && return 1; }
    sed -n 's/^ray [0-9]* [a-z]* | \([a-z-]*\) .*/\1/p; s/^\(pixel\) .*/\1/p' "$TMP/log" \
        >>"$TMP/stages"
    grep -E "^[0-9]+ lines of pixel $3: model and RTL agree$4\$" "$TMP/log"
}
frame() { # NAME SETTINGS PIXEL...
    case $1 in *"$CORE"*) ;; *) return ;; esac
    frame=$1 settings=$2
    shift 2
    for pixel; do
        check "$frame ($settings): pixel $pixel" followed "$settings" "$frame" "$pixel" ""
    done
}

also() { [ -z "${ALL:-}${CORE:-}" ] || frame "$@"; }

glass=tests/scenes/refraction/glass.nff mixed=tests/scenes/refraction/mixed.nff
room=scenes/facets/room.nff
machine glass $glass --depth 6
machine mixed $mixed --depth 4
machine inside scenes/inside.nff --depth 3
machine triangles tests/scenes/facets/mixed.nff
machine plane scenes/facets/plane.nff
machine textures tests/scenes/texture/balls.nff
machine smooth scenes/effects/effects.nff:smooth
machine first scenes/interpenetrating.nff --traverse first
machine boxes $room --accel box4 --depth 1
machine bih $room --accel bih --depth 1
machine cut $mixed --profile draft:pr=9
machine wide $mixed --profile reference --size 8x6
machine plain scenes/paper5.nff --depth 0
: >"$TMP/stages"
every=all+reflect10+texture+refract+specular+sum+spread
frame glass EFFECTS=$every 5,5 11,4
frame mixed EFFECTS=$every 8,6 11,4
frame inside EFFECTS=$every 8,6
frame textures EFFECTS=$every 8,6 4,8
frame first EFFECTS=$every 8,6 10,5
also triangles "EFFECTS=auto PIPES=4" 8,6 5,9
frame textures "EFFECTS=auto ENGINES=2 PIPES=2 SHADES=2" 5,9
frame plane EFFECTS=auto 5,11
also smooth EFFECTS=auto 8,6
frame boxes EFFECTS=auto 4,10
frame bih EFFECTS=auto 4,10
also cut EFFECTS=auto 3,2
also wide EFFECTS=auto 4,3
# A core without reflections rounds a colour as it is made.
case plain in *"$CORE"*)
    check "plain: what a core has no wire for is told" \
        followed EFFECTS=auto plain 8,6 ", 1 are the model's alone"
    check "... in its line" grep -E '^ray 0 primary \| colour .*  \(model only\)$' "$TMP/log" ;;
esac
[ -n "$CORE" ] || {
    # The rows of the table in stages_text.c.
    sed -n 's/.*\[SPH_STAGE_[A-Z]*\] = {"\([^"]*\)".*/\1/p' cmodel/core/stages_text.c |
        sort >"$TMP/all"
    sort -u "$TMP/stages" >"$TMP/met"
    check "every stage was met" diff "$TMP/all" "$TMP/met"
}

# ---- the page has what is printed ----
told() {
    "$SPHAERA" build scenes/one_sphere.nff --size 16x12 --profile draft -o "$TMP/one.sph" &&
        "$SPHAERA" info "$TMP/one.sph" --pixel 8,6 --stages >"$TMP/lines" &&
        grep -E '^(ray [0-9]|pixel  )' docs/guide/simulation.md >"$TMP/page" &&
        [ "$(wc -l <"$TMP/page")" -gt 8 ] && ! grep -vxFf "$TMP/lines" "$TMP/page"
}
case page in *"$CORE"*) check "the page has lines as they are printed" told ;; esac

# ---- a fault in the RTL: the first line that differs is of its stage ----
machine paper5 scenes/paper5.nff --profile standard
noticed() { # STAGE FILE FROM TO
    rm -rf "$TMP/rtl" "$TMP/build"
    mkdir -p "$TMP/build/sim"
    cp -R rtl "$TMP/rtl"
    cp -al "$BUILD/sim/obj" "$BUILD/sim/tb_core_icarus" "$TMP/build/sim/"
    cp -al "$BUILD/libsphaera.a" "$TMP/build/"
    python3 -m lab faults edit "$TMP/rtl/$2" "$3" "$4" || return 1
    BUILD=$TMP/build BUILT=tools RTL=$TMP/rtl EFFECTS=auto sh sim/core.sh \
        --machine "$TMP/paper5.sph" --stall 30 --seed "$SEED" --pixel 8,6 >"$TMP/log" 2>&1
    [ $? = 1 ] || { cat "$TMP/log" && return 1; }
    grep -A 2 '^stages of pixel 8,6, the first that differs:$' "$TMP/log" >"$TMP/first"
    cat "$TMP/first"
    grep -q "^  model: ray 0 primary | $1 " "$TMP/first" &&
        grep -q "^  core:  ray 0 primary | $1 " "$TMP/first"
}
more() { [ -z "${ALL:-}${CORE:-}" ] || fault "$@"; }
fault() {
    case "fault $1" in
    *"$CORE"*) check "a fault in $2 is seen at its stage, $1" noticed "$@" ;;
    esac
}
more set-up trace/rt_setup.v "ray_a_q <= s4_vv_q;" "ray_a_q <= s4_vv_q ^ 34'd1;"
fault filter trace/rt_filter.v "s6_p_q <= s5_p_q[17-F +: MW] ^ {MW{s5_p_q[33]}};" \
    "s6_p_q <= s5_p_q[17-F +: MW] ^ {MW{!s5_p_q[33]}};"
more sphere prim/rt_leaf_two.v "val_q <= xy_sum[VW:1];" \
    "val_q <= xy_sum[VW:1] ^ {{(VW-1){1'b0}}, xy_sub};"
fault key prim/rt_sphere_key.v "b + (out_far_o" "b - 1'b1 + (out_far_o"
more quotient math/rt_quotient.v "mant_q[MW-1 -: PQ];" "mant_q[MW-1 -: PQ] ^ 17'd1;"
more point shade/rt_hit.v "{s4_org[KB:1], 1'b1}" "{s4_org[KB:1], 1'b0}"
more normal shade/rt_hit.v ".out_x_o(out_normal_x_o), .out_y_o(out_normal_y_o)" \
    ".out_x_o(out_normal_y_o), .out_y_o(out_normal_x_o)"
more light shade/rt_lambert.v "+ 21'sd1;" "+ 21'sd3;"
fault colour shade/rt_blend.v "s2_ax_q[24:6] + 19'd1;" "s2_ax_q[24:6] + 19'd9;"

# ---- what cannot be followed ----
refused() { # CODE PATTERN OPTION...
    code=$1 pattern=$2
    shift 2
    "$BUILD/sim/tb_core_icarus" --machine "$TMP/paper5.sph" "$@" >"$TMP/said" 2>&1 && rc=0 || rc=$?
    cat "$TMP/said"
    [ $rc = "$code" ] && grep -q -- "$pattern" "$TMP/said"
}
[ -n "$CORE" ] || {
    check "Icarus shows no stages" refused 2 "--pixel 3,4: only a core in Verilator" --pixel 3,4
    hang() {
        EFFECTS=auto sh sim/core.sh --machine "$TMP/paper5.sph" --pixel 8,6 \
            --window 8,6,9,7 --max-cycles 240 >"$TMP/said" 2>&1
        [ $? = 4 ] && grep -q '^ray 0 primary | hit ' "$TMP/said" &&
            grep -A 2 ', the first that differs:$' "$TMP/said" | grep '^  core:  no such line$'
    }
    check "a core that hangs has told how far it came" hang
    check "no pixel" refused 64 "pixel wants X,Y, got '3'" --pixel 3
    check "a pixel outside" sh -c "sh sim/core.sh --machine '$TMP/paper5.sph' --pixel 16,4 2>&1 |
        grep 'pixel 16,4: lies outside of what is drawn, 0,0,16,12'"
    check "not with TOP=1" sh -c "make sim TOP=1 PIXEL=3,4 2>&1 | grep '^PIXEL=3,4: not with TOP=1'"
}
done_testing
