#!/bin/sh
# test_quoting.sh - no text that a user types to make is run, by make or by a shell
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
top=$PWD planted=$TMP/planted
rm -f "$planted"

touched="touch $planted"
typed() { # make's words: nothing is run, and make says no
    rc=0
    timeout 60 env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory \
        B="$TMP/none" "$@" >"$TMP/said" 2>&1 || rc=$?
    [ $rc = 2 ] && [ ! -e "$planted" ] && [ ! -e "$TMP/none" ] ||
        { tail -n 2 "$TMP/said" && echo "exit code $rc" && ls "$planted" && false; }
}
line_end='
'
for goal in "x';$touched;'" "\$(shell $touched)" "\`$touched\`" "x;$touched" \
    "x${line_end}$touched" "x|$touched" "x&&$touched"; do
    check "goal $goal" typed "$goal"
    check "... from elsewhere" typed -C "$TMP" -f "$top/Makefile" "$goal"
done
all_of() { # variable
    for value in "\$(shell $touched)" "\${shell $touched}" "x';$touched;'\$x" \
        "\$(info \`$touched\`)" "x'${line_end}$touched #"; do
        typed help "$1=$value" || return 1
        (eval "$1=\$value; export $1; typed help") || return 1
    done
}
for name in $(sed -n 's/^## \([A-Z_][A-Z_]*\) .*/\1/p' make/variables.mk |
    grep -vE '^(B|CC|CXX)$'); do
    check "variable $name" all_of "$name"
done
quoted() { # what has neither $ nor line's end comes to the shell as it stands
    typed sim "SCENE=';$touched;'" && typed sim "SCENE=\`$touched\`" &&
        typed sim "SIZE=';$touched;'"
}
check "quotes in values" quoted
check "nothing was planted" test ! -e "$planted"
done_testing
