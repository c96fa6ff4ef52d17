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
