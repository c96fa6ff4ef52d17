#!/bin/sh
# film.sh - what the frames of a film are made of: one folder for each film
# SPDX-License-Identifier: Apache-2.0
#
# usage: SCENE=... FRAMES=A..B BUILD_OPTIONS=... SEED=n BUILD=folder sim/film.sh
# Prints the folder, BUILD/film/DIGEST. It gets the files `scene`, the scene's name, `options`,
# words of `sphaera render`, and `frames`, the pictures that make/view.mk makes, one for each frame.
set -euf
cd "$(dirname "$0")/.."
case $FRAMES in
*..*) first=${FRAMES%..*} last=${FRAMES#*..} ;;
*) first=$FRAMES last=$FRAMES ;;
esac
case $first+$last in
*[!0-9+]* | +* | *+) first=1 last=0 ;;
esac
[ "$first" -le "$last" ] || {
    echo "FRAMES=$FRAMES: is no range of frames such as 0..9" >&2
    exit 2
}
scene=$(sim/scene.py "$SCENE")
made=
file=$scene
[ -f "$file" ] || file=${scene%:*}
[ -f "$file" ] || made=$SEED
folder=$BUILD/film/$({
    printf '%s ' "$scene" "$made"
    echo "$BUILD_OPTIONS"
    [ -n "$made" ] || cat "$file"
} | sha256sum | cut -c 1-12)
mkdir -p "$folder"
[ -z "$made" ] || {
    "$BUILD/sphaera" gen "$scene" --seed "$SEED" -o "$folder/scene.nff" >"$folder/gen.log"
    scene=$folder/scene.nff
}
printf '%s\n' "$scene" >"$folder/scene"
. sim/beside.sh
beside "$folder/options"
echo "$BUILD_OPTIONS" >"$new"
named_anew "$folder/options"
seq "$first" "$last" | sed "s,.*,$folder/&.png," >"$folder/frames"
echo "$folder"
