#!/bin/sh
# test_core_boxes.sh - frames of the RTL core whose nodes are four boxes equal the golden model's
# SPDX-License-Identifier: Apache-2.0
#
# Colours, id, key and visits of each pixel, and the counters, of cores built with BOXES = 1, with
# random memory latency and 30 % stalls: spheres, triangles and planes, every profile, two engines,
# textures, refraction, trees that are broken on purpose, machines for the other kind of core.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start core_boxes
every="--profile draft --accel box4" # what a run asks for itself counts more
mixed=tests/scenes/facets/mixed.nff
machine mixed $mixed --size 12x9 --depth 1
# Icarus simulates a thousand clocks a second, of four pipes a third of that
machine little $mixed --size 5x4 --depth 1
machine tiny $mixed --size 3x2 --depth 1
machine small scenes/sphereflake2.nff --size 5x4 --depth 1
machine balls tests/scenes/texture/balls.nff --size 3x2
machine optics tests/scenes/refraction/mixed.nff --size 2x1 --depth 2
for profile in standard fine reference; do
    machine mixed-$profile $mixed --profile $profile --size 3x2 --depth 1
done
machine wide scenes/paper100.nff --profile standard:w=14,wd=21,pr=12 --size 5x4
machine four scenes/paper5.nff --accel bvh4 --size 16x12
machine paper5 scenes/paper5.nff --size 16x12
machine turned $mixed --size 5x4 --depth 1 --axes scene
machine fine $mixed --size 3x2 --depth 1 --axes scene --profile fine

wanted "verilator mixed" auto SIM=verilator mixed
wanted "icarus mixed" auto SIM=icarus little
wanted "icarus sphereflake2, two engines" auto "SIM=icarus ENGINES=2" small
wanted "icarus sphereflake2, four pipes, units of their own" auto \
    "SIM=icarus PIPES=4 LEAF_UNITS=4 SHADES=4" small
wanted "icarus mixed, two engines of two pipes" auto "SIM=icarus ENGINES=2 PIPES=2" tiny
wanted "icarus textures, three pipes" auto "SIM=icarus PIPES=3" balls
wanted "icarus refraction, four pipes" auto "SIM=icarus PIPES=4 LEAF_UNITS=1 SHADES=2" optics
wanted "icarus textures" auto SIM=icarus balls
wanted "icarus a turned grid" auto SIM=icarus turned
wanted "icarus a turned grid, fine" auto SIM=icarus fine
wanted "icarus the camera's axes in a core for any" \
    shadow+reflect1+lights2+inside+facets+turned+boxes SIM=icarus little
wanted "icarus refraction" auto SIM=icarus optics
wanted "icarus standard:w=14,wd=21,pr=12" auto SIM=icarus wide
for profile in standard fine reference; do
    wanted "icarus facets $profile" auto SIM=icarus mixed-$profile
done

broken() { # what, expected bits, options
    what=$1 bits=$2
    shift 2
    wanted "icarus broken: $what" auto SIM=icarus little --expect-errors "$bits" \
        --watchdog 20000 "$@"
}
broken "child beyond memory" 1 --poke 0:224:26=0x3ffffff
broken "five children" 1 --poke 0:250:3=5
broken "visits run out" 4 --reg 29=1
broken "bus error at the first line" 8 --bus-error-at 0

build_cores
run_all
judge

[ -n "$CORE" ] || {
    check "a core for spheres refuses boxes" refused shadow+reflect5+lights8+inside paper5
    check "a core for the camera's axes refuses others" refused \
        shadow+reflect5+lights8+inside+facets+boxes turned
    check "a core for boxes refuses spheres" refused shadow+reflect5+lights8+inside+boxes four
    check "first does not go with boxes" sh -c '! sh sim/parameters.sh first+boxes'
    check "nor does bih" sh -c '! sh sim/parameters.sh bih+boxes'
}
done_testing
