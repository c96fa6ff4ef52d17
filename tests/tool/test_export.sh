#!/bin/sh
# test_export.sh - scenes for POV-Ray, the double reference alone, and pixels that POV-Ray drew
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA

has() { grep -qE -- "$1" "$2"; } # pattern, file
says() { # pattern, command: its output has the pattern, whatever its exit code
    pattern=$1
    shift
    "$@" >"$TMP/said" 2>&1
    cat "$TMP/said"
    has "$pattern" "$TMP/said"
}

# ---- export ----
glass=scenes/refraction/water.nff hall=scenes/texture/hall.nff
check "export says what it wrote" says 'water.pov: 4 spheres, 10 facets, 1 lights, 5 materials' \
    "$s" export $glass --depth 3 --size 64x36 -o "$TMP/water.pov"
check "to standard output is the same" sh -c "'$s' export $glass --depth 3 --size 64x36 |
    cmp - '$TMP/water.pov'"
for pattern in 'assumed_gamma 1 adc_bailout 0 max_trace_level Reflections' '^#version 3.7;' \
    'declare Reflections = 3' '^camera .* right <63\.[0-9]*,' '^// .* \+W64 \+H36 ' \
    '^plane .* Inside\([0-9]\) no_shadow' '^union \{'; do
    check "it has $pattern" has "$pattern" "$TMP/water.pov"
done
check "each sphere once, glass and its shadow" [ "$(grep -c '^sphere' "$TMP/water.pov")" = 4 ]
check "what light passes has none" [ "$("$s" export scenes/effects/effects.nff:clear_facets |
    grep -c no_shadow)" = 2 ]
check "images" says 'hall.pov: 3 spheres, 3 facets' "$s" export $hall -o "$TMP/hall.pov"
check "... by the names that the scene has" has 'image_map . "scenes/texture/globe.png" gamma 1' \
    "$TMP/hall.pov"
check "... on a sphere, a plane and two triangles" [ "$(grep -c '^#if (Ids) Look' \
    "$TMP/hall.pov")" = 4 ]
eye=tests/scenes/refraction/eye_in_glass.nff
check "the shadow of glass around the eye is turned inside out" sh -c "'$s' export $eye |
    grep -c inverse | grep -qx 1"
check "... and of no other" sh -c "! '$s' export scenes/refraction/nested.nff | grep inverse"
"$s" build scenes/paper5.nff --size 8x8 -o "$TMP/m.sph" >"$TMP/said" 2>&1
fails 1 "export of a machine" "$s" export "$TMP/m.sph"
fails 1 "export of nothing" "$s" export "$TMP/missing.nff"
fails 2 "export without a scene" "$s" export
fails 2 "export with 11 reflections" "$s" export $glass --depth 11
fails 2 "export knows no profile" "$s" export $glass --profile fine
cp scenes/paper5.nff "$TMP/p.nff"
fails 1 "export over its scene" "$s" export "$TMP/p.nff" -o "$TMP/p.nff"
check "... leaves it as it was" cmp scenes/paper5.nff "$TMP/p.nff"

# ---- the double reference ----
check "reference" says '^picture [0-9a-f]{16}$' "$s" reference scenes/paper5.nff --size 64x36 \
    -o "$TMP/r.png" --frame "$TMP/r.frame" --exr "$TMP/r.exr"
check "the model differs from it, and is near" sh -c "'$s' render scenes/paper5.nff --size 64x36 \
    --profile reference --frame '$TMP/m.frame' >'$TMP/said' && python3 -c '
from lab.truth import pictures
a, b = (pictures.frame(\"$TMP/\" + n) for n in (\"r.frame\", \"m.frame\"))
assert a[3] == b[3] and 50 < pictures.decibel(a, b) < 80, pictures.decibel(a, b)'"
picture() { "$s" reference "$@" | awk '{ print $2 }'; }
check "one thread and three agree" [ "$(picture $glass -t 1)" = "$(picture $glass -t 3)" ]
check "light above 1 in a mirror" [ "$(picture scenes/paper5.nff)" != \
    "$(picture scenes/paper5.nff --unlimited)" ]
water=scenes/refraction/water.nff
check "all light where all is reflected" [ "$(picture $water --size 64x36)" != \
    "$(picture $water --size 64x36 --total)" ]
check "... and not elsewhere" [ "$(picture scenes/paper5.nff)" = \
    "$(picture scenes/paper5.nff --total)" ]
fails 1 "reference of a machine" "$s" reference "$TMP/m.sph"
fails 2 "reference without a scene" "$s" reference
fails 2 "reference with a layer of 3" "$s" reference $glass --layer 3

# ---- against POV-Ray ----
check "the reference is right where POV-Ray drew" \
    python3 -m lab povray "$s" "$TMP" tests/reference/povray.txt
sed '4s/[0-9]*$/7/' tests/reference/povray.txt >"$TMP/bad.txt"
check "... and a pixel of another colour is noticed" says '1 wrong' \
    python3 -m lab povray "$s" "$TMP" "$TMP/bad.txt"
if command -v povray >"$TMP/which"; then
    check "make truth, one scene" python3 -m lab truth-scenes "$s" "$TMP/truth" cornell
    check "... and the reference sees the same objects" python3 -c "import json
r = json.load(open('$TMP/truth/cornell.json'))['reference']
assert r['wrong'] == 0 and r['psnr'] > 60, r"
    check "... an eye in glass" python3 -m lab truth-scenes "$s" "$TMP/truth" eye_in_glass
    check "... sees what the reference sees" python3 -c "import json
r = json.load(open('$TMP/truth/eye_in_glass.json'))['reference']
assert r['wrong'] == 0 and r['psnr'] > 45, r"
else
    echo "ok $((checks += 1)) - # SKIP there is no povray: make truth-setup"
    check "without POV-Ray make truth says so" says 'no povray here: `make truth-setup`' \
        python3 -m lab truth-scenes "$s" "$TMP/truth"
fi
check "... a scene that is not there" says 'no scene tea; there are: ' \
    env PATH="$TMP/path:$PATH" sh -c "mkdir -p '$TMP/path' && ln -sf /bin/true '$TMP/path/povray' &&
    python3 -m lab truth-scenes '$s' '$TMP/truth' tea"
check "packages of make truth" says '^setup: (every|installing povray)' sh sim/setup.sh --dry-run \
    povray
done_testing
