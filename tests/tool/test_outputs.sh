#!/bin/sh
# test_outputs.sh - no output replaces what is read; pictures in the format of their name
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
has() { grep -q -- "$1" "$2"; } # pattern, file

# ---- the tool: what is read is never overwritten ----
cp scenes/texture/*.png scenes/texture/hall.nff scenes/paper5.nff "$TMP"
cp "$TMP/tiles.png" "$TMP/tiles-0001.png"
sed 's/tiles\.png/tiles-0001.png/' "$TMP/hall.nff" >"$TMP/moving.nff"
cp "$TMP/moving.nff" "$TMP/moving-0002.nff"
"$s" build "$TMP/paper5.nff" -o "$TMP/five.sph" >"$TMP/text"
"$s" render "$TMP/five.sph" --size=8x8 -o "$TMP/x.png" >"$TMP/text" 2>&1
"$s" render "$TMP/paper5.nff" --size 9x9 --frame "$TMP/five.frame" -o "$TMP/five.png" >"$TMP/text"
ln -s five.sph "$TMP/link.sph"
ln "$TMP/five.sph" "$TMP/hard.sph"
ln "$TMP/paper5.nff" "$TMP/hard.nff"
# The images of hall.nff in their order.
images=$(grep -o '[^ ]*\.png' "$TMP/hall.nff" | awk '!seen[$0]++')
printf 'HETATM    1  C   LIG A   1       1.0     2.0     3.0  1.00  0.00           C\n' \
    >"$TMP/atom.pdb"
mkdir "$TMP/drawn"
cp "$TMP/paper5.nff" "$TMP/drawn/way_rect.png"
kept() { # the file at stake, command of the tool
    cp "$1" "$TMP/copy"
    file=$1
    shift
    fails 1 "refused: $*" "$s" "$@"
    check "... and named" has "would overwrite .*, which is read" "$TMP/err"
    check "... and whole" cmp "$TMP/copy" "$file"
}
{ echo 'scene a' && cat "$TMP/paper5.nff"; } >"$TMP/sheet.nff"
cd "$TMP" || exit 1
kept sheet.nff build sheet.nff:a -o sheet.nff
kept paper5.nff render paper5.nff --frame paper5.nff --size 8x8
kept paper5.nff render paper5.nff --json ./paper5.nff --size 8x8
kept paper5.nff build paper5.nff -o ../test_outputs.sh/paper5.nff
kept paper5.nff accuracy paper5.nff --size 8x8 --json paper5.nff
kept paper5.nff texels paper5.nff --size 8x8 --json paper5.nff
for image in $images; do
    kept "$image" render hall.nff --size 8x8 -o "$image"
done
kept tiles-0001.png render moving.nff --size 8x8 --frames 0..2 -o tiles.png
kept moving-0002.nff build moving-0002.nff --frames 0..2 -o moving.nff
kept five.sph info five.sph --json link.sph
kept five.sph render link.sph --frame five.sph
kept hard.sph info five.sph --json hard.sph
kept five.sph render hard.sph --frame five.sph
kept hard.nff build paper5.nff -o hard.nff
kept five.frame compare five.frame five.frame -d five.png --json five.frame
kept atom.pdb import atom.pdb -o atom.pdb
kept drawn/way_rect.png background drawn/way_rect.png --size 8x8 --pictures drawn
twice() { # command of the tool, two of whose outputs are one file
    fails 1 "refused: $*" "$s" "$@"
    check "... as written twice" has "would overwrite .*, which is written too" "$TMP/err"
    check "... and nothing is written" sh -c '! ls two* 2>"$0"' "$TMP/text"
}
twice build paper5.nff -o two.sph --json ./two.sph
twice render paper5.nff --size 8x8 -o two.png --frame two.png
twice render paper5.nff --size 8x8 -o two.png --exr two.exr --json "$TMP/two.exr"
twice accuracy paper5.nff --size 8x8 -d two.png --frame two.png
check "an option given twice is its last" "$s" render paper5.nff --size 8x8 -o q.png -o q.png
check "no frame of a refused sequence is there" sh -c '! ls tiles-000[02].png'

# ---- the tool: - is standard output, and text then goes to standard error ----
for command in "render --transfer srgb" reference; do
    "$s" $command paper5.nff --size 21x13 -o - >dash 2>text2
    "$s" $command paper5.nff --size 21x13 -o dash.png >text
    check "$command -o -: nothing but the picture" cmp dash.png dash
    check "... the text elsewhere" has '^picture ' text2
done
"$s" build paper5.nff --size 8x8 -o - >dash 2>text2
"$s" build paper5.nff --size 8x8 -o dash.sph >text
check "build -o -: nothing but the machine" cmp dash.sph dash
check "... the text elsewhere" has '^effect ' text2
fails 1 "two files for standard output" "$s" render paper5.nff --size 8x8 -o - --json -

# ---- the tool: pictures by the ending of their name ----
"$s" render paper5.nff --size 21x13 -o same.png >text
for ending in png PNG tif tiff ppm bmp tga; do
    "$s" render paper5.nff --size 21x13 -o "p.$ending" >text
    check "a picture .$ending has every colour" "$s" compare same.png "p.$ending"
done
check "no two of them are the same kind of file" sh -c \
    '[ "$(for e in png tif ppm bmp tga; do head -c 2 p.$e | od -x; done | sort -u | wc -l)" = 6 ]'
"$s" render paper5.nff --size 64x36 -o light.png >text
"$s" render paper5.nff --size 64x36 -o light.jpg >text
check "a picture .jpg is JPEG" sh -c \
    'oiiotool --info light.jpg | grep "64 x *36, 3 channel, uint8 jpeg"'
check "... and near" oiiotool light.png light.jpg --fail 0.2 --failpercent 2 --diff
"$s" render paper5.nff --size 64x36 -o by_name.exr >text
"$s" render paper5.nff --size 64x36 --exr by_option.exr >text
check "a picture .exr is what --exr writes" cmp by_name.exr by_option.exr
for bad in "-o p.nff" "--exr p.png" "--walk p.jpg" "--walk p.exr" "--walk p.gif"; do
    # shellcheck disable=SC2086  # options on purpose
    fails 2 "render $bad" "$s" render paper5.nff --accel bih --size 8x8 $bad
done
check "... says what there is" has "p.gif: no picture is written as .gif; endings are png, tif," err
fails 2 "compare -d p.jpg" "$s" compare five.frame five.frame -d p.jpg
fails 2 "accuracy -d p.jpg" "$s" accuracy paper5.nff --size 8x8 -d p.jpg
check "a folder of pictures is made" "$s" background paper5.nff --size 8x8 --pictures new
check "... and filled" test -s new/way_exact2.png

# ---- what reads and writes pictures is loaded when it is needed ----
check "the tool starts without OpenImageIO" sh -c '! ldd "$0" | grep -q OpenImageIO' "$s"
mkdir alone && cp "$s" alone/sphaera
for name in a.png a.ppm; do
    check "without it the tool writes $name" alone/sphaera render paper5.nff --size 8x8 -o "$name"
done
fails 1 "... and says what is missing" alone/sphaera render paper5.nff --size 8x8 -o alone.tif
check "... by its path" has "sphaera: alone.tif: .*alone/sphaera_image.so: cannot open" err
check "... and leaves no picture" test ! -e alone.tif
fails 1 "the same of reading" alone/sphaera compare a.png a.ppm
check "... by its path" has "sphaera: a.png: .*alone/sphaera_image.so: cannot open" err
done_testing
