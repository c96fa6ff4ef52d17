#!/bin/sh
# test_floats.sh - sphaera floats: what float32 and float64 get wrong of a scene's own rays
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA page=docs/results/hard_cases.md
is() { python3 tests/tool/floats.py "$@"; }

# Report and picture of a scene hold together: with its options.
whole() {
    rm -f "$TMP"/[fr].json "$TMP/p.ppm"
    "$s" floats "$@" --json "$TMP/f.json" --picture "$TMP/p.ppm" &&
        "$s" render "$@" --json "$TMP/r.json" >"$TMP/text" &&
        is sums "$TMP/f.json" "$TMP/r.json" && is picture "$TMP/f.json" "$TMP/p.ppm"
}

# ---- scenes: what their rays do, options, what is known of them ----
while IFS='|' read -r what words && IFS= read -r known; do
    # shellcheck disable=SC2086  # a list of words on purpose
    check "$what: tests and rays of the counters, picture" whole $words
    check "... $known" is holds "$TMP/f.json" "$known"
done <<END
spheres, lights, mirrors|scenes/paper5.nff --size 64x36
there["pairs"] and r["shadow"]["all"]["rays"] and not f32["rays"] and not f64["pairs"]
the same in a BIH|scenes/paper5.nff --size 64x36 --accel bih
not f32["rays"] and not f64["rays"] and r["reflected"]["all"]["rays"]
the same in boxes|scenes/paper5.nff --size 64x36 --accel box4
not f32["rays"] and not f64["rays"] and r["reflected"]["all"]["rays"]
facets, mirrors|scenes/facets/room.nff --size 64x36
not f32["rays"] and not f64["rays"] and not f64["roots"] and there["pairs"]
a sphere around the eye|scenes/inside.nff --size 64x36 --inside on
not f64["rays"] and not f64["hits"] and there["hits"]
... which is not seen|scenes/inside.nff --size 64x36 --inside off
not f64["rays"] and not f64["hits"] and there["hits"]
refracted rays|scenes/refraction/nested.nff --size 64x36
r["refracted"]["all"]["rays"] and not r["refracted"]["float64"]["rays"]
rays that end at the first hit|scenes/interpenetrating.nff --size 64x36
not f64["rays"] and there["hits"]
clear facets let light through|scenes/effects/effects.nff:clear_facets
r["shadow"]["all"]["hits"] and not r["shadow"]["float64"]["rays"]
planes that end with the grid; points that were rounded|scenes/facets/plane.nff --profile draft
not f64["rays"] and 0 < there["roots"] < there["hits"] and not r["shadow"]["float32"]["rays"]
equal keys are not wrong|tests/tool/floats/edge.nff --profile draft
there["equal"] == 23 and not f32["rays"] and not f32["equal"]
rays that float32 lets through an edge|tests/tool/floats/edge.nff --profile reference
f32["rays"] == 5 and f32["hits"] == 24 and not f64["hits"]
the eye in a triangle, in both floats|tests/tool/floats/eye_in_triangle.nff --profile reference
pixels == {"float32": 286, "float64": 286, "both": 286}
END

# ---- scenes that another program has counted: the same pixels, in the same places ----
for scene in far gap horizon lens shadow; do
    known=$(awk -v s="$scene" '$2 == s && $4 == "reference" { print $6, $(NF - 7) }' "$page")
    check "$scene: as $page" whole "tests/hard/pictures/$scene.nff" --profile reference
    check "... wrong pixels $known" is holds "$TMP/f.json" \
        "pixels == {'float32': ${known% *}, 'float64': ${known#* }, 'both': 0}"
    case $scene in gap | lens)
        oiiotool "docs/pictures/hard_$scene.png" -o "$TMP/sheet.ppm"
        check "... where docs/pictures/hard_$scene.png has them" is marks "$TMP/p.ppm" \
            "$TMP/sheet.ppm"
        ;;
    esac
done

# ---- words ----
"$s" build scenes/paper5.nff --size 32x18 -o "$TMP/m.sph" >"$TMP/text"
alone() { # on one processor the same
    "$s" floats "$TMP/m.sph" >"$TMP/a" && taskset -c 0 "$s" floats "$TMP/m.sph" >"$TMP/b" &&
        grep -q '^primary   all' "$TMP/a" && cmp "$TMP/a" "$TMP/b"
}
check "a machine, by one thread and by many" alone
fails 2 "no scene" "$s" floats
fails 2 "a picture that would lose something" "$s" floats "$TMP/m.sph" --picture "$TMP/x.jpg"
fails 1 "a picture in place of the machine" "$s" floats "$TMP/m.sph" --json "$TMP/m.sph"
fails 1 "a picture in a folder that is none" "$s" floats "$TMP/m.sph" -p "$TMP/none/x.png"
done_testing
