#!/bin/sh
# test_met.sh - `sphaera build` says what no ray of the frame meets, where the scene names it
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
here=tests/scenes/met.nff

# scene; options; what the output must have, a pattern, @:N for N lines below `scene`; the core
while IFS='|' read -r scene options pattern core; do
    pattern=$(awk -v scene="$scene" -v text="$pattern" '
        $0 == "scene " scene { first = NR }
        END {
            while (match(text, /@:[0-9]+/))
                text = substr(text, 1, RSTART - 1) FILENAME ":" \
                       (first + substr(text, RSTART + 2, RLENGTH - 2)) \
                       substr(text, RSTART + RLENGTH)
            print text
        }' $here)
    # shellcheck disable=SC2086  # a list of words on purpose
    "$s" build $here:$scene $options -o "$TMP/m.sph" >"$TMP/text" 2>&1
    check "$scene $options: $pattern" grep -q -- "$pattern" "$TMP/text"
    "$s" info "$TMP/m.sph" >"$TMP/info" 2>&1
    check "... core $core" grep -q "^core *$core\$" "$TMP/info"
    left=$(grep 'left out[ :]' "$TMP/text" | grep -vc 'left out nothing')
    [ "$left" = 0 ] || left=1
    check "... for one camera: $left" \
        test "$(grep -c '^camera *this one alone' "$TMP/info")" = "$left"
done <<'END'
behind||^left out the sphere @:8: no ray of this frame meets it|lights1+camera
behind|--effects all|^effect *reflect *2 *@:7 mirrors 26/256, depth 2$|.*+refract+.*
hidden_mirror||^left out the sphere @:8: no ray of this frame meets it|lights1+camera
light_below||^effect *lights *1 *1 of .* 2; left out: @:3 lights|shadow+lights1+facets+camera
light_below|--effects all|^effect *lights *2 *2 of the scene's 2$|shadow+lights2+facets
light_below|--lights 2|^effect *lights *2 *as asked; 2 of the|shadow+lights2+facets
mirror_behind||^effect *reflect *off left out: @:7 mirrors 128/256, .*; no ray|lights1+camera
mirror_behind|--reflect on|^effect *reflect *2 *as asked; not called for: @:7|reflect2+lights1
mirror_behind|--reflect off|^effect *reflect *off as asked; called for: @:7|lights1
mirror_behind|--size 4096x2160|^left out nothing: there are too many pixels|reflect2+lights1
mirror_behind|--traverse first|^left out nothing: what a primary|reflect2+lights1+first
all_behind||^effect *inside *off left out: .* @:17 and @:18 overlap; no|shadow+lights1+facets+camera
all_behind||^effect *texture *off left out: .* @:11; no ray|shadow+lights1+facets+camera
all_behind||^effect *refract *off left out: @:20 transmits 205/256|shadow+lights1+facets+camera
all_behind||^effect *specular *off left out: @:20 has highlights|shadow+lights1+facets+camera
all_behind||^effect *sum *off left out: @:20 is shaded by|shadow+lights1+facets+camera
all_behind||^effect *smooth *off left out: .* @:13; no ray|shadow+lights1+facets+camera
triangle_behind||^left out the triangle @:6: no ray|lights1+camera
clear_behind||^effect *clear *off left out: @:13 lets .*; no ray|shadow+lights1+facets+camera+boxes
shadow_behind||^effect *shadow *off left out: .*; nothing|lights1+facets+camera+boxes
mirrors_behind|--depth 10|^left out depths beyond 3: no ray|reflect3+lights1+camera
mirrors_behind|--depth 4|^effect *camera *off|reflect4+lights1
mirrors_behind|--depth 10 --reflect on|^effect *reflect *10 *as asked|reflect10+lights1
END

# What makes the grid coarse no longer does.
grid() {
    "$s" build $here:$1 --profile standard --effects $2 -o "$TMP/m.sph" 2>/dev/null |
        sed -n 's/^grid *step \([^,]*\),.*/\1/p'
}
check "a light under the floor: a coarse grid with it" test "$(grid light_below all)" = 0.0078125
check "... fine without it" test "$(grid light_below met)" = 0.00390625
check "a ball far behind: a coarse grid with it" test "$(grid behind all)" = 0.000976562
check "... fine without it" test "$(grid behind met)" = 0.000488281
check "a floor keeps such a ball, which makes the grid wide" \
    test "$(grid far_behind_floor met)" = "$(grid far_behind_floor all)"

# Frames: all of them count.
later() {
    "$s" build $here:comes_later --frames "$1" $2 -o "$TMP/f.sph" >"$TMP/text" 2>&1 &&
        "$s" info "$TMP/f-0000.sph" | grep -q "^core *$3\$"
}
check "a mirror that comes with frame 2 is not in frames 0 and 1" later 0..1 "" lights1+camera
check "... says so" grep -q "^left out reflect: $here:[0-9]* mirrors" "$TMP/text"
check "... is in frame 0 of 0 to 2" later 0..2 "" reflect2+lights1
check "... if all is asked for" later 0..1 "--effects all" reflect2+lights1

# Other commands that build keep everything: render draws what it always drew.
picture() { "$s" render "$@" -o "$TMP/p.png" 2>/dev/null | grep '^picture'; }
"$s" build $here:all_behind -o "$TMP/m.sph" >"$TMP/text" 2>&1
check "render of a scene" test "$(picture $here:all_behind)" = "$(picture "$TMP/m.sph")"
fails 2 "--effects some" "$s" build $here:behind --effects some -o "$TMP/m.sph"
fails 1 "--effects for a machine" "$s" render "$TMP/m.sph" --effects all -o "$TMP/p.png"
done_testing
