#!/bin/sh
# test_bart_page.sh - BART's tables of docs/results/texture_results.md from results; what lacks some
# is shown, with dashes, and not put
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
page=$TMP/shown data=$TMP/data
cp docs/results/texture_results.md "$TMP/bart.md"
mkdir "$data"

has() { grep -qE -- "$1" "$2"; } # pattern, file
fill() {
    python3 -m lab bart-page "$TMP/bart.md" "$data" 48x27 kitchen:400:50,400 \
        robot:3:2,3,4 museum:7:7 >"$page" 2>&1
}

check "without results" fill
check "the page stays" cmp docs/results/texture_results.md "$TMP/bart.md"
check "... no table has a stamp" [ ! -e "$TMP/measured.tsv" ]
check "there are dashes" has '^\| robot +\| +- \| +- \| +- \|' "$page"
check "and the paper's figures" has '^\| museum +\| +1 \| +-.*\| +6.4 \|' "$page"

cat >"$TMP/small.aff" <<'END'
v from 0 0 6 at 0 0 0 up 0 1 0 angle 30 hither 0.1 resolution 48 27
l 3 4 5 0.5 0.5 0.5
fm 0 0 0 0.8 0.8 0.8 0.2 0.2 0.2 0 0 0
END
printf 'm vertices 3 -2 -1 0 2 -1 0 0 1 0 texturecoords 3 %s 0 0 1 0 0.5 1\n' \
    tiles.png >>"$TMP/small.aff"
cp scenes/texture/tiles.png "$TMP"
echo 'triangles 1 0 1 2 0 1 2' >>"$TMP/small.aff"
{
    "$s" render "$TMP/small.aff" --json "$data/robot-3.json"
    cp "$data/robot-3.json" "$data/robot-4.json"
    "$s" texels "$TMP/small.aff" --filter level --json "$data/robot-3-level.json"
    "$s" accuracy "$TMP/small.aff" --json "$data/robot.levels.json"
} >"$TMP/text" 2>&1
check "with some results" fill
check "triangles, lights, rays" \
    has '^\| robot +\| +2 \| +1 \| +1 \| +[a-z]+ \| +1.00 \| +0.[0-9]+ \|' "$page"
check "levels" has '^\| +\| ours +\| +[1-9][0-9]+ \|( +[0-9.]+ \|){4}$' "$page"
check "a kept decision is an addition and a logarithm" python3 - "$page" <<'END'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
row = re.search(r"^\|\s+\| path length, P_b kept +\|.*\| +2 \|$", text, re.M)
first = re.search(r"^\| robot +\| BMRT's estimate +\| +(\d+) \|.*\| +44 \|$", text, re.M)
cells = [c.strip() for c in row[0].split("|")]
assert cells[4:9] == [first[1], "0", "0", "0", first[1]], cells
END
check "without the RTL the least" \
    has '^\| robot +\| +1 \|( +[0-9]+ \|){4} +- \| +[0-9.]+ \| +6.3 \|' "$page"
sed -i 's/"node_visits": *[0-9]*/"node_visits": 51840/' "$data"/robot-[34].json
sed -i 's/"facet_tests": *[0-9]*/"facet_tests": 31104/' "$data"/robot-[34].json
fill
check "a visit a clock, a test every two; with two pipes half of it, with four a quarter" \
    python3 - "$page" <<'END'
import sys
text = open(sys.argv[1], encoding="utf-8").read().split("the table bart_clocks stays")[1]
rows = text[text.index("| robot"):].splitlines()[:3]
walk, facets = ([int(row.split("|")[k]) for row in rows] for k in (3, 4))
assert walk == [40, 20, 10] and facets == [48, 24, 12], rows
END
# A frame of which the RTL took twice the least
for way in off:8000 level:4000 between:4000; do
    cat >"$data/robot-3-${way%:*}.core.json" <<END
{"pixels": 10, "memory": {"peak_bytes_per_clock": 8}, "cold": {"cycles_per_pixel": ${way#*:},
 "counters": {"cycles": ${way#*:}, "node_visits": 2000, "facet_tests": 1},
 "memory": {"lines": 100, "bytes_per_pixel": 320.0, "row_hit_share": 0.25}}}
END
done
cp "$data/robot-3-between.core.json" "$data/robot-3-pipes1.core.json"
cat >"$data/robot.sequence.json" <<'END'
{"frames": [{"at": 5, "bases": {"computed": 3, "kept": 4}, "cpu_seconds": 0.25,
  "memory_bytes": 6720000, "counters": {"node_visits": 4200000, "facet_tests": 1}}]}
END
check "with frames of the RTL" fill
check "clocks a pixel by the RTL" python3 - "$page" <<'END'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
row = re.findall(r"^\| robot +\| +1 \|(?: +[0-9]+ \|){4}.*6\.3 \|$", text, re.M)[0]
numbers = map(float, row.split("|")[3:-1])
walk, facets, texels, worst, ratio, took, paper = numbers
assert ratio == 2 and abs(took - 2 * worst) <= 2 and worst == max(walk, facets, texels), row
END
check "half the clocks are a gain of 100 %" \
    has 'nearest level +\| +320 \| +25% \| +40 \| +4000 \| +\+100.0 % \| +\+24 % \|' "$page"
check "build, upload, drawing" \
    has '^\| robot +\| +5 \| +3 \| +4 \| +250 \| +0.8 \| +4.2 \|' "$page"

fails_make() { # text, what is given
    said=$1
    shift
    ! make --no-print-directory bart "$@" >"$TMP/made" 2>&1 && has "$said" "$TMP/made"
}
check "a folder has to be named" fails_make 'BART names no folder' BART=
check "and has to have the scenes" fails_make "has no scene_kitchen/aff/kitchen.aff" "BART=$TMP"
done_testing
