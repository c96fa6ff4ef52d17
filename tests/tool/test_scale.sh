#!/bin/sh
# test_scale.sh - one scene at every scale, far from the origin, through every angle, from far away
# SPDX-License-Identifier: Apache-2.0
#
# Each is drawn in the profile that auto takes and compared with the reference: 45 dB at least.
# SCALE=FILE gets a line of each: name, dB, pixels that show another object (make truth).
set -u
. "$(dirname "$0")/../tap.sh"
root=$(pwd)
cd "$TMP" || exit 1

# scenes/paper5.nff times `by` plus `plus`; the eye at `eye` on the z axis unless 0; degrees
# `angle`; the light so many times as far away
scene() { # by, plus, eye, angle, light
    awk -v by="$1" -v plus="$2" -v eye="$3" -v angle="$4" -v light="${5:-1}" '
        function at(x) { return sprintf(" %.17g", x * by + plus) }
        $1 == "from" && eye { $4 = eye }
        $1 == "angle" { print "angle", angle; next }
        $1 == "from" || $1 == "at" { print $1 at($2) at($3) at($4); next }
        $1 == "l" { print "l" at(light * $2) at(light * $3) at(light * $4), $5, $6, $7; next }
        $1 == "s" { print "s" at($2) at($3) at($4), $5 * by; next }
        { print }' "$root/scenes/paper5.nff" >x.nff
}
# Of a scene: its dB and how many pixels show another object, silhouettes among them.
judge() { # words of the command
    "$SPHAERA" accuracy "$@" >x.txt 2>&1 || { cat x.txt; return 1; }
    awk '$1 == "psnr" { dB = $2 } $1 == "wrong" { n = $3 + $6 } END { print dB, n }' x.txt
}
enough() { # name
    said=$(judge --size 160x90 x.nff) || { echo "$said"; return 1; }
    echo "$said"
    [ -z "${SCALE:-}" ] || echo "$1 $said" >>"$SCALE"
    [ "${said% *}" = inf ] || awk -v dB="${said% *}" 'BEGIN { exit !(dB >= 45) }'
}
fewer() { # pixels, words of the command
    most=$1
    shift
    said=$(judge "$@") || { echo "$said"; return 1; }
    echo "$said"
    [ "${said#* }" -le "$most" ]
}
while read -r name by plus eye angle light; do
    scene "$by" "$plus" "$eye" "$angle" "$light"
    check "$name" enough "$name"
done <<END
as_it_is 1 0 0 40
scale_1e-30 1e-30 0 0 40
scale_1e-6 1e-6 0 0 40
scale_1e6 1e6 0 0 40
offset_1e6 1 1e6 0 40
offset_1e9 1 1e9 0 40
offset_1e12 1 1e12 0 40
angle_0.03 1 0 0 0.03
angle_1 1 0 0 1
angle_150 1 0 0 150
angle_179 1 0 0 179
eye_1e3 1 0 1e3 3.4
eye_1e4 1 0 1e4 0.34
eye_1e5 1 0 1e5 0.034
eye_1e6 1 0 1e6 0.0034
eye_1e7 1 0 1e7 0.00034
eye_1e12 1 0 1e12 3.4e-9
eye_on_a_sphere 1 0 -5.546875 40
light_10 1 0 0 40 10
light_1e3 1 0 0 40 1e3
light_1e9 1 0 0 40 1e9
END
cp "$root/tests/scenes/facets/six.nff" x.nff
check "a room of six planes" enough room_of_six_planes
{ sed '/^f /,$d' "$root/scenes/paper5.nff" &&
    printf '%s\n' 'f 0.8 0.7 0.5 1 0 0 0 1' 'plane 0 -30 0 0 1 0' 'f 0.9 0.3 0.2 1 0 0 0 1' \
        's 0 -10 -30 20'; } >x.nff
check "a ball over a plane without end" enough ball_over_a_plane
check "of two planes beyond the grid the nearer one is seen" \
    fewer 0 --size 320x180 --depth 4 "$root/scenes/refraction/nested.nff"
"$SPHAERA" gen tree:4 -o tree.nff >/dev/null
check "what vanishes on a coarse grid leaves the others their numbers" \
    fewer 300 --size 160x90 --profile draft tree.nff
"$SPHAERA" gen cover -o x.nff >/dev/null
check "a ground of radius 1000" enough cover
scene 1e30 0 0 40
fails 1 "what is too large is refused" "$SPHAERA" accuracy x.nff
check "... by name and line" grep -q "x.nff:5: .from.: z: .* is too large" err
done_testing
