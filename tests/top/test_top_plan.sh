#!/bin/sh
# test_top_plan.sh - rt_top in the host's view, clock by clock; each sentence of its pages is judged
# SPDX-License-Identifier: Apache-2.0
# tb_shell: around the golden model in place of the core every check of rt_top, every order in every
# clock, a host at random; tb/top/top_plan.txt says what must be met.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
plain_make() { env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory "$@"; }

shell() {
    words=$(plain_make B="$BUILD" top-shell) && eval "set -- $words" || return 1
    set -- -f make/rt_top.mk B="$BUILD" BENCH=tb_shell SEED=1 "$@"
    plain_make "$@" top >"$TMP/made" 2>&1 || { cat "$TMP/made" && return 1; }
    plain_make "$@" run >"$TMP/said" && cat "$TMP/said" &&
        grep -q '^ok .*every point of the plan is met' "$TMP/said"
}
plain_make B="$BUILD" "$BUILD"/top/paper5.sph "$BUILD"/top/interpenetrating.sph
check "the host's view of rt_top" shell
check "each sentence of its pages has a judge" python3 -m lab top-plan
done_testing
