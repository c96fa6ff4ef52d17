#!/bin/sh
# test_aff_tool.sh - AFF scenes through the tool: import, --at, --time, --frames
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
size="--size 32x18 --profile fine --accel bvh4"

mkdir -p "$TMP/aff" "$TMP/TextureFiles"
printf 'P3 2 2 255 255 0 0 0 255 0 0 0 255 255 255 255\n' >"$TMP/TextureFiles/four.ppm"
cat >"$TMP/aff/ball.aff" <<'END'
fm 0.1 0.1 0.1 0.2 0.6 0.2 0.1 0.1 0.1 20 0 0
s 0 0 0 0.5   % a sphere
END
cat >"$TMP/aff/scene.aff" <<'END'
v from 0 0 6 at 0 0 0 up 0 1 0 angle 30 hither 0.1 resolution 64 36
b 0.1 0.2 0.3
am 2 1 1
l 3 4 5 0.5 0.5 0.5
x fly { xs 0.5 0.5 0.5 0 0 1 0 1 0 0 { i 0 ball.aff } }
fm 0 0 0 1 1 1 0 0 0 0 0 0
m vertices 3 -2 -1 -1 2 -1 -1 0 1 -1 texturecoords 3 four.ppm 0 0 1 0 0.5 1 triangles 1 0 1 2 0 1 2
m vertices 3 -2 -1 -1 2 -1 -1 0 1 -1 triangles 1 1 2 0
a 0 3 4
k fly { transl 4 -1 0 0 0 0 0 0 0 0 0 0 0 0 0 3 0 1 0 0 0 0 4 0 1 0 0 0 0 }
END
scene=$TMP/aff/scene.aff

has() { grep -qE -- "$1" "$2"; } # pattern, file

# shellcheck disable=SC2086
check "a scene of AFF is built" sh -c "'$s' build '$scene' $size -o '$TMP/a.sph' >'$TMP/text' 2>&1"
check "a triangle that stands there twice is left out" \
    has 'scene.aff:8: left out: triangle that stands there twice, 1 time' "$TMP/text"
check "sphere and triangle" has '1 spheres, 1 triangles, 1 lights' "$TMP/text"
check "its image is found beside the folder" has '1 images' "$TMP/text"

check "import writes NFF elsewhere" \
    sh -c "'$s' import '$scene' --at 2 -o '$TMP/scene.nff' >'$TMP/text'"
check "import says what" has '1 spheres, 2 facets, 1 lights, 2 materials' "$TMP/text"
check "the frame" has '^s 1 0.68518518' "$TMP/scene.nff"
# shellcheck disable=SC2086
"$s" build "$TMP/scene.nff" $size -o "$TMP/two.sph" >/dev/null 2>&1
# shellcheck disable=SC2086
check "what is imported is what --at builds" sh -c \
    "'$s' build '$scene' $size --at 2 -o '$TMP/at.sph' >/dev/null 2>&1
     cmp '$TMP/two.sph' '$TMP/at.sph'"
# shellcheck disable=SC2086
check "a frame is a time" sh -c "'$s' build '$scene' $size --time 2 -o '$TMP/time.sph' \
    >/dev/null 2>&1; cmp '$TMP/time.sph' '$TMP/at.sph'"
# shellcheck disable=SC2086
check "a sequence" sh -c "'$s' build '$scene' $size --frames 1..2 -o '$TMP/all.sph' >/dev/null 2>&1
    cmp '$TMP/all-0002.sph' '$TMP/at.sph' && ! cmp -s '$TMP/all-0001.sph' '$TMP/at.sph'"
check "scenes of a sequence" sh -c "'$s' import '$scene' --frames 1..2 -o '$TMP/x.nff' >/dev/null
    cmp '$TMP/x-0002.nff' '$TMP/scene.nff' || diff '$TMP/x-0002.nff' '$TMP/scene.nff'"

# ---- P_b from frame to frame: what stands still keeps it, though the camera goes and turns, where
# the grid's step stays, as it does along the camera's axes here ----
moving=$TMP/aff/moving.aff
mesh='m vertices 3 -1 0 0 1 0 0 0 1 0 texturecoords 3 four.ppm 0 0 1 0 0.5 1'
mesh="$mesh triangles 1 0 1 2 0 1 2"
sed "s/^x fly.*/fm 0 0 0 1 1 1 0 0 0 0 0 0 x fly { $mesh }/" "$scene" >"$moving"
echo 'k camera { transl 4 0 0 0 0 0 0 0 1 0.1 0.2 0 0 0 0 2 0.3 0.1 0.1 0 0 0 3 0.5 0.3 0.2 0 0 0' \
    'rot 4 0 0 1 0 0 0 0 0 1 0 1 0.1 3 0 0 0 2 0.1 1 0 5 0 0 0 3 0 1 0 9 0 0 0 }' >>"$moving"
# shellcheck disable=SC2086
"$s" build "$moving" $size --profile fine --axes camera --frames 1..2 -o "$TMP/keep.sph" \
    --json "$TMP/keep.json" >"$TMP/text" 2>&1
check "of two triangles the one that stands still keeps P_b" python3 -c 'import json, sys
one, two = (f["bases"] for f in json.load(open(sys.argv[1]))["frames"])
assert (one["computed"], one["kept"], two["computed"], two["kept"]) == (2, 0, 1, 1), (one, two)' \
    "$TMP/keep.json"
# shellcheck disable=SC2086
check "it is that of the frame alone" sh -c "'$s' build '$moving' $size --profile fine \
    --axes camera --at 2 -o '$TMP/alone.sph' >/dev/null 2>&1
    cmp '$TMP/alone.sph' '$TMP/keep-0002.sph' &&
    ! cmp -s '$TMP/keep-0001.sph' '$TMP/keep-0002.sph'"

cp "$scene" "${scene%aff}AFF"
check "an ending in capitals" sh -c "'$s' import '${scene%aff}AFF' --at 2 -o - 2>'$TMP/text' |
    grep '^s 1 0.68518518'"
fails 1 "no such frame" "$s" build "$scene" --at 4 -o "$TMP/no.sph"
check "says which there are" has 'frame 4: the animation has frames 0 to 3' "$TMP/err"
fails 1 "frames into standard output" "$s" import "$scene" --frames 1..2
fails 1 "an option of molecules" "$s" import "$scene" --water -o "$TMP/no.nff"
check "says which" has '[-][-]water is for molecules' "$TMP/err"
fails 1 "an option of AFF" "$s" import "$TMP/x.pdb" --at 2
fails 1 "an image as output" "$s" import "$scene" -o "$TMP/TextureFiles/four.ppm"
fails 1 "a part as output" "$s" build "$scene" -o "$TMP/aff/ball.aff"
check "the part is whole" has '^s 0 0 0 0.5' "$TMP/aff/ball.aff"
fails 1 "a part that is missing" sh -c "sed 's/ball/none/' '$scene' >'$TMP/aff/bad.aff'
    '$s' build '$TMP/aff/bad.aff' -o '$TMP/no.sph'"
check "says where" has 'bad.aff:5: `i`: .*none.aff: cannot open' "$TMP/err"
check "nothing is half written" sh -c "! ls '$TMP'/no.*"

# ---- images, in folders of any name, of a scene that is written elsewhere ----
mkdir "$TMP/a b" "$TMP/q\"u" "$TMP/written"
cat >"$TMP/image.aff" <<'END'
v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution 8 5
f 1 1 1 1 0 0 0 1
tt four.ppm 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1
END
for folder in "a b" 'q"u'; do
    cp "$TMP/image.aff" "$TMP/TextureFiles/four.ppm" "$TMP/$folder/"
done
written() ( # image.aff
    cd "$TMP" && rm -f written/* && "$s" import "$1" -o written/x.nff &&
        "$s" build --allow-paths written/x.nff --size 8x5 -o written/m.sph
)
check "an image in a folder with a blank, by a path from here" written "a b/image.aff"
check "... by a whole path" written "$TMP/a b/image.aff"
fails 1 "a name that no scene file can have" "$s" import "$TMP/q\"u/image.aff" -o "$TMP/no.nff"
check "... is told" has 'image .*q"u/four.ppm: a name with a quote' "$TMP/err"
check "... and nothing is written" test ! -e "$TMP/no.nff"
done_testing
