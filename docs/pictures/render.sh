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

"$tool" gen sphereflake --size 4 -o "$scenes/far.nff"
sed 's/^angle.*/angle 27/' "$scenes/far.nff" >"$scenes/sphereflake.nff"
"$tool" import /usr/share/pymol/data/demo/1tii.pdb -o "$scenes/molecule.nff"

"$tool" render "$scenes/sphereflake.nff" --profile fine --size 640x360 --depth 4 \
    -o "$to/sphereflake.png"
"$tool" render "$scenes/molecule.nff" --size 640x360 -o "$to/molecule.png"
"$tool" render scenes/paper100.nff --size 480x270 -o "$to/paper100.png"
"$tool" render scenes/materials.nff --size 480x270 --depth 5 -o "$to/materials.png"

# as the paper prints it, and mended: the lower half of the hall
for lod in paper mended; do
    "$tool" render scenes/texture/hall.nff --size 480x270 --lod $lod -o "$scenes/$lod.png"
    oiiotool "$scenes/$lod.png" --cut 300x140+90+100 -o "$scenes/$lod.png"
done
oiiotool "$scenes/paper.png" "$scenes/mended.png" --mosaic:pad=4 2x1 -o "$to/texture_lod.png"
"$tool" render scenes/texture/hall.nff --size 640x360 --profile fine -o "$to/hall.png"
