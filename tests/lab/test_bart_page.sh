#!/bin/sh
# test_bart_page.sh - the tables of docs/results/bart.md from results, or dashes without them
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
page=$TMP/page.md data=$TMP/data
cp docs/results/bart.md "$page"
mkdir "$data"

has() { grep -qE -- "$1" "$2"; } # pattern, file
fill() { python3 -m lab.bart "$page" "$data" 48x27 -- kitchen robot museum; }

check "without results" fill
check "there are dashes" has '^\| robot +\| +- \| +- \| +- \|' "$page"
check "and the paper's figures" has '^\| museum +\| +- \| +- \| +- \| +- \| +6.4 \|' "$page"

cat >"$TMP/small.aff" <<'END'
v from 0 0 6 at 0 0 0 up 0 1 0 angle 30 hither 0.1 resolution 48 27
l 3 4 5 0.5 0.5 0.5
fm 0 0 0 0.8 0.8 0.8 0.2 0.2 0.2 0 0 0
END
printf 'm vertices 3 -2 -1 0 2 -1 0 0 1 0 texturecoords 3 %s 0 0 1 0 0.5 1\n' \
    "$PWD/scenes/texture/tiles.png" >>"$TMP/small.aff"
echo 'triangles 1 0 1 2 0 1 2' >>"$TMP/small.aff"
{
    "$s" render "$TMP/small.aff" --json "$data/robot.json"
    "$s" texels "$TMP/small.aff" --filter level --json "$data/robot-level.json"
    "$s" accuracy "$TMP/small.aff" --json "$data/robot.levels.json"
} >"$TMP/text" 2>&1
check "with some results" fill
check "triangles, lights, rays" \
    has '^\| robot +\| +1 \| +1 \| +[a-z]+ \| +1.00 \| +0.[0-9]+ \|' "$page"
check "levels" has '^\| +\| ours +\| +[1-9][0-9]+ \|( +[0-9.]+ \|){4}$' "$page"
check "a kept decision is an addition and a logarithm" python3 - "$page" <<'END'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
row = re.search(r"^\|\s+\| path length, P_b kept +\|.*\| +2 \|$", text, re.M)
first = re.search(r"^\| robot +\| BMRT's estimate +\| +(\d+) \|.*\| +44 \|$", text, re.M)
cells = [c.strip() for c in row[0].split("|")]
assert cells[4:9] == [first[1], "0", "0", "0", first[1]], cells
END
check "frames a second" has '^\| robot +\|( +[0-9]+ \|){3} +[0-9.]+ \| +6.3 \|' "$page"

fails_make() { # text, what is given
    said=$1
    shift
    ! make --no-print-directory bart "$@" >"$TMP/made" 2>&1 && has "$said" "$TMP/made"
}
check "a folder has to be named" fails_make 'BART names no folder' BART=
check "and has to have the scenes" fails_make "has no scene_kitchen/aff/kitchen.aff" "BART=$TMP"
done_testing
