#!/bin/sh
# test_core.sh - whole frames of the RTL core equal the golden model's, in two simulators
# SPDX-License-Identifier: Apache-2.0
#
# Every scene of scenes/ in every profile: three colours, id, key and visits of each pixel, and the
# counters; with random memory latency and 30 % stalls on every handshake. Then two engines, cores
# with only the scene's effects, and machines that are broken on purpose.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/tap.sh"
cd "$(dirname "$0")/.." || exit 1
SEED=${SEED:-1}
BUILD=${BUILD:-build}
CORE=${CORE:-}
export BUILD OPT=-O1 JOBS=1
echo "# SEED=$SEED; one run again: SEED=$SEED CORE=NAME make test ONLY=test_core"

machines=$BUILD/test/core
runs=$TMP/runs
mkdir -p "$machines"
: >"$runs"
# Notes a run: name, settings of core.sh, machine, options. Latency 1 to 60, by seed and name.
run() {
    case $1 in *"$CORE"*) ;; *) return ;; esac
    seed=$(($(printf '%s' "$1 $SEED" | cksum | cut -d' ' -f1) % 100000))
    label=$1 settings=$2 machine=$3
    shift 3
    echo "$label|env $settings sh sim/core.sh --machine $machine|--seed $seed" \
        "--latency $((seed % 60 + 1)) --stall 30 $*" >>"$runs"
}
# Simulator, size, settings, profiles: every scene.
frames() {
    sim=$1 size=$2 effects=$3
    shift 3
    for profile; do
        for machine in "$machines"/*-"$profile-$size.sph"; do
            scene=$(basename "$machine" "-$profile-$size.sph")
            run "$sim $scene $profile $size $effects" "SIM=$sim EFFECTS=$effects" "$machine"
        done
    done
}
# Name, expected bits, options: the sticky bits are set, every pixel arrives, nothing hangs.
broken() {
    fault=$1 bits=$2
    shift 2
    for sim in verilator icarus; do
        run "$sim broken: $fault" "SIM=$sim EFFECTS=all" "$machines/paper100-draft-16x12.sph" \
            --expect-errors "$bits" --watchdog 20000 "$@"
    done
}

# A profile may refuse a scene, and says which one would do.
rm -f "$machines"/*.sph
for scene in scenes/*.nff; do
    scene_name=$(basename "$scene" .nff)
    for profile in draft standard fine reference; do
        for size in 32x24 16x12; do
            "$SPHAERA" build "$scene" --profile $profile --size $size \
                -o "$machines/$scene_name-$profile-$size.sph" >"$TMP/build" 2>&1 && continue
            check "$scene_name $profile $size: refused with advice" grep 'would do' "$TMP/build"
        done
    done
done

frames verilator 32x24 all draft standard fine reference
frames icarus 32x24 all draft
frames icarus 16x12 all standard fine reference
frames verilator 32x24 auto draft
run "verilator sphereflake2 draft two engines" "EFFECTS=all ENGINES=2" \
    "$machines/sphereflake2-draft-32x24.sph"
run "verilator sphereflake2 standard warm caches" EFFECTS=all \
    "$machines/sphereflake2-standard-32x24.sph" --warm
broken "root is its own child" 4 --poke 0:224:26=0 --reg 29=12
broken "child beyond memory" 1 --poke 0:224:26=0x3ffffff
broken "five children" 1 --poke 0:250:6=0x0c
broken "root beyond memory" 1 --reg 25=0x3ffffff
broken "visits run out" 4 --reg 29=3
broken "records beyond memory" 1 --reg 26=0x3000000
broken "wrong profile" 32 --reg 30=1
run "verilator broken: missing effects" EFFECTS=auto "$machines/empty-draft-32x24.sph" --reg 0=3 \
    --expect-errors 16
broken "bus error at the first line" 8 --bus-error-at 0
broken "bus error later" 8 --bus-error-at 9

# Numbered commands from stdin, two at a time; leaves NUMBER.log and NUMBER.rc in $TMP.
two_at_a_time() {
    # shellcheck disable=SC2016  # expanded by the inner shell
    awk '{ print NR "|" $0 }' | tr '\n' '\0' | xargs -0 -P 2 -I COMMAND sh -c '
        number=${1%%|*}
        sh -c "${1#*|}" >"$TMP/$number.log" 2>&1
        echo $? >"$TMP/$number.rc"' sh COMMAND
}
# One machine of each profile and set of effects builds its core: --info simulates nothing.
while IFS='|' read -r name command options; do
    profile=$(echo "$command" | sed 's/.*-\([a-z]*\)-[0-9x]*\.sph.*/\1/')
    machine=${command##* }
    effects=$("$SPHAERA" info "$machine" | awk '$2 == "EFFECTS" { print $3 }')
    echo "${command%% --machine*} $profile $effects|$command --info"
done <"$runs" | sort -t'|' -k1,1 -u | cut -d'|' -f2 | two_at_a_time
rm -f "$TMP"/*.rc
cut -d'|' -f2- "$runs" | tr '|' ' ' | two_at_a_time
number=0
while IFS='|' read -r name command options; do
    number=$((number + 1))
    echo "repeat: BUILD=$BUILD OPT=$OPT $command $options" >>"$TMP/$number.log"
    [ "$(cat "$TMP/$number.rc" 2>/dev/null)" = 0 ] &&
        grep -q '^core .* pixels, 0 mismatches, ' "$TMP/$number.log" && rc=0 || rc=1
    tap $rc "$name: $(sed -n 's/^core [^:]*: \(.*cycles\), .*/\1/p' "$TMP/$number.log")" \
        "$TMP/$number.log"
done <"$runs"
done_testing
