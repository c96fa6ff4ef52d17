#!/bin/sh
# test_textures_page.sh - the tables of docs/results/texture_results.md from results; what lacks
# some is shown and not put
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
page=$TMP/page.md data=$TMP/data
cp docs/results/texture_results.md "$page"
cp docs/results/accuracy.md "$TMP/accuracy.md"
mkdir "$data"
cp docs/results/data/texture_results.tsv "$data/page.tsv" # tables that are too long for the page
cp docs/results/data/accuracy.tsv "$data/accuracy.tsv"

has() { grep -qE -- "$1" "$2"; } # pattern, file
file() { tr '\t' ';' <"$data/$1.tsv" | grep -qE -- "$2"; } # name, pattern
told() { # a row of a table that is shown, its first cell that above if it is empty
    sed 's/^| *//;s/ *|$//;s/ *| */;/g' "$TMP/text" |
        awk -F ';' '/^;/ { print first $0; next } { first = $1; print }' | grep -qE -- "$1"
}
fill() {
    python3 -m lab textures-page "$page" "$TMP/accuracy.md" "$data" "$TMP" 48x27 24x14 \
        kitchen robot museum
}
outside() {
    awk '/^<!-- end/ { inside = 0 } !inside { print } /^<!-- [a-z_]+ -->/ { inside = 1 }' "$1"
}

fill >"$TMP/text" 2>&1
check "without results" [ $? = 0 ]
check "a table is shown with dashes" told '^kitchen;trilinear;-;-;-;-;93.7$'
check "... and why it stays as it is" \
    has 'the table caches stays as it is: no .*, and [0-9]* more$' "$TMP/text"
check "... the page stays" cmp docs/results/texture_results.md "$page"
check "... its tables" cmp docs/results/data/texture_results.tsv "$data/page.tsv"
check "... and nothing is stamped" [ ! -e "$TMP/measured.tsv" ]

size="--size 48x27"
# shellcheck disable=SC2086  # options on purpose
{
    "$s" texels scenes/texture/robot.nff $size --filter level --json "$data/robot-level.json"
    "$s" accuracy scenes/texture/robot.nff $size --json "$data/robot.levels.json"
    "$s" build scenes/texture/robot.nff $size --frames 0..2 -o "$TMP/r.sph" \
        --json "$data/robot-walk.json"
    "$s" accuracy scenes/texture/slant.nff $size --json "$data/slant-45.json"
} >"$TMP/text" 2>&1
cat >"$data/robot-level.rms" <<END
  RMS error = 0.0331
  Peak SNR = 29.61
END
echo '{"cold": {"counters": {"cycles": 100000, "texels": 1000, "texel_misses": 250}}}' \
    >"$data/robot-level.core.json"
# clocks a pixel; memory is the limit, and its lines take half as many with levels
for way in off:400 level:200; do
    cat >"$data/robot-fine-${way%:*}-sdram16_84.core.json" <<END
{"pixels": 10, "memory": {"peak_bytes_per_clock": 3.2},
 "cold": {"counters": {"cycles": ${way#*:}0}, "cycles_per_pixel": ${way#*:},
  "limit": {"binds": false, "unit": "memory sdram16", "busy": 0.75, "said": "-"},
  "memory": {"lines": 150, "bytes_per_pixel": 480.0, "row_hit_share": 0.5}}}
END
done
for view in 89 75 60 30 16 5 ball; do cp "$data/slant-45.json" "$data/slant-$view.json"; done
fill >"$TMP/text" 2>&1
check "with some results" [ $? = 0 ]
check "memory's share, and the gain of levels" told \
    '^robot;SDRAM x16;bilinear, nearest level;480.0;50%;200.0;-;\+100 %;150.0;\(memory .*75 %\)$'
check "levels of the robot" told '^robot;ours;[0-9]+;[0-9.]+;'
check "kept decisions are one addition and one logarithm" \
    told '^path length, P_b kept(;1, 0, 0, 0, 1){3}$'
check "frame 1 keeps bases" told '^robot;frame 1;81;289;'
check "hits of the core" told '^robot;bilinear, nearest level;[0-9]+;.*;75.0;98.6$'
check "clocks" told '^robot;bilinear, nearest level;100000;297.6;6.3$'
check "errors" told '^robot;bilinear, nearest level;0.0331;29.61$'
check "angles" file page '^60 to 65;[0-9]+;-[01]\.[0-9]+;'
check "all of that table's results: it is put, and no other, and stamped" \
    [ "$(cut -f 2 "$TMP/measured.tsv" | grep -v '^#')" = angles ]
outside docs/results/texture_results.md >"$TMP/before"
outside "$page" >"$TMP/after"
check "... text outside of tables stays" cmp "$TMP/before" "$TMP/after"
check "the plot is drawn" has '<svg' "$TMP/angles.svg"
check "missing scenes are dashes in the prices" told '^bilinear, nearest level;-;'
sed '/<!-- levels/d' docs/results/texture_results.md >"$page"
fails_plain() { ! fill; }
check "a page without a table's place is refused" fails_plain
done_testing
