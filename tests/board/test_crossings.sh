#!/bin/sh
# test_crossings.sh - every path between clocks of the board of SDRAM is one of those allowed
# SPDX-License-Identifier: Apache-2.0
# ALL=1: of the other tops, too (rt_top alone is checked by test_ip.sh, with its constraints).
set -u
cd "$(dirname "$0")/../.." || exit 1
command -v yosys >"$TMP/yosys" || {
    echo "ok 1 - # SKIP no yosys"
    exit 0
}
[ -n "${ALL:-}" ] && tops= || tops="rt_sdram_bus rt_ulx3s_sdram"
# shellcheck disable=SC2086  # none are all
exec python3 -m lab crossings $tops
