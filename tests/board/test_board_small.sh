#!/bin/sh
# test_board_small.sh - the board of SDRAM, pin to pin, with frames of 64x48: make board-sim-small
# SPDX-License-Identifier: Apache-2.0
# Words of the SDRAM that come too late for its pins show that the comparison can fail.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
check "pictures of three machines, loaded over the UART" make -s board-sim-small B="$BUILD"
late() { # steps of 0.8 ns, there and back
    ! WAY=$1 "$BUILD/sim/tb_ulx3s_sdram/tb_ulx3s_sdram" "$BUILD"/board/small?.sph >"$TMP/said" &&
        cat "$TMP/said" && grep -q '^not ok' "$TMP/said"
}
check "words that come 11.2 ns late are noticed" late 14
done_testing
