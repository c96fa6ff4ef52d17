#!/bin/sh
# test_core_texture.sh - frames with textures of the RTL core equal the golden model's
# SPDX-License-Identifier: Apache-2.0
#
# Colours, id, key, visits and texture word of each pixel, and the counters, TEXELS among them; in
# Verilator and Icarus, with random memory latency and 30 % stalls: floor, wall and globe of
# scenes/texture/hall.nff, and tests/scenes/texture/balls.nff, whose mirrors show textures in
# mirrors. Every filter, what EFFECTS switches off at run time, two engines, cores that have
# textures and hardly anything else, records and images that are broken on purpose, a bus error,
# ends of memory within a group of lines.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start core_texture
hall=scenes/texture/hall.nff balls=tests/scenes/texture/balls.nff
machine hall $hall --profile draft --size 32x18
machine hall-standard $hall --size 24x14
machine hall-small $hall --profile draft --size 10x6
machine hall-only $hall --profile draft --size 16x10 --depth 0 --lights 0 --filter nearest
machine hall-rect $hall --profile draft --size 16x10 --background rect
machine hall-coarse $hall --profile draft --size 10x6 --lod-bits 3
machine hall-bih $hall --profile draft --size 10x6 --accel bih
machine balls $balls --profile draft --size 16x12
machine balls-first $balls --profile draft --size 16x12 --traverse first --tree paper
machine balls-small $balls --profile draft --size 6x5
machine balls-only $balls --profile draft --size 6x5 --depth 0 --lights 0
for profile in fine reference; do machine balls-$profile $balls --profile $profile --size 4x3; done
machine robot-3 scenes/texture/robot.nff --profile draft --size 12x7 --at 3
machine plain scenes/paper100.nff --profile draft --size 32x24

whole=all+texture+spread
for filter in 0 1 2 3; do
    wanted "verilator hall, filter $filter" $whole SIM=verilator hall --reg 101=$filter
    wanted "verilator balls, filter $filter" $whole SIM=verilator balls --reg 101=$filter
done
wanted "verilator balls, probes and pixels that start again" $whole SIM=verilator balls-first
wanted "verilator hall, textures alone" $whole SIM=verilator hall-only
wanted "verilator hall, background by rectangle" $whole SIM=verilator hall-rect
wanted "verilator robot, frame 3" $whole SIM=verilator robot-3
wanted "verilator paper100, no textures" $whole SIM=verilator plain
wanted "verilator hall, caches kept" $whole SIM=verilator hall --warm
for part in sdram16 ddr3x16; do
    wanted "verilator hall, memory is $part" $whole SIM=verilator hall --memory $part --warm
done
wanted "verilator balls, slow memory, a bus error" $whole SIM=verilator balls --expect-errors 8 \
    --memory sdram16 --core-mhz 500 --bus-error-at 20
# bits of EFFECTS: 2 reflect, 4 inside, 64 texture; without lights
wanted "verilator balls, textures switched off" $whole SIM=verilator balls --reg 0=7
wanted "verilator balls, mirrors and textures" $whole SIM=verilator balls --reg 0=70 --reg 2=0
wanted "verilator balls, textures need the point" $whole SIM=verilator balls --reg 0=68 --reg 2=0
wanted "verilator hall standard, two engines" auto ENGINES=2 hall-standard

wanted "icarus hall" auto SIM=icarus hall-small
wanted "icarus hall, found by a BIH" auto SIM=icarus hall-bih
wanted "icarus hall, levels of three bits" auto SIM=icarus hall-coarse
wanted "icarus balls" auto SIM=icarus balls-small
wanted "icarus hall, textures alone" auto SIM=icarus hall-only
wanted "icarus balls, textures alone" auto SIM=icarus balls-only
for profile in fine reference; do
    wanted "icarus balls $profile" auto SIM=icarus balls-$profile
done

# The ball in front has record 3, mapping record 7; image 10 is everyone's.
broken() { # what, options
    what=$1
    shift
    wanted "verilator broken: $what" $whole SIM=verilator balls --expect-errors 1 "$@"
}
broken "mapping record beyond memory" --poke 3:192:26=0x3fffffe
broken "image beyond memory" --poke 7:20:26=0x3ffffff
broken "image without levels" --poke 10:24:4=0
broken "image of thirteen levels" --poke 10:24:4=13
broken "texels beyond memory" --reg 27=1000
wanted "verilator broken: bus error at a texel" $whole SIM=verilator balls --expect-errors 8 \
    --bus-error-at 20

# Memory ends at each place of a group of lines, behind a mapping record or the image's header.
for group in 2 4; do
    for end in 9 10 11 12; do
        what="lines in groups of $group, memory of $end"
        wanted "verilator balls, $what" auto "SIM=verilator SIZES=texture_group=$group" balls \
            --expect-errors 1 --reg 27=$end
        wanted "icarus balls, $what" auto "SIM=icarus SIZES=texture_group=$group" balls-small \
            --expect-errors 1 --reg 27=$end
    done
done

build_cores
run_all
judge

# Counters that are equal because both are 0 say nothing.
counts() { # counter: the core counted some
    env BUILT=1 EFFECTS=$whole sh sim/core.sh --machine "$machines/balls.sph" --progress |
        grep -E "^ +$1( +[1-9][0-9]*)+\$"
}
[ -n "$CORE" ] || for counter in texels texel_misses; do
    check "the core counts $counter" counts $counter
done

# A core of other levels than the machine's gives no pixel.
coarser() {
    env BUILT=1 EFFECTS=$whole sh sim/core.sh --machine "$machines/balls.sph" --reg 102=5 \
        >"$TMP/refused"
    [ $? -eq 3 ] && grep 'asks for coarse5' "$TMP/refused"
}
[ -n "$CORE" ] || check "levels of three bits, a core of eight: refused" coarser
done_testing
