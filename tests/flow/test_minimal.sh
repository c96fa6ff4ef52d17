#!/bin/sh
# test_minimal.sh - the core taken away: examples/minimal with plain simulators and with FuseSoC
# SPDX-License-Identifier: Apache-2.0
#
# FuseSoC is that of the PATH or of `make fusesoc`; without it these checks are skipped. Verilator
# compiles the core for 20 seconds: with ALL=1, as in `make fusesoc`.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
skip() { echo "ok $((checks += 1)) - # SKIP $1"; }

# ---- the model's picture of the same scene ----
"$SPHAERA" build scenes/paper5.nff --profile draft --size 24x16 -o "$TMP/scene.sph" \
    >"$TMP/text" 2>&1
"$SPHAERA" export "$TMP/scene.sph" --hex "$TMP/scene" --c-array "$TMP/scene.h"
for file in scene.regs.hex scene.mem.hex; do
    check "$file is what sphaera export writes of paper5 at 24x16, draft" \
        diff "examples/minimal/$file" "$TMP/$file"
done
"$SPHAERA" render "$TMP/scene.sph" --transfer linear -o "$TMP/model.ppm" >"$TMP/text"
drawn() { # folder: the frame that was drawn there is the model's
    cmp "$1/scene.ppm" "$TMP/model.ppm"
}

# ---- plain simulators: no warning, and every byte of the frame ----
silent() { "$@" >"$TMP/said" 2>&1 && ! grep . "$TMP/said"; }
check "Icarus takes rtl/sphaera.f in silence" silent iverilog -g2005 -Wall -f rtl/sphaera.f \
    -s minimal -o "$TMP/minimal" examples/minimal/minimal.v
icarus() { # folder of the two files
    (cd "$1" && vvp -n "$TMP/minimal" && drawn .)
}
check "... and draws the model's frame" icarus "$TMP"

# ---- memories of a compiler in the place of block RAM: their model gives x on a collision ----
compiled() { # wrapper
    sed "s,^rtl/memory/rt_slot_ram.v,$1\nexamples/asic/rt_sram.v," rtl/sphaera.f >"$TMP/asic.f"
    silent iverilog -g2005 -Wall -f "$TMP/asic.f" -s minimal -o "$TMP/minimal" \
        examples/minimal/minimal.v && icarus "$TMP"
}
check "with the wrapper of compiled SRAM it draws it, too" compiled examples/asic/rt_slot_ram.v
sed 's/^module rt_slot_ram/&_rtl/' rtl/memory/rt_slot_ram.v >"$TMP/rtl.v"
sed 's/wire  *meets = .*;/wire meets = 1'"'b0"';/; s/&& !meets/\&\& 1/' \
    examples/asic/rt_slot_ram.v >"$TMP/hasty.v"
beside() { # wrapper
    iverilog -g2005 -Irtl/memory -s beside -o "$TMP/beside" examples/asic/beside.v "$1" \
        examples/asic/rt_sram.v "$TMP/rtl.v" rtl/memory/rt_slot_file.v &&
        vvp -n "$TMP/beside" | tee "$TMP/said" && grep -q '^0 of 4000 clocks differ' "$TMP/said"
}
check "it is in every clock what it replaces" beside examples/asic/rt_slot_ram.v
differs() { ! beside "$TMP/hasty.v" && grep -q '^[1-9][0-9]* of 4000 clocks differ' "$TMP/said"; }
check "... and not if a read does not take the word that waits" differs

# ---- large files of registered reads, in a family that has no others ----
falling() { # edge
    sed "s/@(negedge clk)/@($1 clk)/" rtl/memory/rt_slot_file.v >"$TMP/file.v"
    sed "s,^rtl/memory/rt_slot_file.v,$TMP/file.v," rtl/sphaera.f >"$TMP/falling.f"
    silent iverilog -g2005 -Wall -DRT_FALLING_BITS=1024 -f "$TMP/falling.f" -s minimal \
        -o "$TMP/minimal" examples/minimal/minimal.v && icarus "$TMP"
}
check "with large files that are read at the falling edge it draws it, too" falling negedge
late() { # it waits for ever
    ! (icarus() { (cd "$1" && timeout 5 vvp -n "$TMP/minimal" && drawn .); } && falling posedge) &&
        [ ! -s "$TMP/said" ]
}
check "... and not if they are read at the rising one" late

check "Verilator takes rtl/sphaera.f in silence" silent verilator --lint-only --timing \
    --language 1364-2005 --top-module minimal -f rtl/sphaera.f examples/minimal/minimal.v
check "... and with large files of registered reads" silent verilator --lint-only --timing -Wall \
    -DRT_FALLING_BITS=1024 --language 1364-2005 --top-module rt_core -f rtl/sphaera.f
sed -n 's/^    //; /^files=/p; /^yosys /p' docs/reference/core.md >"$TMP/yosys.sh"
check "the page has lines for Yosys" [ "$(wc -l <"$TMP/yosys.sh")" = 2 ]
check "... which take every module" sh -c "sh '$TMP/yosys.sh' >'$TMP/said' 2>&1 ||
    { tail -n 3 '$TMP/said'; exit 1; }; grep -q 'Top module: .*rt_core' '$TMP/said'"
if [ -n "${ALL:-}" ]; then
    check "Verilator compiles it" verilator --binary -j 1 --language 1364-2005 \
        --top-module minimal --Mdir "$TMP/v" -f rtl/sphaera.f examples/minimal/minimal.v
    rm -f "$TMP/scene.ppm"
    check "... and draws the model's frame" sh -c \
        "cd '$TMP' && v/Vminimal && cmp scene.ppm model.ppm"
fi

# ---- the same machine as arrays of C ----
cat >"$TMP/host.c" <<'END'
#include <stdio.h>
#include "scene.h"
int main(void) {
    for (int i = 0; i < scene_REGISTERS; i++) printf("%08x\n", (unsigned)scene_regs[i]);
    for (int i = 0; i < 8 * scene_LINES; i++)
        printf("%08x%s", (unsigned)scene_mem[i - i % 8 + 7 - i % 8], i % 8 == 7 ? "\n" : "");
    return 0;
}
END
check "a host's compiler takes the arrays" "${CC:-gcc}" -std=c99 -Wall -Wextra -pedantic -Werror \
    "$TMP/host.c" -o "$TMP/host"
check "... which are the same words" sh -c "'$TMP/host' >'$TMP/words'; cat '$TMP/scene.regs.hex' \
    '$TMP/scene.mem.hex' | grep -v '^//' | cmp - '$TMP/words'"
cd "$TMP" || exit 1
s=$SPHAERA
fails 1 "export --hex of a scene" "$s" export "$root/scenes/paper5.nff" --hex x
check "... says what to do" grep -q 'is no machine file; .sphaera build. makes one of a scene' err
fails 1 "export --hex to nowhere" "$s" export scene.sph --hex nowhere/x
fails 1 "export --c-array to 5.h" "$s" export scene.sph --c-array 5.h
for file in regs mem; do
    fails 1 "export of $file twice" "$s" export scene.sph --hex x --c-array x.$file.hex
    check "... names it" grep -q "x.$file.hex: would overwrite" err
done
cp scene.sph y.mem.hex
fails 1 "export onto the machine" "$s" export y.mem.hex --hex y
check "... which stays" cmp scene.sph y.mem.hex
fails 2 "export of a machine with -o" "$s" export scene.sph --hex x -o x.pov
fails 1 "export of a machine with --size" "$s" export scene.sph --hex x --size 8x8
check "nothing is left of what failed" sh -c "! ls | grep -E '^(x|5|nowhere)'"

# ---- FuseSoC ----
PATH=$BUILD/fusesoc/bin:$PATH
export XDG_CONFIG_HOME="$TMP/fusesoc" XDG_DATA_HOME="$TMP/fusesoc" XDG_CACHE_HOME="$TMP/fusesoc"
soc() { # target, words
    target=$1
    shift
    fusesoc --cores-root "$root" run --target "$target" "$@" --work-root "$TMP/soc" sphaera
}
if ! command -v fusesoc >text; then
    skip "there is no FuseSoC: make fusesoc"
else
    check "FuseSoC: lint" soc lint
    if [ -n "${ALL:-}" ]; then
        for tool in icarus verilator; do
            rm -rf soc
            check "FuseSoC: sim by $tool" soc sim --tool $tool
            check "... draws the model's frame" drawn soc
        done
    fi
fi
done_testing
