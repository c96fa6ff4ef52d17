#!/bin/sh
# test_beside.sh - what scripts and make write is whole or not there, and follows no planted link
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD
newline='
'

# ---- sim/beside.sh ----
cat >"$TMP/put.sh" <<'END'
. sim/beside.sh
to=$1 letter=$2
beside "$to"
for n in 1 2 3 4 5 6 7 8; do printf '%s\n' "$letter$letter$letter$letter"; done >"$new"
[ "${3:-}" != fails ] || exit 3
[ "${3:-}" != waits ] || { sleep 30 & echo $!; wait; }
named "$to"
END
put() { sh "$TMP/put.sh" "$@"; }
mkdir "$TMP/odd"
odd="$TMP/odd/a b';(&)\$x${newline}é"
check "a file of any name" put "$odd" a
check "... is there" [ "$(sort -u "$odd")" = aaaa ]
with_umask() (
    umask "$1"
    put "$TMP/odd/rights" a && [ "$(stat -c %a "$TMP/odd/rights")" = "$2" ]
)
check "rights are those of a new file" with_umask 022 644
check "... and with another umask" with_umask 027 640
fails_put() { # file
    put "$1" b fails
    [ $? -eq 3 ]
}
check "a command that fails" fails_put "$odd"
check "... leaves what was there" [ "$(sort -u "$odd")" = aaaa ]
ended_put() {
    sh "$TMP/put.sh" "$odd" c waits >"$TMP/ready" &
    pid=$!
    until [ -s "$TMP/ready" ]; do sleep 0.05; done
    kill "$pid"
    wait "$pid"
    rc=$?
    kill "$(cat "$TMP/ready")"
    [ $rc -eq 130 ] && [ "$(sort -u "$odd")" = aaaa ]
}
check "a command that a signal ends leaves it, too" ended_put
many() {
    for letter in d e f g; do
        (for n in $(seq 25); do put "$TMP/odd/many" $letter || exit 1; done) &
    done
    for n in $(seq 50); do
        [ ! -e "$TMP/odd/many" ] || [ "$(uniq "$TMP/odd/many" | grep -c .)" = 1 ] || return 1
    done
    wait
    [ "$(grep -c . "$TMP/odd/many")" = 8 ]
}
check "four at once: the file is one of theirs at every moment" many
check "nothing is left behind" [ "$(find "$TMP/odd" -mindepth 1 -name '.*' | grep -c .)" = 0 ]

# ---- links at names that can be guessed ----
planted() { # files: links at their old temporary names lead to the victim
    echo untouched >"$TMP/victim"
    for file; do
        for ending in tmp new part $(seq -f %.0f $$ $(($$ + 300))); do
            ln -s "$TMP/victim" "$file.$ending"
        done
    done
}
untouched() { [ "$(cat "$TMP/victim")" = untouched ]; }
mkdir "$TMP/lists"
planted "$TMP/lists/sphaera.f" "$TMP/lists/sphaera.core" "$TMP/lists/layout.h" \
    "$TMP/lists/bundles.h" "$TMP/lists/rt_shade.v"
check "lab layout" python3 -m lab layout "$TMP/lists"
check "it writes what is there already" sh -c \
    'cmp "$0/sphaera.f" rtl/sphaera.f && cmp "$0/layout.h" cmodel/machine/layout.h &&
     cmp "$0/bundles.h" tb/bundles.h' "$TMP/lists"
check "... and follows no link" untouched
kept() {
    touch -d 2001-01-01 "$TMP/lists/sphaera.f"
    python3 -m lab layout "$TMP/lists" && [ "$(stat -c %Y "$TMP/lists/sphaera.f")" -lt 1000000000 ]
}
check "a file that stays the same keeps its time" kept

# ---- make ----
mkdir "$TMP/made"
printf 'include %s/make/stamp.mk\nQ := @\n' "$root" >"$TMP/mk"
cat >>"$TMP/mk" <<'END'
B := made
made/%: ; @$(beside) && { echo $*; echo whole; } >$$new/new && $(DO) && mv $$new/new $@
END
made() { # file, command between
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s -C "$TMP" -f mk "made/$1" DO="$2"
}
planted "$TMP/made/x"
check "a target" made x true
check "... is whole" grep -q whole "$TMP/made/x"
check "... follows no link" untouched
check "... and has the rights of a new file" [ "$(stat -c %a "$TMP/made/x")" = \
    "$(printf %o $((0666 & ~0$(umask))))" ]
check "one that fails" sh -c '! "$@"' - env -u MAKEFLAGS make -s -C "$TMP" -f mk made/y DO=false
check "one that a signal ends" sh -c '! "$@"' - env -u MAKEFLAGS make -s -C "$TMP" -f mk made/z \
    'DO=kill $$$$'
check "neither is there, and nothing beside" [ "$(find "$TMP/made" ! -name 'x*' | grep -c .)" = 1 ]
twice() {
    made w "sleep 0.2" &
    made w "sleep 0.1" && wait $! && grep -q whole "$TMP/made/w"
}
check "two at once" twice
done_testing
