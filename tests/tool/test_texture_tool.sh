#!/bin/sh
# test_texture_tool.sh - textures through the tool: images, options, refusals, orders of texels
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
hall=scenes/texture/hall.nff
size="--size 64x36"

has() { grep -qE -- "$1" "$2"; } # pattern, file
# shellcheck disable=SC2086  # options on purpose
picture() { "$s" render "$1" $size $2 | awk '$1 == "picture" { print $2 }'; }
differ() { [ -n "$1" ] && [ -n "$2" ] && [ "$1" != "$2" ]; }
equal() { [ -n "$1" ] && [ "$1" = "$2" ]; }

mkdir "$TMP/images"
python3 -m lab texture-images "$TMP/images"
python3 -m lab texture-scenes "$TMP/images"
for image in scenes/texture/*.png; do
    image=$(basename "$image" .png)
    check "$image.png is what images.py makes" cmp "scenes/texture/$image.png" \
        "$TMP/images/$image.png"
done

for scene in kitchen robot museum; do
    check "$scene.nff is what scenes.py makes" cmp "scenes/texture/$scene.nff" \
        "$TMP/images/$scene.nff"
    check "$scene renders" "$s" render "scenes/texture/$scene.nff" --size 32x18
done

# shellcheck disable=SC2086
"$s" render "$hall" $size -o "$TMP/hall.png" --exr "$TMP/hall.exr" --counters >"$TMP/text" 2>&1
check "a scene with images renders" has 'effect +texture +on +4 primitives .* 3 images' "$TMP/text"
check "it counts texels" has '^texels +[1-9]' "$TMP/text"
check "the EXR has the texture word" sh -c "oiiotool --info -v '$TMP/hall.exr' |
    grep -q 'texture (uint)'"

# shellcheck disable=SC2086
check "build writes a machine" "$s" build "$hall" $size -o "$TMP/hall.sph"
scene=$(picture "$hall" "")
check "machine and scene agree" equal "$scene" "$("$s" render "$TMP/hall.sph" |
    awk '$1 == "picture" { print $2 }')"
for way in "--filter nearest" "--filter bilinear" "--filter level" "--lod paper" "--texture off"; do
    check "$way is another picture" differ "$scene" "$(picture "$hall" "$way")"
done
check "paper's tree and brute force show the same" equal "$scene" \
    "$(picture "$hall" "--tree paper --brute")"
# shellcheck disable=SC2086
"$s" render "$hall" $size --texture off >"$TMP/text" 2>&1
check "textures left out are told" has 'warning: .*texture off: 4 primitives' "$TMP/text"

# shellcheck disable=SC2086
for bits in 8 4 0; do
    "$s" render "$hall" $size --lod-bits $bits -o "$TMP/lod$bits.png" >/dev/null
done
check "8 bits of levels are the machine's" cmp "$TMP/hall.png" "$TMP/lod8.png"
check "4 bits draw another picture" sh -c "! cmp -s '$TMP/hall.png' '$TMP/lod4.png'"
# shellcheck disable=SC2086
"$s" render "$hall" $size --filter level -o "$TMP/level.png" >/dev/null
check "without bits the nearest level is left" cmp "$TMP/level.png" "$TMP/lod0.png"
fails 2 "9 bits" "$s" render "$hall" --lod-bits 9

sed 's/globe.png/nowhere.png/' "$hall" >"$TMP/images/bad.nff"
fails 1 "a missing image" "$s" render "$TMP/images/bad.nff"
line=$(grep -n nowhere "$hall" "$TMP/images/bad.nff" | cut -d: -f2)
check "... with scene, line and file" \
    has "bad.nff:$line: texture: .*nowhere.png: cannot open: No such file" "$TMP/err"
check "... is not read with --texture off" "$s" render "$TMP/images/bad.nff" --texture off \
    --size 16x9

# shellcheck disable=SC2086
"$s" texels "$hall" $size >"$TMP/text" 2>&1
for order in rows tiles morton; do
    check "texels tells the hits of $order" has "^$order( +[0-9.]+){6}\$" "$TMP/text"
done
# shellcheck disable=SC2086
for shape in "1    1" "1    2" "2    4" "4    2"; do
    check "texels tells hits and traffic of $shape" sh -c \
        "[ \$(grep -cE '^ +$shape( +[0-9.]+){6}\$' '$TMP/text') = 2 ]"
done
# The hall has 4 mapping records, so as many lines, and the P_b of all of them in one or two lines.
check "texels tells what P_b alone would miss" has '^P_b alone( +[0-9.]+){6}$' "$TMP/text"
check "mapping records and their P_b" sh -c "'$s' texels '$hall' $size --filter nearest --json - |
    python3 -c 'import json, sys
r = json.load(sys.stdin)
n = r[\"records\"]
assert n[\"lookups\"] == r[\"texels\"] > 4  # one each
assert n[\"map_missed\"] == 6 * [4], n
assert n[\"base_missed\"] in (6 * [1], 6 * [2]), n'"
check "as many lookups with four texels each" sh -c "'$s' texels '$hall' $size --filter level \
    --json - | python3 -c 'import json, sys
r = json.load(sys.stdin)
assert 4 * r[\"records\"][\"lookups\"] == r[\"texels\"] > 0'"
check "texels report" sh -c "'$s' texels '$hall' $size --json - | python3 -c 'import json, sys
r = json.load(sys.stdin)
assert [o[\"order\"] for o in r[\"orders\"]] == [\"rows\", \"tiles\", \"morton\"]
assert all(a >= b for o in r[\"orders\"] for a, b in zip(o[\"missed\"], o[\"missed\"][2:]))
assert sum(r[\"levels\"]) == r[\"texels\"] > r[\"levels\"][0]
assert 0 < r[\"orders\"][1][\"missed\"][5] < r[\"texels\"]
assert len(r[\"shapes\"]) == 9 and r[\"shapes\"][8][\"missed\"][0] is None'"
# shellcheck disable=SC2086
"$s" texels "$hall" $size --filter bilinear >"$TMP/text" 2>&1
check "without MIP-mapping all texels are on level 0" has '^levels, % 100.0( 0.0){11}$' "$TMP/text"
done_testing
