#!/bin/sh
# test_hashes.sh - the golden model draws the pictures whose hashes are in scenes/hashes.txt
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
sh sim/hashes.sh >"$TMP/hashes"
expected() { # the line of the file that starts like this one
    grep -x "$1" scenes/hashes.txt && return
    echo "now $1; a change that is meant: make hashes"
    grep "^${1% *} " scenes/hashes.txt
    return 1
}
while read -r line; do
    case $line in '#'*) continue ;; esac
    check "${line% *}" expected "$line"
done <"$TMP/hashes"
check "no line too many" cmp "$TMP/hashes" scenes/hashes.txt
done_testing
