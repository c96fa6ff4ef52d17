#!/bin/sh
# test_scale.sh - one scene at every scale, far from the origin, through every angle, from far away
# SPDX-License-Identifier: Apache-2.0
#
# Each is drawn in the profile that auto takes and compared with the reference: 45 dB at least.
set -u
. "$(dirname "$0")/../tap.sh"
root=$(pwd)
cd "$TMP" || exit 1

# scenes/paper5.nff times `by` plus `plus`; the eye at `eye` on the z axis unless 0; degrees `angle`
scene() { # by, plus, eye, angle
    awk -v by="$1" -v plus="$2" -v eye="$3" -v angle="$4" '
        function at(x) { return sprintf(" %.17g", x * by + plus) }
        $1 == "from" && eye { $4 = eye }
        $1 == "angle" { print "angle", angle; next }
        $1 == "from" || $1 == "at" { print $1 at($2) at($3) at($4); next }
        $1 == "l" { print "l" at($2) at($3) at($4), $5, $6, $7; next }
        $1 == "s" { print "s" at($2) at($3) at($4), $5 * by; next }
        { print }' "$root/scenes/paper5.nff" >x.nff
}
enough() {
    "$SPHAERA" accuracy --size 160x90 x.nff >x.txt 2>&1 || { cat x.txt; return 1; }
    awk '$1 == "psnr" { print; good = $2 == "inf" || $2 >= 45 } END { exit !good }' x.txt
}
while read -r name by plus eye angle; do
    scene "$by" "$plus" "$eye" "$angle"
    check "$name" enough
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
END
scene 1e30 0 0 40
fails 1 "what is too large is refused" "$SPHAERA" accuracy x.nff
check "... by name and line" grep -q "x.nff:5: .from.: z: .* is too large" err
done_testing
