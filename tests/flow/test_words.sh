#!/bin/sh
# test_words.sh - what is given to make is text: no value and no goal is run by make or a shell
# SPDX-License-Identifier: Apache-2.0
#
# Each of `words` makes the file $mark if a shell runs it, or make expands it; as a value of every
# variable of make/variables.mk, as a goal and as a name of a variable it must not.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD mark=$TMP/mark
plain_make() { timeout 60 env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory "$@"; }
newline='
'
names=$(sed -n 's/^## \([A-Z_][A-Z_]*\) .*/\1/p' make/variables.mk)
kind_of() { sed -n "s/^## $1 \([^ ]*\) .*/\1/p; s/^## $1 \([^ ]*\)$/\1/p" make/variables.mk; }

# ---- what make itself would expand, or a recipe's line would end at: each variable alone ----
unmarked() { # the call of make failed, and nothing was run
    [ "$rc" -ne 0 ] && [ ! -e "$mark" ] && return
    echo "exit code $rc: $*"
    rm -f "$mark"
    return 1
}
told() { # name, value: refused by the name
    rc=0
    plain_make "$1=$2" help >"$TMP/said" 2>&1 || rc=$?
    unmarked "$1=$2" && grep -qF -- "$1=" "$TMP/said" || { cat "$TMP/said" && return 1; }
    rc=0
    env "$1=$2" timeout 60 env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make help >"$TMP/said" 2>&1 ||
        rc=$?
    [ ! -e "$mark" ] || { rm "$mark" && echo "of the environment: $1=$2" && return 1; }
}
each_told() {
    for variable in $names; do
        told "$variable" "$1" || return 1
    done
}
# shellcheck disable=SC2016  # for make
for value in '$(shell touch '"$mark"')' '${shell touch '"$mark"'}' 'a$$(touch '"$mark"')' \
    "a${newline}touch $mark${newline}"; do
    check "each variable is not expanded: $(echo "$value" | tr '\n' ' ' | cut -c 1-20)..." \
        each_told "$value"
done
# ---- what the environment has, of any name ----
# All names that the makefiles use and make/variables.mk has not, at once.
# shellcheck disable=SC2016  # for make
used=$(grep -ohE '\$\(([A-Za-z_][A-Za-z0-9_]*)[:)]' Makefile make/*.mk | tr -d '$():' |
    { printf '%s\n' $names CURDIR MAKE MAKEFILE_LIST MAKECMDGOALS SHELL >"$TMP/known"
      grep -vxF -f "$TMP/known"; } | sort -u)
check "names are found" [ "$(echo "$used" | grep -c .)" -gt 100 ]
from_environment() ( # value
    unset MAKEFLAGS MFLAGS MAKELEVEL
    for variable in $used NOSUCH; do
        export "$variable=$1"
    done
    timeout 60 make -n --no-print-directory B="$BUILD" top-hd top lint-tidy help >"$TMP/said" 2>&1
    [ ! -e "$mark" ] || { rm "$mark" && echo "run: $1" && exit 1; }
    ! grep -F -- "touch $mark" "$TMP/said"
)
# shellcheck disable=SC2016
for value in '$(shell touch '"$mark"')' "x;touch $mark"; do
    check "no name of the environment is run: $(echo "$value" | cut -c 1-8)" \
        from_environment "$value"
done
# shellcheck disable=SC2016
sim_of_environment() {
    for goal in sim render top-hd; do
        rc=0
        env -u MAKEFLAGS SCENE='$(shell touch '"$mark"')' HD_SCENE='$(touch '"$mark"')' \
            make B="$BUILD" $goal >"$TMP/said" 2>&1 || rc=$?
        unmarked "make $goal" && grep -q 'SCENE=\$' "$TMP/said" || return 1
    done
}
check "SCENE and HD_SCENE of the environment are refused" sim_of_environment
refused() {
    rc=0
    plain_make "$@" >"$TMP/said" 2>&1 || rc=$?
    cat "$TMP/said"
    unmarked "$@"
}
# shellcheck disable=SC2016
for variable in SHELL MAKE CURDIR MAKEFILE_LIST MAKECMDGOALS HERE values; do
    check "nor is $variable" refused "$variable=\$(shell touch $mark)" help
done
# make expands NAME:=VALUE before it reads a file: all that can be done is to make nothing
# shellcheck disable=SC2016
early() {
    for assigned in ':=' '::='; do
        rc=0
        plain_make "SCENE$assigned\$(shell touch $mark)" help >"$TMP/said" 2>&1 || rc=$?
        rm -f "$mark"
        [ "$rc" -ne 0 ] && grep -q 'SCENE:=: only NAME=VALUE is text' "$TMP/said" || return 1
        refused "SCENE${assigned}paper5" render || return 1
    done
}
check "an assignment that make expands itself is refused" early
check "MAKE is no command of a user" refused "MAKE=touch $mark;" -f "$root/Makefile" help

# ---- what a shell would run: all variables at once ----
each_word() {
    for word in "x';touch $mark;'" "x\";touch $mark;\"" "\`touch $mark\`" "x;touch $mark" \
        "x&touch $mark" "x|touch $mark" "x>$mark" "'" '"' '\' '(' ')' '#' '*' \
        "x y;touch $mark"; do
        printf '%s\n' "$word"
    done
}
text='' # these take any text, which stands in quotes
for variable in $names; do
    case $(kind_of "$variable") in "<text>"*) text="$text $variable" ;; esac
done
check "few variables take any text" [ "$text" = \
    " MOVIE CSV IP CORE EFFECT MUTANT B PREFIX DESTDIR" ]
all_refused() { # word: all others are told, by name
    set -- "$1"
    word=$1
    for variable in $names; do set -- "$@" "$variable=$word"; done
    shift
    rc=0
    plain_make "$@" help >"$TMP/said" 2>&1 || rc=$?
    unmarked "$word" || return 1
    for variable in $names; do
        case " $text " in *" $variable "*) continue ;; esac
        grep -qF -- "$variable=$word" "$TMP/said" && continue
        echo "not told: $variable=$word"
        return 1
    done
}
each_refused() {
    each_word >"$TMP/words"
    while IFS= read -r word; do
        all_refused "$word" </dev/null || return 1
    done <"$TMP/words"
}
check "no word of a shell gets into a command" each_refused
as_text() { # goals with text as it is
    while IFS= read -r word; do
        for variable in $text; do set -- "$@" "$variable=$word"; done
        plain_make -n "$@" help install uninstall sim render film \
            B="$TMP/none$word" SIM=icarus SCENE=paper5 >"$TMP/said" 2>&1 </dev/null
        [ ! -e "$mark" ] || { rm "$mark" && echo "run: $word" && return 1; }
        plain_make "$@" B="$BUILD" help >"$TMP/said" 2>&1 </dev/null ||
            { cat "$TMP/said" && return 1; }
        [ ! -e "$mark" ] || { rm "$mark" && echo "run: $word" && return 1; }
        set --
    done <"$TMP/words"
}
check "text is text" as_text

# ---- names of files, in goals that use them ----
odd="a b';touch \"mark\" (&) #é"
mkdir "$TMP/files"
cp scenes/paper5.nff "$TMP/files/$odd.nff"
cp scenes/moving/orbit.nff "$TMP/files/$odd orbit.nff"
from_files() (
    cd "$TMP/files" || exit 1
    plain_make -f "$root/Makefile" B="$BUILD" SIZE=6x4 "$@"
)
check "a scene of any name, and a table" from_files sim SIM=icarus SCENE="$odd.nff" CSV="$odd.csv"
check "... which has a row" [ "$(grep -c . "$TMP/files/$odd.csv")" = 2 ]
check "a film of any name" from_files film SCENE="$odd orbit.nff" FRAMES=0..1 \
    MOVIE="$TMP/files/$odd.gif"
check "... is there" test -s "$TMP/files/$odd.gif"
check "nothing else was made there" [ "$(find "$TMP/files" -type f | grep -c .)" = 4 ]
cp scenes/paper5.nff "$TMP/files/a\$b.nff"
check "a scene with a dollar is refused by name" refused SCENE="$TMP/files/a\$b.nff" render
check "... and told why" grep -F 'b.nff: has a $' "$TMP/said"

# ---- goals, and names of variables ----
goals_refused() {
    while IFS= read -r word; do
        refused "$word" </dev/null && refused clean "$word" B="$TMP/none" </dev/null &&
            refused -f "$root/Makefile" "$word" </dev/null &&
            refused "build/$word" </dev/null || return 1
        case $word in *[\`\|\>\(\)]*) continue ;; esac
        refused "$word=1" help </dev/null || return 1
    done <"$TMP/words"
}
check "goals are words" goals_refused
# shellcheck disable=SC2016
for goal in '$(shell touch '"$mark"')' "a${newline}touch $mark" 'x: ; touch '"$mark" '%'; do
    check "goal $(echo "$goal" | tr '\n' ' ' | cut -c 1-12)..." refused "$goal"
    check "... from elsewhere" refused -f "$root/Makefile" -C / "$goal"
done
check "a goal that is none is told" refused nosuch
check "... by its name" grep -q "^there is no target nosuch" "$TMP/said"
done_testing
