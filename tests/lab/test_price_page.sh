#!/bin/sh
# test_price_page.sh - make price: table, page and picture of cores whose cells are known
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
made() {
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory B="$BUILD" JOBS=1 "$@"
}
check "a scene whose cores nobody has made" made price SCENE=sphereflake2 SIZE=64x36
cp "$TMP/out" "$TMP/said"
says() { grep -qE -- "$1" "$TMP/said" || { cat "$TMP/said" && return 1; }; }
check "nothing is synthesised for it" sh -c "! grep -q SYNTH '$TMP/said'"
check "a row a profile, estimated" says \
    '^  draft .* ~14[0-9]+ +~64 +~[0-9]+ +~133.2( +~[0-9.]+){2}$'
check "... and says so" says '^~: *estimated'
check "one is marked" says '^\* (draft|standard|fine|reference) .*[0-9]$'
check "energy is estimated, and it says so" says '^energy: as standard cells.*make silicon'
page=$(sed -n 's|^look at file://||p' "$TMP/said")
check "it ends with where to look" [ -f "$page" ]
check "the page has the plot and four pictures, and needs no other file" sh -c "
    grep -q '<svg' '$page' && [ \$(grep -o 'data:image/png;base64' '$page' | wc -l) = 4 ] &&
    ! grep -qE '(src|href)=\"[^\"d]' '$page'"
check "milliseconds are clocks over the clock" python3 - "$page" <<'END'
import json, sys
price = json.load(open(sys.argv[1].replace(".html", ".json")))["price"]
for row in price["rows"]:
    ms = row["cycles_per_pixel"] * 64 * 36 / row["clock"]["median"] / 1000
    assert abs(row["milliseconds"] - ms) < 1e-9, (row, ms)
END
refuses() { # words, arguments of make
    want=$1
    shift
    ! made "$@" >"$TMP/said" 2>&1 && says "$want"
}
check "RTL is 0 or 1" refuses 'RTL=2: ' price RTL=2
check "RTL=1 is for make price" refuses 'RTL=1: ' sim RTL=1
done_testing
