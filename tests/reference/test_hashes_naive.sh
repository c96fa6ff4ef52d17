#!/bin/sh
# test_hashes_naive.sh - the golden model draws what the naive one drew of each scene of the hashes
# SPDX-License-Identifier: Apache-2.0
#
# scenes/hashes.txt is the golden model's own output; scenes/hashes_naive.txt is not. Some of its
# lines are drawn anew, pixel by pixel compared; with ALL=1 all of them.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
naive=${BUILD:-build}/test/naive-frame
TMPDIR=$TMP
export TMPDIR
grep -v '^#' scenes/hashes_naive.txt >"$TMP/naive"
golden() { # every line is one of the golden model's, and it has every scene of scenes/hashes.txt
    SIZE=16x9 sh sim/hashes.sh | grep -v '^#' >"$TMP/golden"
    grep -vxFf "$TMP/golden" "$TMP/naive" && return 1
    cut -d' ' -f1-3 "$TMP/naive" >"$TMP/judged"
    grep -v '^#' scenes/hashes.txt | cut -d' ' -f1-3 | diff - "$TMP/judged"
}
anew() {
    sh sim/hashes.sh --naive "$naive" ${ALL:-8} | grep -v '^#' >"$TMP/anew"
    grep -vxFf "$TMP/naive" "$TMP/anew" && return 1
    [ "$(wc -l <"$TMP/anew")" -ge 20 ]
}
check "the golden model draws what the naive one drew" golden
check "the naive model draws it again" anew
done_testing
