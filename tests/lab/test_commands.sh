#!/bin/sh
# test_commands.sh - commands that stand beside a figure of a page give that figure
# SPDX-License-Identifier: Apache-2.0
#
# commands.txt: the page has the command as it stands there, and it, or its shorter form, prints
# the pattern; and every command of README and docs/results is there that names a scene. Cells,
# which `make synth` gives in minutes, are generated into pages and held by test_pages.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
ln -s "$root/scenes" "$TMP/scenes"

stands() { # page, command; pages are those of docs/results
    where=$1
    [ -f "$where" ] || where=docs/results/$1
    grep -qF -e "$2" "$where" || { echo "$where has no: $2" && false; }
}
prints() { # command, pattern
    case $1 in
    'make '*)
        small="SIM=icarus ${1#make } SIZE=8x6"
        eval "env -u MAKEFLAGS -u MFLAGS make -s B=\"\$BUILD\" $small"
        ;;
    *) cd "$TMP" && eval "\"\$SPHAERA\" $1" ;;
    esac >"$TMP/said" 2>&1 </dev/null
    cd "$root" || return 1
    grep -q -e "$2" "$TMP/said" || { tail -n 20 "$TMP/said" && false; }
}
while read -r first rest; do
    case $first in
    '' | '#'*) ;;
    *.md) page=$first ;;
    runs) run=$rest ;;
    says)
        check "$page: $command" stands "$page" "$command"
        check "... prints $rest" prints "$run" "$rest"
        ;;
    *) command="$first $rest" run="$first $rest" ;;
    esac
done <tests/lab/commands.txt

# Commands in code, without those that have a name for a scene or a number (SCENE, N, ...), and
# those that need what is not here.
commands() {
    grep -hoE '(^    |`)(build/)?(sphaera [a-z]+|make (sim|render)) [^`#]*' "$@" |
        sed -E 's/^[ `]*//; s,^(build/)?sphaera ,,; s/ +$//; s/  +.*//' |
        grep -E '^make|\.nff|--spheres|^gen ' |
        grep -vE '\.\.\.|(^| )(SCENE|FILE|N)([ .]|$)|(TOP=1|PROFILE=)$|^import /' | sort -u
}
commands README.md docs/results/*.md >"$TMP/there"
listed() {
    missing=0
    while read -r command; do
        grep -qF -e "  $command" tests/lab/commands.txt || { echo "$command" && missing=1; }
    done <"$TMP/there"
    return $missing
}
check "$(wc -l <"$TMP/there") commands of README and docs/results are in the list" listed

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
