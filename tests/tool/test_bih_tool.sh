#!/bin/sh
# test_bih_tool.sh - the tool with --accel bih and brute: pictures, statistics, refusals
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
scenes=$(cd "$(dirname "$0")/../../scenes" && pwd)
cd "$TMP" || exit 1
mkdir work
cd work || exit 1
s=$SPHAERA

has() { grep -q -- "$1" "$2"; } # pattern, file
equal() { echo "'$1' '$2'"; [ -n "$1" ] && [ "$1" = "$2" ]; }
json() { python3 -c "import json,sys; r=json.load(open(sys.argv[1])); assert ($2), r" "$1"; }
picture() { "$s" render "$@" | awk '$1 == "picture" { print $2 }'; }
said() { cat out.txt; [ "$1" -ge 1 ] && [ "$1" -le 2 ] && grep -q -- "$2" out.txt; }
says() { # name, text, command: exits with 1 or 2 and says that
    name=$1 text=$2
    shift 2
    "$@" >out.txt 2>&1 && rc=0 || rc=$?
    check "$name" said "$rc" "$text"
}

# ---- the same picture, whatever finds it ----
"$s" gen scenario2 -n 100 --seed 3 --radius 1.5 --resolution 40x30 -o a.nff >gen.txt
check "gen of a scenario" has "a.nff: 100 spheres, 1 facets, 1 lights, 2 materials" gen.txt
want=$(picture a.nff --brute)
for way in bih brute "bih --bih listing" "bih --max-prims 1" "bih --max-prims infinity" \
    "bih --max-prims 1 --max-tree-depth 3" "bih --background exact" box4 \
    "box4 --background exact"; do
    # shellcheck disable=SC2086  # options on purpose
    check "same picture: $way" equal "$want" "$(picture a.nff --accel $way)"
done

# ---- statistics: of build and of the file, text and report ----
"$s" build a.nff --accel bih --max-prims 1 -o a.sph --stats --json b.json >build.txt
"$s" build a.nff --accel bih --max-prims 1 -o a.sph --stats >build.txt
"$s" info a.sph --json i.json >info.txt
check "build names the tree" has "^tree     bih: [0-9]* nodes on [0-9]* levels" build.txt
check "info too" has "^tree      bih, [0-9]* nodes on .* 100 spheres, 1 planes below them" info.txt
grep -E '^(nodes|prims|levels|leaves|bytes) ' build.txt >b.txt
grep -E '^(nodes|prims|levels|leaves|bytes) ' info.txt >i.txt
check "both tell the same" cmp b.txt i.txt
check "five lines of it" equal 5 "$(grep -c . b.txt)"
check "build tells the tree's own time" has "^build    tree [0-9.]* ms" build.txt
check "the reports too" python3 -c 'import json
b, i = json.load(open("b.json"))["build"]["bih"], json.load(open("i.json"))["bih"]
assert b == i and b["inner"] == b["leaves"] - 1 + b["optimized"], (b, i)
assert b["bytes"] == 12 * (b["inner"] + b["leaves"]) + 4 * 100 + 24, b
assert sum(b["leaves_by_prims"]) == b["leaves"] and b["prims_max"] == 1, b'
check "report names the tree" json i.json 'r["machine"]["tree"] == "bih"'
"$s" build a.nff --accel brute -o c.sph --json c.json >c.txt
check "brute is one leaf" json c.json 'r["build"]["bih"]["leaves"] == 1 and
    r["build"]["bih"]["prims_max"] == 100 and r["machine"]["tree"] == "brute"'
"$s" render c.sph --counters >c.txt
check "... of one visit a ray" sh -c "awk '/^rays_/ { r += \$2 } /^node_v/ { v = \$2 }
    END { exit !(v > 0 && v <= r) }' c.txt"

# ---- the tree that is not asked for ----
"$s" gen icosphere --size 1 --resolution 40x30 -o floor.nff >/dev/null
grep -v '^plane' floor.nff >i.nff
"$s" build i.nff -o auto.sph --json auto.json >/dev/null
"$s" build i.nff -o auto.sph >auto.txt
"$s" build i.nff --accel box4 -o asked.sph >asked.txt
check "triangles get boxes" cmp auto.sph asked.sph
check "... and build says why" \
    has "^tree     box4: .* in spheres, [0-9.]* in boxes, whose core has [0-9.]* cells\$" auto.txt
check "... in the report too" json auto.json \
    '" clocks a pixel in spheres, " in r["build"]["tree_why"]'
check "nothing is said of one that was asked for" sh -c "! grep -E 'chosen|clocks' asked.txt"
check "spheres get nodes of four children, by their cost" sh -c "grep -v '^plane' a.nff >s.nff &&
    '$s' build s.nff -o s.sph |
    grep -E '^tree     reinserted: .* [0-9.]+ clocks a pixel in spheres, [0-9.]+ in boxes'"
check "with planes their numbers decide" sh -c "'$s' build floor.nff -o s.sph |
    grep '^tree     box4: .* chosen for 80 triangles and 0 spheres\$'"
# 574 triangles that boxes suit, and more spheres, which stand behind the eye
{ cat "$scenes/facets/room.nff"; seq 600 | awk '{ print "s", $1 / 100, 1, 6, 0.01 }'; } >more.nff
check "what most clocks go to decides, not what there is most of" sh -c "'$s' build more.nff \
    --size 64x48 -o more.sph | grep -E '^tree     box4: .* clocks a pixel in spheres'"
for way in "--accel bvh4" "--tree reinserted" "--tree balanced" "--tree paper"; do
    # shellcheck disable=SC2086  # options on purpose
    check "four children are asked for by $way" sh -c "'$s' build i.nff $way -o t.sph |
        grep -E '^tree     (reinserted|balanced|paper): [^c]*\$'"
    # shellcheck disable=SC2086
    check "... and show the same" equal "$(picture i.nff)" "$(picture i.nff $way)"
done

# ---- what rays walk through ----
check "picture of the walk" "$s" render a.nff --accel bih --depth 0 --walk w.png \
    -o p.png --transfer linear
check "... is bluer and greener" sh -c "oiiotool w.png p.png --sub --printstats |
    awk '/Stats Max/ { good = \$3 < 0.001 && \$4 > 0 && \$5 > 0 } END { exit !good }'"

# ---- refusals ----
says "tree with bih" "--tree is for --accel bvh4, this is bih" \
    "$s" build a.nff --accel bih --tree paper -o x.sph
says "max-prims without" "--max-prims is for --accel bih, this is auto" \
    "$s" build a.nff --max-prims 3 -o x.sph
says "max-tree-depth of brute" "--max-tree-depth is for --accel bih, this is brute" \
    "$s" build a.nff --accel brute --max-tree-depth 3 -o x.sph
says "too deep" "'66' is no number from 1 to 65" \
    "$s" build a.nff --accel bih --max-tree-depth 66 -o x.sph
says "no primitives" "'0' is no number from 1" "$s" build a.nff --accel bih --max-prims 0 -o x.sph
says "other hierarchy" "'kd' is none of auto, bvh4, bih, brute" "$s" build a.nff --accel kd -o x.sph
says "other builder" "'sah' is none of full, listing" \
    "$s" build a.nff --accel bih --bih sah -o x.sph
"$s" gen sphereflake --size 1 -o flake.nff >/dev/null
for way in bih brute box4; do
    says "the paper's walk of $way" "traverse first: .* four spheres, this is $way" \
        "$s" build flake.nff --accel $way --traverse first -o x.sph
done
says "options for a machine" "--accel is for scenes" "$s" render a.sph --accel brute
says "walk of bvh4" "--walk is for --accel bih and brute, this is reinserted" \
    "$s" render a.nff --size 16x16 --walk x.png
says "radius" "'-1' is no number above 0" "$s" gen scenario1 --radius -1 -o x.nff
says "large radius" "radius 21 is not above 0 and up to 20" "$s" gen scenario1 --radius 21 -o x.nff
check "nothing is left of them" sh -c '! ls x.* 2>/dev/null'
done_testing
