#!/bin/sh
# test_generated.sh - generated files equal what their generators make today
# SPDX-License-Identifier: Apache-2.0
set -u
cd "$(dirname "$0")/../.." || exit 1
n=0
same() { # name, committed file, fresh file
    n=$((n + 1))
    if diff -u "$2" "$3"; then echo "ok $n - $1"; else echo "not ok $n - $1: see make layout"; fi
}
python3 -m lab layout "$TMP" || exit 1
for file in cmodel/machine/layout.h rtl/core/*.vh rtl/top/rt_top.vh driver/sphaera_regs.h \
    docs/reference/rt_top.rdl rtl/video/rt_modes.vh driver/sphaera_modes.h; do
    [ $file != rtl/core/rt_check.vh ] || continue # is written by hand
    same "${file##*/} follows its definition" $file "$TMP/${file##*/}"
done

${CC:-gcc} -std=c11 -O2 -Icmodel cmodel/math/gen_rsqrt.c -lm -o "$TMP/gen_rsqrt" || exit 1
"$TMP/gen_rsqrt" c >"$TMP/rsqrt_table.h"
"$TMP/gen_rsqrt" v >"$TMP/rt_rsqrt_rom.v"
same "rsqrt_table.h follows gen_rsqrt.c" cmodel/math/rsqrt_table.h "$TMP/rsqrt_table.h"
same "rt_rsqrt_rom.v follows gen_rsqrt.c" rtl/math/rt_rsqrt_rom.v "$TMP/rt_rsqrt_rom.v"

${CC:-gcc} -std=c11 -O2 -Icmodel cmodel/math/gen_reciprocal.c -o "$TMP/gen_reciprocal" || exit 1
"$TMP/gen_reciprocal" c >"$TMP/reciprocal_table.h"
"$TMP/gen_reciprocal" v >"$TMP/rt_reciprocal_rom.v"
same "reciprocal_table.h follows gen_reciprocal.c" cmodel/math/reciprocal_table.h \
    "$TMP/reciprocal_table.h"
same "rt_reciprocal_rom.v follows gen_reciprocal.c" rtl/math/rt_reciprocal_rom.v \
    "$TMP/rt_reciprocal_rom.v"

${CC:-gcc} -std=c11 -O2 -Icmodel cmodel/texture/gen_log2.c -lm -o "$TMP/gen_log2" || exit 1
"$TMP/gen_log2" c >"$TMP/log2_table.h"
"$TMP/gen_log2" v >"$TMP/rt_log2_rom.v"
same "log2_table.h follows gen_log2.c" cmodel/texture/log2_table.h "$TMP/log2_table.h"
same "rt_log2_rom.v follows gen_log2.c" rtl/texture/rt_log2_rom.v "$TMP/rt_log2_rom.v"

${CC:-gcc} -std=c11 -O2 -Icmodel cmodel/shade/gen_power.c -lm -o "$TMP/gen_power" || exit 1
"$TMP/gen_power" >"$TMP/power_table.h"
same "power_table.h follows gen_power.c" cmodel/shade/power_table.h "$TMP/power_table.h"
${CC:-gcc} -std=c11 -O2 -Icmodel cmodel/shade/gen_power_rom.c -o "$TMP/gen_power_rom" || exit 1
"$TMP/gen_power_rom" >"$TMP/rt_power_rom.v"
same "rt_power_rom.v follows power_table.h" rtl/shade/rt_power_rom.v "$TMP/rt_power_rom.v"

same "rt_bundles.vh follows bundles.def" rtl/engine/rt_bundles.vh "$TMP/rt_bundles.vh"
same "bundles.h follows bundles.def" tb/bundles.h "$TMP/bundles.h"
same "sphaera.f lists the files of rtl" rtl/sphaera.f "$TMP/sphaera.f"
same "sphaera.core lists them, and has the version of VERSION" sphaera.core "$TMP/sphaera.core"
echo 2.3.4 >"$TMP/VERSION"
python3 -c 'import sys
from lab.generate.top import Registers
from sim.definition import Definition
print(Registers(Definition(), sys.argv[1]).verilog())' "$TMP/VERSION" |
    sed -n "s/^.define RT_TOP_VERSION_RESET 32'h//p" >"$TMP/release"
echo 00020003 >"$TMP/wanted"
same "register VERSION has the numbers of VERSION" "$TMP/release" "$TMP/wanted"
echo "1..$n"
