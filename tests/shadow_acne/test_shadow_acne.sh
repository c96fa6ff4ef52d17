#!/bin/sh
# test_shadow_acne.sh - the program that counts falsely dark pixels, and what it says of bad input
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
shadow_acne=${BUILD:-build}/test/shadow_acne

"$SPHAERA" gen cornell -o "$TMP/box.nff" >/dev/null 2>&1
"$shadow_acne" "$TMP/box.nff" draft --show >"$TMP/said"
said() { grep -q "$1" "$TMP/said"; }
check "a room at draft has falsely dark pixels" said '^outwards dark [1-9][0-9]* lit 0$'
check "none by the guarded point" said '^guarded  dark 0 lit 0$'
check "each with its ray and the corners that it shares" [ \
    "$(grep -c '^pixel .* 2 corners in common$' "$TMP/said")" = \
    "$(sed -n 's/^outwards dark \([0-9]*\) .*/\1/p' "$TMP/said")" ]
refused() { # pattern, words
    pattern=$1
    shift
    "$shadow_acne" "$@" 2>"$TMP/err"
    [ $? = 2 ] && grep -q "$pattern" "$TMP/err"
}
check "a profile that is none" refused 'no profile is called drafty' "$TMP/box.nff" drafty
check "a scene that is none" refused 'none.nff' "$TMP/none.nff" draft
check "another word" refused '^usage: shadow_acne' "$TMP/box.nff" draft --shows
done_testing
