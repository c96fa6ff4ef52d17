#!/bin/sh
# test_walk_pictures.sh - the six pictures of the thesis's Figure 4.3 are what the model draws
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build} shown=docs/pictures/bih
names=$(cd $shown && ls depth*.png)
check "all are drawn" python3 -c "
from lab.scenarios import measure
measure.pictures('${SPHAERA:-$BUILD/sphaera}', '$TMP', '$TMP/drawn')"
for name in $names; do
    check "$name: else run make scenarios" \
        oiiotool --diff --fail 0 "$shown/$name" "$TMP/drawn/$name"
done
done_testing
