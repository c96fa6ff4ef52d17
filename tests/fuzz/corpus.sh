#!/bin/sh
# corpus.sh - the inputs that fuzzers begin with, and the words of their formats
# SPDX-License-Identifier: Apache-2.0
#
# usage: tests/fuzz/corpus.sh TOOL FOLDER
# Scenes are those of tests/fuzz/corpus and small ones of scenes/, command lines those of corpus.py;
# machine files, frame files and images are made of scenes by the tool. FOLDER/NAME has the inputs
# of a harness.
set -eu
tool=$1 to=$2
cd "$(dirname "$0")/../.."
for name in nff aff pdb mesh machine frame options image; do
    mkdir -p "$to/$name"
    [ ! -d "tests/fuzz/corpus/$name" ] || cp tests/fuzz/corpus/"$name"/* "$to/$name/"
done
python3 tests/fuzz/corpus.py "$to"
cp scenes/effects/effects.nff scenes/one_sphere.nff scenes/refraction/*.nff "$to/nff/"
awk -v to="$to/nff/" '/^scene / { name = to $2; printf "%s", common >name; next }
    name { print >name; next } { common = common $0 "\n" }' scenes/effects/effects.nff
for scene in effects/effects.nff:reflect_smooth effects/effects.nff:interpenetrate \
    effects/effects.nff:lights refraction/four.nff facets/plane.nff inside.nff empty.nff; do
    name=${scene##*[/:]} name=${name%.nff}
    for accel in bvh4 box4 bih brute; do
        "$tool" build "scenes/$scene" --size 8x5 --accel $accel \
            -o "$to/machine/$name-$accel" >/dev/null
    done
    "$tool" render "$to/machine/$name-bih" --frame "$to/frame/$name" >/dev/null
done
for way in rect spans exact; do
    "$tool" build scenes/inside.nff --size 8x5 --background $way --depth 5 \
        -o "$to/machine/inside-$way" >/dev/null
done
for profile in draft fine reference; do
    "$tool" build scenes/effects/effects.nff:sum --size 8x5 --profile $profile \
        -o "$to/machine/sum-$profile" >/dev/null
done
for ending in png tif ppm bmp tga jpg exr; do
    "$tool" render "$to/machine/inside-bih" -o "$to/image/x.$ending" >/dev/null
done
printf 'P2\n3 2\n255\n0 1 2 3 4 255\n' >"$to/image/grey.pgm"
printf 'GIF89a\1\0\1\0\200\0\0\0\0\0\377\377\377,\0\0\0\0\1\0\1\0\0\2\2D\1\0;' >"$to/image/x.gif"
