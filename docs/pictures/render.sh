#!/bin/sh
# render.sh - makes the pictures of this folder with the golden model
# SPDX-License-Identifier: Apache-2.0
#
# usage: sh docs/pictures/render.sh [FOLDER]      from the repository's root, after `make tool`
# SPHAERA is the tool, build/sphaera if not given. The molecule is in Debian's pymol-data.
set -eu
tool=${SPHAERA:-build/sphaera}
to=${1:-docs/pictures}
scenes=$(mktemp -d)
trap 'rm -rf "$scenes"' EXIT
# The scenes' colours were chosen as bytes of the frame.
draw() { "$tool" render --transfer linear "$@"; }

"$tool" gen sphereflake --size 4 -o "$scenes/far.nff"
sed 's/^angle.*/angle 27/' "$scenes/far.nff" >"$scenes/sphereflake.nff"
"$tool" import /usr/share/pymol/data/demo/1tii.pdb -o "$scenes/molecule.nff"

draw "$scenes/sphereflake.nff" --profile reference --size 640x360 --depth 4 \
    -o "$to/sphereflake.png"
draw "$scenes/molecule.nff" --size 640x360 -o "$to/molecule.png"
"$tool" render examples/tutorial/three.nff --profile draft -o "$scenes/three.png"
oiiotool "$scenes/three.png" --resize:filter=box 384x216 -o "$to/tutorial.png"
draw scenes/paper100.nff --size 480x270 -o "$to/paper100.png"
draw scenes/materials.nff --size 480x270 --depth 5 -o "$to/materials.png"

# as the paper prints it, and mended: the lower half of the hall
for lod in paper mended; do
    draw scenes/texture/hall.nff --size 480x270 --lod $lod -o "$scenes/$lod.png"
    oiiotool "$scenes/$lod.png" --cut 300x140+90+100 -o "$scenes/$lod.png"
done
oiiotool "$scenes/paper.png" "$scenes/mended.png" --mosaic:pad=4 2x1 -o "$to/texture_lod.png"
draw scenes/texture/hall.nff --size 640x360 --profile reference -o "$to/hall.png"

# four spheres of Aroxa 2014: depth 0 to 5, and how many surfaces made a pixel at depth 4 and 5
list=
for depth in 0 1 2 3 4 5; do
    draw scenes/refraction/four.nff --size 240x180 --depth $depth -o "$scenes/$depth.png"
    list="$list $scenes/$depth.png"
done
for depth in 4 5; do
    draw scenes/refraction/four.nff --size 240x180 --depth $depth --depths \
        -o "$scenes/depths$depth.png"
    list="$list $scenes/depths$depth.png"
done
# shellcheck disable=SC2086  # a list of words on purpose
oiiotool $list --mosaic:pad=4 4x2 -o "$to/refraction_depths.png"
draw scenes/refraction/index.nff --size 640x320 --depth 5 -o "$to/refraction_index.png"
draw scenes/refraction/water.nff --size 400x300 --depth 5 -o "$to/refraction_water.png"

# what accuracy costs a scene in time, and where the picture of each profile is off
price=$(make -s price SCENE=paper100 SIZE=320x180 | sed -n 's|^look at file://\(.*\)/price.html|\1|p')
cp "$price/price.svg" "$to/price.svg"
for n in 1 2 3 4; do
    oiiotool "$price/difference-$n.png" --cut 320x180+640+0 -o "$scenes/price$n.png"
done
oiiotool "$scenes/price1.png" "$scenes/price2.png" "$scenes/price3.png" "$scenes/price4.png" \
    --mosaic:pad=4 4x1 -o "$to/price.png"

# the live view, if there is SDL2: in a window that nobody sees
tool=$(realpath "$tool")
here=$(pwd)
if [ -f "${tool%/*}/sphaera_view.so" ]; then
    (cd "$scenes" && SDL_VIDEODRIVER=dummy "$tool" view "$here/scenes/refraction/four.nff" \
        --size 240x180 --depth 4 --script "$here/docs/pictures/view.txt")
    oiiotool "$scenes/rays.png" "$scenes/visits.png" "$scenes/difference.png" --mosaic:pad=4 3x1 \
        -o "$to/view.png"
fi
