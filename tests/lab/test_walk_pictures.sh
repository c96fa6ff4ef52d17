#!/bin/sh
# test_walk_pictures.sh - the six pictures of the thesis's Figure 4.3 are what the model draws
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build} shown=docs/pictures/bih
drawn() { # pictures, by the rules that make scenarios has
    env -u MAKEFLAGS -u MFLAGS make -f make/scenarios.mk TOOL="${SPHAERA:-$BUILD/sphaera}" \
        SCN="$TMP/scenarios" SCN_SHOWN="$TMP/drawn" "$@" 2>&1
}
names=$(cd $shown && ls depth*.png)
# shellcheck disable=SC2046  # a list of words on purpose
check "all are drawn" drawn $(for name in $names; do echo "$TMP/drawn/$name"; done)
for name in $names; do
    check "$name: else run make scenarios" \
        oiiotool --diff --fail 0 "$shown/$name" "$TMP/drawn/$name"
done
done_testing
