#!/bin/sh
# test_core_bih.sh - frames of the RTL core with a BIH equal the golden model's
# SPDX-License-Identifier: Apache-2.0
#
# Colours, id, key and visits of each pixel, and the counters, of a core built with ACCEL = 1; in
# Verilator and Icarus, with random memory latency and 30 % stalls: every scene of scenes/,
# triangles and planes, leaves of one primitive and of all, every profile, two engines, textures,
# trees and registers that are broken on purpose, machines for the other kind of core.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start core_bih
every="--profile draft --accel bih" # what a run asks for itself counts more
mixed=tests/scenes/facets/mixed.nff
for scene in scenes/*.nff; do
    [ "$scene" != scenes/huge_tiny.nff ] || continue # not in this profile
    machine "$(basename "$scene" .nff)" "$scene" --size 24x18
    wanted "verilator $scene" all SIM=verilator "$(basename "$scene" .nff)"
done
machine ones scenes/sphereflake2.nff --size 24x18 --max-prims 1
machine threes scenes/sphereflake2.nff --size 24x18 --max-prims 3 --bih listing
machine flat scenes/sphereflake2.nff --size 12x9 --max-prims infinity
machine brute scenes/paper5.nff --size 16x12 --accel brute
machine mixed $mixed --size 8x6 --depth 1
machine mixed-ones $mixed --size 8x6 --depth 1 --max-prims 1
machine mixed-brute $mixed --size 4x3 --depth 1 --accel brute
machine triangles scenes/facets/triangles.nff --size 5x4 --depth 1
machine balls tests/scenes/texture/balls.nff --size 5x4
machine small scenes/sphereflake2.nff --size 10x7 --depth 1
machine simple scenes/paper100.nff --size 10x7 --depth 0 --lights 0
for profile in standard fine reference; do
    machine small-$profile scenes/sphereflake2.nff --profile $profile --size 8x6 --depth 1
    machine mixed-$profile $mixed --profile $profile --size 3x2 --depth 1
done
machine wide scenes/paper100.nff --profile standard:w=14,wd=21,pr=12 --size 5x4
machine four scenes/paper5.nff --accel bvh4 --size 16x12

for name in ones threes flat brute mixed mixed-ones mixed-brute triangles; do
    wanted "verilator $name" all SIM=verilator $name
done
wanted "verilator paper100, caches kept" all SIM=verilator paper100 --warm
wanted "icarus sphereflake2, two engines" auto "SIM=icarus ENGINES=2" small
wanted "icarus sphereflake2, three pipes" auto "SIM=icarus PIPES=3" small
wanted "icarus primary rays alone" auto SIM=icarus simple
wanted "icarus textures" auto SIM=icarus balls
wanted "icarus standard:w=14,wd=21,pr=12" auto SIM=icarus wide
for profile in standard fine reference; do
    wanted "icarus sphereflake2 $profile" auto SIM=icarus small-$profile
    wanted "icarus facets $profile" auto SIM=icarus mixed-$profile
done

# The root of ones is an inner node, the first leaf of mixed has planes in front of it.
broken() { # what, expected bits, machine, options
    what=$1 bits=$2 on=$3
    shift 3
    wanted "verilator broken: $what" all SIM=verilator "$on" --expect-errors "$bits" \
        --watchdog 20000 "$@"
}
broken "child beyond memory" 1 ones --poke 0:0:29=0x1fffffff
broken "root is its own child" 4 ones --poke 0:0:29=0 --reg 29=40
broken "more siblings than the stack holds" 2 ones --reg 29=100 --poke 0:0:32=0 \
    --poke 0:32:32=0x1fff --poke 0:64:32=0x2000 # its left child is itself, and all is in both
broken "leaf beyond the records" 1 brute --poke 0:64:32=6
broken "leaf of 2^32-1 records" 1 brute --poke 0:64:32=0xffffffff
broken "root beyond memory" 1 ones --reg 25=0x3ffffff
broken "records beyond memory" 1 ones --reg 104=0x3fffff0
broken "more planes than records" 1 mixed --reg 105=0xffffff
broken "visits run out" 4 ones --reg 29=3
broken "bus error at the first line" 8 ones --bus-error-at 0
broken "bus error later" 8 ones --bus-error-at 9

# Answers with an error, memory that is gone, resets: see test_core.sh.
machine cut scenes/sphereflake2.nff --size 3x2 --depth 1
machine five scenes/paper5.nff --size 16x12
wanted "verilator no node can be read" all SIM=verilator five --spoil 0
wanted "verilator caches kept, no line can be read" all SIM=verilator five --warm --spoil 0
wanted "verilator a frame behind a bus error" all SIM=verilator five --warm --bus-error-at 0
wanted "verilator cut off" all SIM=verilator cut --life --then "$machines/five.sph" --cuts 40

build_cores
run_all
judge

[ -n "$CORE" ] || {
    check "a core for nodes of four refuses a BIH" refused shadow+reflect5+lights8+inside paper5
    check "a core with a BIH refuses nodes of four" refused shadow+reflect5+lights8+inside+bih four
    check "first does not go with bih" sh -c '! sim/cores.py parameters first+bih'
}
done_testing
