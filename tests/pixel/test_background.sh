#!/bin/sh
# test_background.sh - frames of the core equal the model's in every way of background separation
# SPDX-License-Identifier: Apache-2.0
#
# Every profile, windows at no multiple of 8, two engines, warm caches, the eye inside of the root
# sphere, a hyperbola, cores of one way alone, tables that are not in memory or answer with an
# error; with random memory latency and 30 % stalls on every handshake.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start background
wanted() { case $1 in *"$CORE"*) run "$@" ;; esac }
# Name, scene, options.
machine() {
    file=$machines/$1.sph scene=$2
    shift 2
    check "$(basename "$file"): builds" "$SPHAERA" build "$scene" "$@" -o "$file"
}

ways="rect spans exact"
flake=scenes/sphereflake2.nff
for profile in draft standard fine reference; do
    for way in $ways; do
        machine "$way-$profile" $flake --profile $profile --size 33x25 --background "$way"
        wanted "verilator $way $profile" all SIM=verilator "$machines/$way-$profile.sph"
    done
done
for way in $ways; do
    file=$machines/$way-draft.sph
    for window in 0,0,33,25 3,5,31,22 9,7,10,8 8,8,24,16 32,0,33,25 0,24,33,25; do
        wanted "verilator $way window $window" all SIM=verilator "$file" --window $window
    done
    wanted "verilator $way warm" all SIM=verilator "$file" --warm
    wanted "verilator $way two engines" all ENGINES=2 "$file"
    wanted "icarus $way alone" auto SIM=icarus "$file" --window 5,3,21,14
    machine "$way-inside" scenes/inside.nff --profile draft --size 33x25 --background "$way"
    machine "$way-beside" tests/scenes/background/beside.nff --profile draft --background "$way"
    wanted "verilator $way inside" all SIM=verilator "$machines/$way-inside.sph"
    wanted "verilator $way beside" all SIM=verilator "$machines/$way-beside.sph"
done
machine levels1 $flake --profile draft --size 33x25 --background exact --bg-levels 1
machine levels2 $flake --profile draft --size 33x25 --background exact --bg-levels 2
wanted "icarus exact, level 1" auto SIM=icarus "$machines/levels1.sph" \
    --window 9,7,26,18
wanted "icarus exact, level 2, two engines" auto "SIM=icarus ENGINES=2" "$machines/levels2.sph" \
    --window 9,7,26,18

# Tables that are not in memory: BAD_NODE, and every pixel is traced. A bus error on their first
# line (the second line asked for is the root's, or of the table too): BUS_ERROR, the frame ends.
for way in spans exact; do
    file=$machines/$way-draft.sph
    for sim in verilator icarus; do
        wanted "$sim $way beyond memory" all SIM=$sim "$file" --expect-errors 1 \
            --reg 97=0x3fffff0 --window 0,0,17,9
        wanted "$sim $way bus error" all SIM=$sim "$file" --expect-errors 8 --bus-error-at 0 \
            --watchdog 20000 --window 0,0,17,9
    done
done

build_cores
run_all
judge
done_testing
