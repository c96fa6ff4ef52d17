#!/bin/sh
# test_interpenetrate.sh - first hits mended by the mirror ray are the nearest hits, pixel by pixel
# SPDX-License-Identifier: Apache-2.0
#
# Borodavka et al. VI.D, Figure 12: a surface that lies in another sphere is void; all spheres that
# the mirror ray finds are asked, not the nearest alone.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

frame() { # scene, file, more options
    scene=$1 to=$2
    shift 2
    "$SPHAERA" render "$scene" --size 320x180 --profile standard --tree paper "$@" -o "$to" 2>&1
}
mended() { # scene
    frame "$1" "$TMP/nearest.png" --traverse nearest >"$TMP/log" &&
        frame "$1" "$TMP/first.png" --traverse first >"$TMP/log" &&
        frame "$1" "$TMP/bare.png" --traverse first --interpenetrate off >"$TMP/log" &&
        "$SPHAERA" compare "$TMP/nearest.png" "$TMP/first.png" &&
        ! "$SPHAERA" compare "$TMP/nearest.png" "$TMP/bare.png"
}
for scene in scenes/interpenetrating.nff scenes/paper100.nff random:256; do
    check "$scene: every void surface is found, and there are some" mended "$scene"
done
done_testing
