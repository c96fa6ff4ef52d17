#!/bin/sh
# test_lint.sh - the tools of `make lint` have nothing to say
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
silent() {
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory -k -j"${JOBS:-2}" B="${BUILD:-build}" \
        "lint-$1" || return 1
    ! grep -v 'pyslang is not installed' "$TMP/out"
}
for tool in verilator iverilog systemverilog yosys tidy format text; do
    check "$tool" silent $tool
done
done_testing
