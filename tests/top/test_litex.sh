#!/bin/sh
# test_litex.sh - LiteX systems with rt_top, where LiteX is installed
# SPDX-License-Identifier: Apache-2.0
#   ALL=1  a frame in LiteX's simulator too (`make litex-sim`)
# Faults in what the firmware tells show that its check can fail.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
B=${BUILD:-build}
made() { # goal: it ran to its end
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory B="$B" "$1" >"$TMP/said" 2>&1
    cat "$TMP/said"
    grep -q '^ok' "$TMP/said"
}
goal() { # goal, what it needs besides LiteX
    if [ -x "$B/venv/litex/bin/python" ] && command -v "$2" >"$TMP/found"; then
        check "make $1" made "$1"
    else
        checks=$((checks + 1))
        echo "ok $checks - make $1 # SKIP LiteX or a linker is absent: make litex-setup"
    fi
}
goal litex clang
[ -z "${ALL:-}" ] || goal litex-sim riscv64-unknown-elf-ld

# What the firmware would tell of the golden frame: all is right.
"$B/sphaera" build scenes/paper5.nff --profile draft --size 12x7 --depth 1 --interpenetrate off \
    -o "$TMP/m.sph" >"$TMP/build.log" 2>&1
"$B/sphaera" render "$TMP/m.sph" --frame "$TMP/m.frame" >"$TMP/render.log"
python3 - "$TMP/m.sph" "$TMP/m.frame" >"$TMP/told" <<'END'
import sys
from lab.top.golden import golden
print("sphaera: done, interrupt pending\nclocks: 0x00000100")
for row in golden(*sys.argv[1:]):
    print("row", "".join(f"{c >> 8 & 0xf800 | c >> 5 & 0x7e0 | c >> 3 & 31:04x}" for c in row))
print("done, frames drawn: 0x00000002\nunderruns: 0x00000000")
END
judged() { python3 -m lab litex-check "$1" "$TMP/m.sph" "$TMP/m.frame"; }
noticed() { # sed command: a fault in what is told
    sed "$1" "$TMP/told" >"$TMP/wrong"
    ! cmp -s "$TMP/told" "$TMP/wrong" && ! judged "$TMP/wrong"
}
check "the check of the simulation takes what is right" judged "$TMP/told"
while IFS='|' read -r name fault; do
    check "it notices $name" noticed "$fault"
done <<'END'
a pixel that differs|3s/^row ..../row 0001/
a row that is missing|4d
no interrupt|s/, interrupt pending/, no interrupt/
an underrun|s/underruns: 0x00000000/underruns: 0x00000001/
an SDRAM that is driven too fast|1s/^/[0] ACT->RD violation on bank 0\n/
END
done_testing
