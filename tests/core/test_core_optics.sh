#!/bin/sh
# test_core_optics.sh - frames with refraction, sums and highlights of the core equal the model's
# SPDX-License-Identifier: Apache-2.0
#
# Colours, id, key, visits and texture word of each pixel, and the counters, RAYS_REFRACTED and
# POWERS among them; in Verilator and Icarus, with random memory latency and 30 % stalls. Every
# depth, what EFFECTS switches off at run time, two engines, a BIH, roots that are cut, cores that
# have only a part of it, and one without any, which refuses.
#   SEED=n        other latencies and stalls (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start core_optics
glass=tests/scenes/refraction/glass.nff mixed=tests/scenes/refraction/mixed.nff
machine glass $glass --profile draft --size 12x8 --depth 10
machine mirrors tests/scenes/mirrors.nff --profile draft --size 12x9 --depth 10
machine mirrors-small tests/scenes/mirrors.nff --profile draft --size 4x3 --depth 10
machine mixed $mixed --profile draft --size 10x8 --depth 5
machine water scenes/refraction/water.nff --profile draft --size 16x10 --depth 3
machine plain scenes/paper5.nff --profile draft --size 16x10 --depth 4
machine probes scenes/interpenetrating.nff --profile draft --size 16x10 --traverse first
machine bih $mixed --profile draft --size 2x1 --depth 2 --accel bih
machine two $mixed --profile draft --size 4x3 --depth 4
machine pair $mixed --profile draft --size 2x1 --depth 2 # two engines in Icarus take long
machine few-glass $glass --profile draft --size 6x4 --depth 5 --least-weight 0.15
machine light-mirrors tests/scenes/mirrors.nff --profile draft --size 12x9 --depth 10 \
    --least-weight 0.6
machine light-small tests/scenes/mirrors.nff --profile draft --size 4x3 --depth 10 \
    --least-weight 0.6
machine light-probes scenes/interpenetrating.nff --profile draft --size 16x10 --traverse first \
    --least-weight 0.5
machine cut $mixed --profile draft:pr=9 --size 2x1 --depth 3
machine bends $mixed --profile draft --size 5x4 --lights 0 --reflect off --specular off
machine sums $mixed --profile draft --size 6x5 --refract off --reflect off --specular off
machine shines $mixed --profile draft --size 6x5 --refract off --shadow off
for profile in fine reference; do machine glass-$profile $glass --profile $profile --size 2x1; done

whole=all+reflect10+texture+refract+specular+sum+spread
for depth in 0 1 2 3 5 8 10; do
    wanted "verilator glass, depth $depth" $whole SIM=verilator glass --reg 1=$depth
done
wanted "verilator mixed" $whole SIM=verilator mixed
wanted "verilator water" $whole SIM=verilator water
wanted "verilator paper5, blended by shares" $whole SIM=verilator plain
wanted "verilator interpenetrating, probes and pixels that start again" $whole SIM=verilator probes
# bits of EFFECTS: 1 shadow, 2 reflect, 64 texture, 128 refract, 256 specular, 512 sum; 36 always
wanted "verilator glass, not refracted" $whole SIM=verilator glass --reg 0=871
wanted "verilator glass, not mirrored" $whole SIM=verilator glass --reg 0=997
wanted "verilator glass, blends alone" $whole SIM=verilator glass --reg 0=231
wanted "verilator glass, no highlights, no lights" $whole SIM=verilator glass --reg 0=743 --reg 2=0
wanted "verilator glass, sum alone" $whole SIM=verilator glass --reg 0=548 --reg 2=0

wanted "verilator mirrors, ten deep" auto SIM=verilator mirrors
wanted "verilator mirrors, ten deep by shares" $whole SIM=verilator mirrors
wanted "icarus mirrors, ten deep" auto SIM=icarus mirrors-small
# LEAST_WEIGHT is register 118
for least in 26 128 200 256; do
    wanted "verilator glass, least weight $least" $whole SIM=verilator glass --reg 118=$least
    wanted "verilator mirrors, least weight $least" auto SIM=verilator mirrors --reg 118=$least
done
wanted "verilator mirrors of a least weight, by shares" $whole SIM=verilator light-mirrors
wanted "verilator interpenetrating, probes of a least weight" $whole SIM=verilator light-probes
wanted "icarus glass of a least weight" auto SIM=icarus few-glass
wanted "icarus mirrors of a least weight" auto SIM=icarus light-small
wanted "icarus mixed, two engines" auto "SIM=icarus ENGINES=2" pair
wanted "icarus mixed, in a BIH" auto SIM=icarus bih
wanted "icarus mixed, roots cut" auto SIM=icarus cut
wanted "icarus mixed, only refracted" auto SIM=icarus bends
wanted "icarus mixed, only sums" auto SIM=icarus sums
wanted "icarus mixed, highlights without shadows" auto SIM=icarus shines
for profile in fine reference; do
    wanted "icarus glass $profile" auto SIM=icarus glass-$profile
done

# Two machines without a reset between them, then frames that are cut off by a reset.
machine balls tests/scenes/texture/balls.nff --profile draft --size 3x2 --depth 1
machine few $mixed --profile draft --size 3x2 --depth 2
wanted "verilator cut off" $whole SIM=verilator few --life --then "$machines/balls.sph" --cuts 30

build_cores
run_all
judge

# Counters that are equal because both are 0 say nothing.
counts() { # counter: the core counted some
    env BUILT=1 EFFECTS=$whole sh sim/core.sh --machine "$machines/two.sph" --progress |
        grep -E "^ +$1( +[1-9][0-9]*)+\$"
}
refused() {
    env BUILT= EFFECTS=all SIM=icarus \
        sh sim/core.sh --machine "$machines/two.sph" >"$TMP/refused" 2>&1
    rc=$?
    cat "$TMP/refused"
    [ $rc = 3 ] && grep -q refract "$TMP/refused"
}
[ -n "$CORE" ] || {
    for counter in rays_refracted powers; do
        check "the core counts $counter" counts $counter
    done
    check "a core without refraction refuses" refused
}
done_testing
