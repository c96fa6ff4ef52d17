#!/bin/sh
# test_commands.sh - commands that stand beside a figure of a page give that figure
# SPDX-License-Identifier: Apache-2.0
#
# commands.txt: the page has the command as it stands there, and it, or its shorter form, prints
# the pattern.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD

stands() { # page, command; pages are those of docs/results
    page=$1
    [ -f "$page" ] || page=docs/results/$1
    grep -qF -e "$2" "$page" || { echo "$page has no: $2" && false; }
}
prints() { # command, pattern
    (cd "$TMP" && ln -sfn "$root/scenes" scenes && eval "\"\$SPHAERA\" $1") >"$TMP/said" 2>&1
    grep -q -e "$2" "$TMP/said" || { head -n 5 "$TMP/said" && false; }
}
# shellcheck disable=SC2016  # sed's own
sed -n 's/ *| */|/g; /^[^#]/p' tests/lab/commands.txt >"$TMP/list"
while IFS='|' read -r page command run pattern; do
    check "$page: $command" stands "$page" "$command"
    check "... prints $pattern" prints "${run:-$command}" "$pattern"
done <"$TMP/list"

# the paper's walk, bare and corrected, are two columns
differs() {
    for how in off on; do
        "$SPHAERA" render paper100 --tree paper --size 160x90 --traverse first \
            --interpenetrate $how -o "$TMP/$how.png" >"$TMP/$how.log" || return 1
    done
    ! cmp "$TMP/off.png" "$TMP/on.png"
}
check "--interpenetrate off gives another column" differs
done_testing
