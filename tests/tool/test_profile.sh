#!/bin/sh
# test_profile.sh - what is expected of a profile before it is drawn, against what is drawn
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
has() { grep -q -- "$1" "$2"; }

# ---- every scene in every profile: no picture is worse than was expected ----
python3 tests/tool/profile.py cover >"$TMP/cover.nff"
"$s" gen sphereflake:4 -o "$TMP/flake.nff" >"$TMP/text"
"$s" gen scenario1 -n 64 -o "$TMP/many.nff" >"$TMP/text"
measure() {
    for scene in "$TMP"/*.nff tests/tool/*.nff scenes/*.nff scenes/facets/*.nff \
        scenes/refraction/*.nff scenes/texture/*.nff scenes/views/*.nff; do
        depth=
        case $scene in *planes_in_glass*) depth="--depth 5" ;; esac
        for profile in draft standard fine reference; do
            echo "run $(basename "$scene" .nff) $profile"
            # shellcheck disable=SC2086  # an option or none
            "$s" accuracy "$scene" --profile "$profile" --size 240x135 $depth 2>&1
        done
    done
}
measure >"$TMP/runs"
check "nothing is worse than expected" python3 tests/tool/profile.py expected "$TMP/runs"
check "... of 20 scenes and more" sh -c \
    "python3 tests/tool/profile.py expected '$TMP/runs' | awk -F'|' 'NF > 5 { n[\$2] } END {
        exit length(n) < 20 }'"
check "a wrong expectation is noticed" sh -c "awk '/^expected/ { \$2 += 12; \$4 /= 9 } { print }' \
    '$TMP/runs' >'$TMP/wrong'; python3 tests/tool/profile.py expected '$TMP/wrong' |
    [ \$(grep -c worse) -gt 20 ]"

# ---- auto: the cheapest that keeps what is asked for ----
takes() { # profile, scene, options
    profile=$1
    shift
    "$s" build "$@" --profile auto -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err" || return 1
    cat "$TMP/text" "$TMP/err"
    "$s" info "$TMP/x.sph" | grep -q "^profile   $profile: " &&
        [ "$(grep -c '^profile  ' "$TMP/text")" = 1 ] && has "^profile  $profile" "$TMP/text" &&
        ! has "pixels off" "$TMP/err"
}
check "one sphere" takes draft scenes/one_sphere.nff --size 64x36
check "five" takes standard scenes/paper5.nff --size 320x180
check "7381, with a floor" takes fine "$TMP/flake.nff" --size 320x180
check "a ground of radius 1000 under spheres of 0.2" takes reference "$TMP/cover.nff"
check "half the pixels, as far off" takes draft scenes/paper5.nff --size 32x18 --error 0.125,30
check "less is asked for" takes standard "$TMP/flake.nff" --size 320x180 --error 1,30
check "less is asked for: pixels alone count" takes fine "$TMP/flake.nff" --size 320x180 \
    --error 0.01,0
check "a profile that does not hold the scene gives way" takes standard scenes/huge_tiny.nff \
    --error 100,0
drawn() { # profile, dB, scene: what auto draws is as good
    "$s" accuracy "$3" --profile auto --size 320x180 >"$TMP/text" 2>&1
    cat "$TMP/text"
    has "profile $1$" "$TMP/text" && awk -v least="$2" '$1 == "psnr" { is = $2 }
        END { exit !(is >= least) }' "$TMP/text"
}
check "the flake is drawn true to 45 dB" drawn fine 45 "$TMP/flake.nff"
check "the ground and its spheres too" drawn reference 45 "$TMP/cover.nff"
if [ -f /usr/share/pymol/data/demo/1tii.pdb ]; then
    "$s" import /usr/share/pymol/data/demo/1tii.pdb -o "$TMP/protein.nff" >"$TMP/text"
    check "a protein too" drawn fine 45 "$TMP/protein.nff"
fi
"$s" build scenes/texture/robot.nff --profile auto --frames 0..2 -o "$TMP/m.sph" >"$TMP/text" 2>&1
for frame in 0 1 2; do "$s" info "$TMP/m-000$frame.sph" | grep -o 'profile [a-z]*'; done |
    sort -u >"$TMP/profiles"
check "frames of a sequence have one profile" [ "$(wc -l <"$TMP/profiles")" = 1 ]
check "... and it is told of which it was measured" has \
    "^profile  [a-z]*: measured .*; so frame [012], which asks for most of 0, 1 and 2$" "$TMP/text"

# ---- what is measured is what accuracy says, and is not below what is promised ----
measured() { # scene, size
    "$s" build "$1" --size "$2" -o "$TMP/x.sph" --json "$TMP/b.json" >"$TMP/text" 2>&1 &&
        "$s" accuracy "$1" --size "$2" --effects met --json "$TMP/a.json" >"$TMP/text" 2>&1 &&
        python3 - "$TMP" <<'END'
import json, sys
b, a = (json.load(open(f"{sys.argv[1]}/{name}.json")) for name in "ba")
m, of = b["build"]["measured"], a["accuracy"]
whole, all_of = m["pixels"] == of["pixels"] - of["undecidable"], m["of"] == of["pixels"]
print(b["build"]["profile_why"], of["psnr"][-1])
told = f"measured {m['psnr']:.1f} dB of" if m["psnr"] else "measured no difference in"
told += f" {m['pixels']} pixels"
if m["psnr"] is None:  # equal
    m["psnr"] = m["psnr_least"] = of["psnr"][-1] = 99
sys.exit(not (b["machine"]["profile"] == a["machine"]["profile"] and all_of and
              told in b["build"]["profile_why"] and (
                  m["psnr"] == m["psnr_least"] and abs(m["psnr"] - of["psnr"][-1]) < 1e-9 if whole
                  else 45 <= m["psnr_least"] < min(m["psnr"], of["psnr"][-1]) and
                  f"at least {m['psnr_least']:.1f} dB of all {m['of']} with 97.5 % confidence" in
                  b["build"]["profile_why"])))
END
}
check "glass" measured scenes/refraction/nested.nff 160x90
"$s" gen icosphere:4 | sed 's/^from .*/from 0 0 3.2/; s/^at .*/at 0 0 0/' >"$TMP/ball.nff"
check "edges seen head-on, which hit pixels four at a time" measured "$TMP/ball.nff" 160x90
check "images" measured scenes/texture/hall.nff 160x90
check "without what no ray meets" measured tests/scenes/met.nff:light_below 160x90
check "pixels that cannot be told" measured tests/scenes/coincident/wall.nff 160x90
check "a sample of a large frame" measured scenes/paper5.nff 1024x576
estimated() { # why, options
    why=$1
    shift
    "$s" build "$@" -o "$TMP/x.sph" --json "$TMP/j.json" >"$TMP/text" 2>&1 &&
        has "^profile  .*: expected [0-9.]* dB, a mean, .*; not measured: $why" "$TMP/text" &&
        ! has '"measured"' "$TMP/j.json"
}
check "first hits are not what double precision draws" estimated "first hits" scenes/paper100.nff \
    --traverse first
check "nor is what options leave out" estimated "options leave out" scenes/paper100.nff \
    --inside off
check "shadows that are off are off there, too" takes standard scenes/paper5.nff --shadow off

# ---- none keeps it: what would help was tried ----
"$s" build scenes/huge_tiny.nff --error 0.125,60 -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err"
check "the finest, and what it misses" has "^profile  reference, the finest: .* misses" "$TMP/text"
check "... is a warning" has "reference: measured 55.8 dB .*: no profile keeps that" "$TMP/err"
followed() { # the advice, and its figure
    line=$(sed -n 's/.*huge_tiny.nff:\([0-9]*\) smaller, .*/\1/p' "$TMP/err")
    sphere=$(sed -n 's/.* smaller, s \([^:]*\): .*/\1/p' "$TMP/err")
    sed "${line}s/.*/s $sphere/" scenes/huge_tiny.nff >"$TMP/small.nff" &&
        "$s" accuracy "$TMP/small.nff" --profile reference >"$TMP/text" 2>&1 &&
        is=$(awk '$1 == "psnr" { printf "%.1f", $2 }' "$TMP/text") && echo "$line $sphere $is" &&
        has "helps: with the sphere .* measured $is" "$TMP/err"
}
check "... the advice can be followed, and gives what it says" followed

cat >"$TMP/own.nff" <<'END'
v
from 0 1.2 6
at 0 0.8 0
up 0 1 0
angle 45
hither 0.1
resolution 320 180
b 0.5 0.7 1
l 500 800 400
f 0.6 0.6 0.55 0.9 0.1 0 0 1
plane 0 0 0 0 1 0
f 1 1 1 0.05 0.1 0 0.9 1.5
s -1 0.8 1 0.8
f 0.9 0.9 0.9 0.1 0.9 0 0 1
s 1.2 1 -1 1
f 0.8 0.2 0.2 1 0 0 0 1
p 3
-3 0 -3
-1 0 -4
-2 2 -3
END
"$s" build "$TMP/own.nff" -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err"
light=$(sed -n 's/.*would do: with the light .* nearer, \(l [^:]*\): .*/\1/p' "$TMP/err")
sed "s/^l .*/$light/" "$TMP/own.nff" >"$TMP/near.nff"
check "a floor under a far light: the light nearer, and it is kept" takes fine "$TMP/near.nff"

# ---- given by hand ----
"$s" build scenes/huge_tiny.nff --profile standard -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err"
check "a profile that misses it is told, and the one that would do" has \
    "standard: measured .* dB of .*, which misses .*: profile fine would do: measured " "$TMP/err"
"$s" build scenes/paper5.nff --profile draft:ng=1 -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err"
check "widths of one's own too" has \
    "profile draft:ng=1: measured .*: profile standard would do: measured" "$TMP/err"
"$s" build scenes/paper5.nff --profile standard -o "$TMP/x.sph" >"$TMP/text" 2>"$TMP/err"
check "one that keeps it is not" test ! -s "$TMP/err"
"$s" build scenes/paper5.nff --profile standard --error 0.001 -o "$TMP/x.sph" >"$TMP/text" \
    2>"$TMP/err"
check "but of a smaller error" has "which misses 0.001 pixels, 45 dB: profile reference would do" \
    "$TMP/err"
"$s" build scenes/paper5.nff -o "$TMP/x.sph" --json "$TMP/j.json" >"$TMP/text"
check "auto is the default, and the report has both" sh -c \
    "grep -q '\"profile_why\": \"standard: ' '$TMP/j.json' &&
    grep -q '\"expected\": {' '$TMP/j.json'"
for bad in x 0 -1 1e10 0.1, 0.1,x 0.1,100 ,45; do
    fails 2 "--error $bad" "$s" build scenes/paper5.nff -o "$TMP/y.sph" --error "$bad"
    check "... is told" has "is no error such as" "$TMP/err"
done
check "nothing is written" test ! -e "$TMP/y.sph"
done_testing
