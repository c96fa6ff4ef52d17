#!/bin/sh
# test_core.sh - whole frames of the RTL core equal the golden model's, in two simulators
# SPDX-License-Identifier: Apache-2.0
#
# Every scene of scenes/ in every profile, in Icarus in the narrowest or the widest, in turn: three
# colours, id, key and visits of each pixel, and the counters; with random memory latency and 30 %
# stalls on every handshake. Then the scenes of tests/hard, EFFECTS at run time, two engines, and
# machines that are broken on purpose. Cores with less than everything: test_effect_scenes.sh.
#   SEED=n        other latencies and stalls (1)
#   ALL=1         every scene in Icarus in both profiles, broken machines in Icarus too
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start core
# Name, list, settings of core.sh, machine, options.
wanted() { case $1 in *"$CORE"*) run "$@" ;; esac }
# Icarus simulates a thousand clocks a second, no more: every second scene in draft, the others and
# what draft refuses in reference.
in_turn() {
    number=$(printf '%s\n' scenes/*.nff | grep -n "/$scene.nff" | cut -d: -f1)
    if [ -f "$machines/$scene-draft-$size.sph" ] && [ $((number % 2)) = 0 ]; then
        [ "$profile" = draft ]
    else
        [ "$profile" = reference ]
    fi
}
# Simulator, size, profiles: every scene.
frames() {
    sim=$1 size=$2
    shift 2
    for profile; do
        for machine in "$machines"/*-"$profile-$size.sph"; do
            scene=$(basename "$machine" "-$profile-$size.sph")
            [ $sim = verilator ] || [ -n "${ALL:-}" ] || in_turn || continue
            wanted "$sim $scene $profile $size" all "SIM=$sim" "$machine"
        done
    done
}
# Exit code, what the last line of output must have, command.
fails_with() {
    want=$1 pattern=$2
    shift 2
    "$@" >"$TMP/out" 2>&1
    [ $? -eq "$want" ] && grep -q "$pattern" "$TMP/out" && rc=0 || rc=1
    tap $rc "$pattern" "$TMP/out"
}
# Name, expected bits, options: the sticky bits are set, every pixel arrives, nothing hangs.
broken() {
    fault=$1 bits=$2
    shift 2
    for sim in verilator ${ALL:+icarus}; do
        wanted "$sim broken: $fault" all "SIM=$sim" "$machines/paper100-draft-8x6.sph" \
            --expect-errors "$bits" --watchdog 20000 "$@"
    done
}

# A profile may refuse a scene, and says which one would do.
for scene in scenes/*.nff; do
    scene_name=$(basename "$scene" .nff)
    for profile in draft standard fine reference; do
        case $profile in
        draft) sizes='32x24 8x6 4x3' ;;
        reference) sizes='32x24 4x3' ;;
        *) sizes=32x24 ;;
        esac
        for size in $sizes; do
            "$SPHAERA" build "$scene" --profile $profile --size $size \
                -o "$machines/$scene_name-$profile-$size.sph" >"$TMP/build" 2>&1 && continue
            check "$scene_name $profile $size: refused with advice" grep 'would do' "$TMP/build"
        done
    done
done

frames verilator 32x24 draft standard fine reference
frames icarus 4x3 draft reference

# Hard cases that are scenes; the one of two equal spheres is refused.
hard=$machines/hard
rm -rf "$hard"
mkdir -p "$hard"
sed -n 's/^scene //p' tests/hard/scenes.nff >"$TMP/scenes"
while read -r scene_name; do
    scene=tests/hard/scenes.nff:$scene_name
    for profile in draft standard fine reference; do
        file=$hard/$scene_name-$profile.sph
        "$SPHAERA" build "$scene" --profile $profile --size 16x12 -o "$file" >"$TMP/build" 2>&1 || {
            check "hard case $scene_name $profile: refused" grep 'the same sphere' "$TMP/build"
            continue
        }
        wanted "verilator hard case $scene_name $profile" all SIM=verilator "$file"
        [ $profile = draft ] || continue
        little=$hard/$scene_name-little.sph
        "$SPHAERA" build "$scene" --profile draft --size 4x3 -o "$little" >"$TMP/build" 2>&1 ||
            check "hard case $scene_name 4x3" cat "$TMP/build"
        wanted "icarus hard case $scene_name" all SIM=icarus "$little"
    done
done <"$TMP/scenes"

# Bits of EFFECTS: 1 shadow, 2 reflect, 4 inside, 8 first, 16 interpenetrate. The paper's tree puts
# spheres into any order, so its first hit is often not the nearest, and pixels start again.
overlap=$machines/overlap-draft
for size in 32x24 5x4; do
    "$SPHAERA" build scenes/interpenetrating.nff --profile draft --tree paper --size $size \
        -o "$overlap-$size.sph" >"$TMP/build" 2>&1 || check "overlap $size" cat "$TMP/build"
done
for bits in 0 3 9 13 15 16 23 28 30 31; do
    for scene in overlap inside paper100 sphereflake2; do
        wanted "verilator effects $bits $scene" all SIM=verilator \
            "$machines/$scene-draft-32x24.sph" --reg 0=$bits
    done
done
for bits in 3 28 31; do
    wanted "icarus effects $bits overlap" all SIM=icarus "$overlap-5x4.sph" --reg 0=$bits
    wanted "icarus effects $bits inside" all SIM=icarus "$machines/inside-draft-4x3.sph" \
        --reg 0=$bits
done
wanted "verilator effects 31 overlap two engines" all ENGINES=2 "$overlap-32x24.sph" --reg 0=31
wanted "verilator sphereflake2 draft two engines" all ENGINES=2 \
    "$machines/sphereflake2-draft-32x24.sph"
# Pipes of an engine with their units, in both simulators: the same pixels and counters.
wanted "verilator sphereflake2 draft four pipes" auto PIPES=4 \
    "$machines/sphereflake2-draft-32x24.sph"
wanted "icarus overlap two pipes, one shading unit" all "SIM=icarus PIPES=2" "$overlap-5x4.sph" \
    --reg 0=31
wanted "icarus inside three pipes" auto "SIM=icarus PIPES=3" "$overlap-5x4.sph"
# Wider beats of memory, and fewer lines on their way.
wanted "verilator sphereflake2 four pipes, beats of 256 bits" auto \
    "PIPES=4 SIZES=mem_data=256" "$machines/sphereflake2-draft-32x24.sph"
wanted "verilator sphereflake2 beats of 128 bits, 16 lines" auto \
    "SIZES=mem_data=128,mem_pending=16" "$machines/sphereflake2-draft-32x24.sph"
wanted "icarus overlap beats of 256 bits, 256 lines" all "SIM=icarus SIZES=mem_data=256" \
    "$overlap-5x4.sph" --reg 0=31
wanted "verilator sphereflake2 standard warm caches" all SIM=verilator \
    "$machines/sphereflake2-standard-32x24.sph" --warm
# Triangles and planes: every profile; two engines; a core without rays inside spheres; lines that
# no machine has, which model and core take in the same way. The spheres above had the same core.
facets=$machines/facets
for profile in draft standard fine reference; do
    "$SPHAERA" build tests/scenes/facets/mixed.nff --profile $profile --size 8x6 --depth 1 \
        --accel bvh4 -o "$facets-$profile.sph" >"$TMP/build" 2>&1 ||
        check "facets $profile" cat "$TMP/build"
    wanted "verilator facets $profile" all SIM=verilator "$facets-$profile.sph"
done
[ -z "${ALL:-}" ] || wanted "icarus facets draft" all SIM=icarus "$facets-draft.sph"
wanted "verilator facets two engines" all ENGINES=2 "$facets-draft.sph"
wanted "verilator facets standard warm caches" all SIM=verilator "$facets-standard.sph" --warm
"$SPHAERA" build scenes/facets/triangles.nff --profile draft --size 4x3 --depth 1 \
    --accel bvh4 -o "$facets-only.sph" >"$TMP/build" 2>&1 ||
    check "facets without spheres" cat "$TMP/build"
wanted "icarus facets without spheres" auto SIM=icarus "$facets-only.sph"
for poke in 2:254:2=3 2:72:24=0 3:240:14=0x3fff; do # line 2, 3: the planes below the root
    wanted "verilator facets poke $poke" all SIM=verilator "$facets-draft.sph" --poke $poke
done
wanted "verilator facets poke mixed kinds" all SIM=verilator "$facets-draft.sph" \
    --poke 2:254:2=0 --poke 3:254:2=1
broken "root is its own child" 4 --poke 0:224:26=0 --reg 29=12
broken "child beyond memory" 1 --poke 0:224:26=0x3ffffff
broken "five children" 1 --poke 0:250:6=0x0c
broken "root beyond memory" 1 --reg 25=0x3ffffff
broken "visits run out" 4 --reg 29=3
broken "records beyond memory" 1 --reg 26=0x3000000
broken "visits of probes run out" 4 --reg 29=3 --reg 0=31
broken "records of probes beyond memory" 1 --reg 26=0x3000000 --reg 0=31
broken "wrong profile" 32 --reg 30=1
# LEFT_OUT: a scene, and by how many scene units its eye moves to see what is left out: a light, a
# shadow, what shadow rays pass, rays inside, a mirror, images and glass, depths, a ball, a
# triangle.
mkdir -p "$machines/met"
while read -r scene x y z; do
    moved=$machines/met/$scene.sph
    "$SPHAERA" build tests/scenes/met.nff:$scene --profile draft --depth 10 --size 16x9 \
        --accel bvh4 -o "$moved" >"$TMP/build" 2>&1 || check "$scene" cat "$TMP/build"
    eye=$("$SPHAERA" info "$moved" | awk -v by="$x $y $z" '
        /^grid/ { split(by, move); sub(/.*\^/, "", $3); step = 2 ^ $3 }
        $2 ~ /^EYE/ { printf " --reg %d=%d", $1, $3 + move[++n] / step }')
    wanted "verilator $scene: its own camera" all SIM=verilator "$moved"
    for sim in verilator icarus; do
        # shellcheck disable=SC2086  # three options on purpose
        wanted "$sim $scene: a camera that would see more" all SIM=$sim "$moved" $eye \
            --expect-errors 64
    done
done <<'END'
light_below 0 -4 0
shadow_behind 0 0 12
clear_behind 0 0 12
inside_behind 0 -5 6
mirror_behind 0 0 8
all_behind 3 -5 15
mirrors_behind 0 0 9
behind 0 0 5
triangle_behind 4 -2.5 12
END
wanted "icarus a mirror left out: its own core" auto SIM=icarus "$machines/met/mirror_behind.sph"
broken "bus error at the first line" 8 --bus-error-at 0
broken "bus error later" 8 --bus-error-at 9

# An answer with an error has data all the same: nobody uses it, and the next frame is whole. The
# second machine has no node but the root. With caches kept, memory may be gone.
lone=$machines/one_sphere-draft-8x6.sph five=$machines/paper5-draft-8x6.sph
for sim in verilator icarus; do
    wanted "$sim no node can be read" all SIM=$sim "$five" --spoil 0
    wanted "$sim no leaf record can be read" all SIM=$sim "$lone" --spoil 1
    wanted "$sim caches kept, no line can be read" all SIM=$sim "$five" --warm --spoil 0
    wanted "$sim a frame behind a bus error" all SIM=$sim "$five" --warm --bus-error-at 0
done
# Memory that ends with the leaf records of the last node, and a line earlier, without mirrors:
# records of primitives are read where nodes are; bit 23 of VISIT_LIMIT.
bush=$machines/bush.sph # some of its rays reach the last leaf
"$SPHAERA" build scenes/paper100.nff --profile draft --tree balanced --size 12x9 -o "$bush" \
    >"$TMP/build" 2>&1 ||
    check "bush" cat "$TMP/build"
leaves_end=$("$SPHAERA" info "$bush" | awk '$2 == "PRIM_BASE" { print $3 }')
wanted "icarus memory ends with a leaf" all SIM=icarus "$bush" --reg 1=0 --reg 26=0 \
    --reg "27=$leaves_end"
wanted "icarus memory ends before a leaf" all SIM=icarus "$bush" --reg 1=0 --reg 26=0 \
    --reg 27=$((leaves_end - 1)) --expect-errors 1
wanted "icarus 2^23 visits allowed" all SIM=icarus "$five" --reg 29=0x800000

# Frames behind frames: two machines without a reset between them, then a reset in each clock of a
# frame, or in some.
for scene in paper5 inside interpenetrating; do
    "$SPHAERA" build scenes/$scene.nff --profile draft --size 3x2 --depth 1 \
        -o "$machines/cut-$scene.sph" >"$TMP/build" 2>&1 || check "cut-$scene" cat "$TMP/build"
done
"$SPHAERA" build tests/scenes/facets/mixed.nff --profile draft --size 3x2 --depth 1 --accel bvh4 \
    -o "$machines/cut-mixed.sph" >"$TMP/build" 2>&1 || check "cut-mixed" cat "$TMP/build"
wanted "verilator paper5, cut off in each clock" all SIM=verilator "$machines/cut-paper5.sph" \
    --life --then "$machines/cut-inside.sph" --latency 2 --stall 5
wanted "verilator interpenetrating, cut off" all SIM=verilator \
    "$machines/cut-interpenetrating.sph" --reg 0=31 --life --cuts 60
wanted "verilator paper5, beats of 128 bits, cut off" auto "SIZES=mem_data=128" \
    "$machines/cut-paper5.sph" --life --cuts 60
wanted "icarus paper5, beats of 128 bits, trials" auto "SIM=icarus SIZES=mem_data=128" \
    "$machines/cut-paper5.sph" --life --trials 6
wanted "verilator facets, cut off" all SIM=verilator "$machines/cut-mixed.sph" \
    --life --then "$machines/cut-paper5.sph" --cuts 60
for clock in 75 98 131:2 187 264:3; do
    wanted "icarus paper5, cut off in clock $clock" all SIM=icarus "$machines/cut-paper5.sph" \
        --reset-at $clock --latency 2
done

# Widths of its own, each knob once; the core is built with what the scene asks for.
for knob in w=14,fw=9 wd=19,pr=12 pq=11,ng=0; do
    file=$machines/turned-$knob.sph
    "$SPHAERA" build scenes/inside.nff --profile standard:$knob --size 32x24 -o "$file" \
        >"$TMP/build" 2>&1 || check "standard:$knob" cat "$TMP/build"
    wanted "verilator inside standard:$knob" auto SIM=verilator "$file"
done
short=$machines/short.sph
"$SPHAERA" build scenes/interpenetrating.nff --profile draft:wd=14,ng=1,pr=7 --size 16x12 \
    -o "$short" >"$TMP/build" 2>&1 || check "draft:wd=14,ng=1,pr=7" cat "$TMP/build"
wanted "icarus interpenetrating draft:wd=14,ng=1,pr=7" auto SIM=icarus "$short"

# Other bits a clock: the same frame and counters, other cycles.
"$SPHAERA" build scenes/paper5.nff --profile draft --size 8x6 -o "$machines/steps.sph" \
    >"$TMP/build" 2>&1 || check "steps" cat "$TMP/build"
for steps in "ROOT_STEP=1 QUOTIENT_STEP=2" "ROOT_STEP=5 QUOTIENT_STEP=2" \
    "ROOT_STEP=1 QUOTIENT_STEP=1"; do
    wanted "icarus paper5 $steps" auto "SIM=icarus $steps" "$machines/steps.sph"
done

build_cores
run_all
judge

cycles() { # steps: cycles of the same stimulus
    env BUILT=1 EFFECTS=auto SIM=icarus "$@" sh sim/core.sh --machine "$machines/steps.sph" |
        sed -n 's/^core .* 0 mismatches; cold caches: \([0-9]*\) cycles.*/\1/p'
}
fewer() { echo "$1 $2" && [ "$1" -gt 0 ] && [ "$1" -lt "$2" ]; }
[ -n "$CORE" ] || {
    usual=$(cycles ROOT_STEP=1 QUOTIENT_STEP=2)
    check "roots of 5 bits a clock take fewer cycles" fewer \
        "$(cycles ROOT_STEP=5 QUOTIENT_STEP=2)" "$usual"
    check "quotients of 1 bit a clock take more" fewer "$usual" \
        "$(cycles ROOT_STEP=1 QUOTIENT_STEP=1)"
}

# Two profiles without a name, the machine of one on the core of the other.
[ -n "$CORE" ] || for built in "$BUILD"/sim/standard_pq11_ng0-*-O0/tb_core; do
    fails_with 3 "refused: the core sets wrong_profile and gives no pixel; the machine was built \
for profile standard:wd=19,pr=12" "$built" --machine "$machines/turned-wd=19,pr=12.sph"
done
done_testing
