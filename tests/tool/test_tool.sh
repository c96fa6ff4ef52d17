#!/bin/sh
# test_tool.sh - the sphaera tool from scene to comparison, and what it says of bad input
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$TMP" || exit 1
mkdir work
cd work || exit 1
s=$SPHAERA

has() { grep -q -- "$1" "$2"; }                        # pattern, file
same_files() { cmp "$1" "$2"; }
not_there() { for f; do [ ! -e "$f" ] || return 1; done; }
json() { python3 -c "import json,sys; r=json.load(open(sys.argv[1])); assert ($2), r" "$1"; }
equal() { echo "'$1' '$2'"; [ -n "$1" ] && [ "$1" = "$2" ]; }

# ---- one scene all the way ----
check "gen writes a scene" "$s" gen sphereflake --size 1 --resolution 64x48 -o a.nff
check "gen to standard output is the same" sh -c "'$s' gen sphereflake --size 1 \
    --resolution 64x48 | cmp - a.nff"
check "build" "$s" build a.nff -o a.sph --json build.json
"$s" build a.nff -o a2.sph >build.txt 2>&1
for word in "grid .*step" "smallest radius" "field of view" "nodes on [0-9]* levels" \
    "effect .*shadow"; do
    check "build prints '$word'" has "$word" build.txt
done
check "build is repeatable" same_files a.sph a2.sph
check "build report" json build.json 'r["command"] == "build" and r["machine"]["spheres"] == 10 and
    r["build"]["nodes"] > 0 and r["build"]["warnings"] == []'
check "info" sh -c "'$s' info a.sph --json info.json | grep -q 'WD 17'"
levels() { # scene, options: build and info name the same nodes and levels
    "$s" build "$@" -o levels.sph >levels.txt 2>&1 && "$s" info levels.sph >>levels.txt
    grep -o '[0-9]* nodes on [0-9]* levels' levels.txt | uniq -c | grep ' 2 [1-9]' || {
        cat levels.txt && false; }
}
while read -r scene options; do
    # shellcheck disable=SC2086  # words
    check "levels of the tree, $scene $options" levels "$root/$scene" $options
done <<END
scenes/paper100.nff --tree paper
scenes/paper100.nff --tree balanced
scenes/paper100.nff --tree reinserted
scenes/paper100.nff --accel bih
scenes/paper100.nff --accel brute
scenes/one_sphere.nff
scenes/facets/plane.nff
scenes/facets/room.nff
END
check "info report" json info.json 'r["machine"]["profile"] == "standard"'
"$s" info a.sph --pixel 30,24 --json rays.json | sed -n '/^rays/,$p' >rays.txt
check "rays of a pixel" json rays.json 'r["pixel_rays"][0]["kind"] == "primary" and any(
    i["kind"] == "reflected" and r["pixel_rays"][i["parent"]]["hit"] for i in r["pixel_rays"])'
check "... as text" grep -E '^  primary   id [0-9]+, key [0-9]+, distance .* visits$' rays.txt
"$s" info a.sph --pixel 30,24 --stages --json stages.json >stages.txt
check "its stages, as text and in the report" json stages.json \
    'r["stages"] == [l.rstrip("\n") for l in open("stages.txt") if l.startswith(("ray ", "pixel"))]
     and len(r["stages"]) > 20'
fails 2 "stages of no pixel" "$s" info a.sph --stages
fails 1 "no such pixel" "$s" info a.sph --pixel 64,0
fails 2 "no pixel at all" "$s" info a.sph --pixel 64

"$s" render a.sph -o a.png --exr a.exr --frame a.frame --counters --json a.json >render.txt 2>&1
check "render exits with 0 and prints a hash" grep -E '^frame +[0-9a-f]{16}$' render.txt
check "render prints counters" grep -E '^rays_primary +3072$' render.txt
check "render names no error" has '^errors *none' render.txt
check "render is silent on stderr" sh -c "'$s' render a.sph 2>&1 >/dev/null | cmp - /dev/null"
check "render report" json a.json 'r["frame"]["width"] == 64 and r["errors"] == [] and
    r["counters"]["rays_primary"] == 3072 and len(r["frame"]["hash"]) == 16'
check "report to standard output is all there is" sh -c "'$s' render a.sph --json - >o.json &&
    python3 -m json.tool o.json"
check "picture is 64x48 with 3 channels" sh -c "oiiotool --info a.png | grep -q '64 x  *48, 3 chan'"
check "exr has ids and keys" sh -c "oiiotool --info -v a.exr | grep -q 'id (uint)' &&
    oiiotool --info -v a.exr | grep -q 'key.hi (uint), key.lo (uint)'"
"$s" gen random:2000 --resolution 64x48 -o many.nff >/dev/null
check "build --progress tells what is read and built" sh -c "'$s' build many.nff --progress \
    -o p.sph 2>&1 >/dev/null | grep -q 'reading .* building  *[0-9]* %'"
check "... and builds the same" sh -c "'$s' build many.nff -o q.sph && cmp p.sph q.sph"
check "... nothing if stderr is no terminal" sh -c "'$s' build a.nff -o p.sph 2>&1 >/dev/null |
    cmp - /dev/null"
check "--progress reaches 100 % of the rows" sh -c "'$s' render a.sph --progress 2>&1 |
    grep -q 'rendering'"

# ---- what must give the same frame ----
hash() { "$s" render "$@" | awk '$1 == "frame" { print $2 }'; }
picture() { "$s" render "$@" | awk '$1 == "picture" { print $2 }'; }
check "scene and machine agree" equal "$(hash a.nff)" "$(hash a.sph)"
check "one thread and three agree" equal "$(hash a.sph -t 1)" "$(hash a.sph -t 3)"
check "brute force shows the same" equal "$(picture a.sph)" "$(picture a.sph --brute)"
check "so do packets" equal "$(picture a.sph)" "$(picture a.sph --packets)"
"$s" build a.nff --axes scene -o turned.sph >/dev/null 2>&1
check "a turned grid is drawn literally and fast alike" equal \
    "$(hash turned.sph)" "$(hash turned.sph --literal)"
check "... and in packets" equal "$(picture turned.sph)" "$(picture turned.sph --packets)"
check "packets tell no work" sh -c "! \"$s\" render a.sph --packets | grep -q $(hash a.sph)"
check "unless it is asked for" equal "$("$s" render a.sph --counters | grep -v rendered)" \
    "$("$s" render a.sph --packets --counters | grep -v rendered)"
check "the paper's tree shows the same" equal "$(picture a.sph)" "$(picture a.nff --tree paper)"
for way in rect spans "spans --bg-points 4 --bg-border 0" exact "exact --bg-levels 2"; do
    # shellcheck disable=SC2086  # options on purpose
    check "separation shows the same: $way" equal "$(picture a.sph)" \
        "$(picture a.nff --background $way)"
done

# ---- triangles and planes ----
"$s" gen icosphere --size 1 --resolution 64x48 -o i.nff >gen.txt
check "gen counts facets" has "i.nff: 0 spheres, 81 facets, 1 lights" gen.txt
"$s" build i.nff -o i.sph --json i.json >build.txt 2>&1
check "build counts triangles and planes" \
    has "0 spheres, 80 triangles, 1 planes, 1 lights" build.txt
check "... and tells the effect" \
    has "effect *facets *on *80 triangles, 1 plane; the first is" build.txt
check "... and in the report" json i.json 'r["machine"]["triangles"] == 80 and
    r["machine"]["planes"] == 1 and r["machine"]["spheres"] == 0 and
    "facets" in r["machine"]["effects"] and
    [e["on"] for e in r["build"]["effects"] if e["name"] == "facets"] == [1]'
"$s" build a.nff -o a2.sph >off.txt 2>&1
check "without any it is off" has "effect *facets *off there is no triangle and no plane" off.txt
"$s" info i.sph >info.txt
check "info knows them" has "80 triangles, 1 planes below" info.txt
check "... and the core that they ask for" has "^core .*+facets" info.txt
check "the paper's tree shows the same of them" equal "$(picture i.sph)" \
    "$(picture i.nff --tree paper)"
check "so does brute force" equal "$(picture i.sph)" "$(picture i.sph --brute)"
check "so does exact separation" equal "$(picture i.sph)" "$(picture i.nff --background exact)"

# ---- what is left out, and what is not ----
{ cat a.nff; printf 'p 4\n0 0 0\n1 0 0\n1 1 0.01\n0 1 0\npb 0 0 0 1\n'; } >patch.nff
bent=$(($(wc -l <a.nff) + 1))
"$s" build patch.nff --skip-unsupported -o patch.sph >patch.txt 2>&1
check "a polygon that is not flat is cut in two and not left out" has "10 spheres, 2 triangles" \
    patch.txt
check "... with a warning" has "patch.nff:$bent: used otherwise: polygon that is not" patch.txt
check "... and the patch is told" \
    has "patch.nff:$((bent + 5)): left out: record that is not" patch.txt
fails 1 "--strict" "$s" build patch.nff --skip-unsupported --strict -o x.sph
check "... names file and line" has "patch.nff:$bent: used otherwise: polygon" "$TMP/err"
fails 1 "a patch without --skip-unsupported" "$s" build patch.nff -o x.sph
"$s" build --help | tr -s ' \n' ' ' >help.txt
check "--help says what is left out" \
    has "leave out what is neither sphere, polygon, cone nor plane" help.txt

# ---- cones and cylinders ----
"$s" gen jacks --size 1 -o jacks.nff >gen.txt
check "a file keeps cones as they are" equal "$(grep -c '^c ' jacks.nff)" 3
"$s" build jacks.nff -o jacks.sph >jacks.txt 2>&1
check "three cylinders are rings of 32" has "6 spheres, 194 triangles" jacks.txt
"$s" build jacks.nff --round 0.1 -o jacks.sph >jacks.txt 2>&1
check "... and of 7 if a tenth of a radius may be lost" has "6 spheres, 44 triangles" jacks.txt
for value in 0 0.6 -1 x 0.1x ''; do
    fails 2 "--round '$value'" "$s" build jacks.nff --round "$value" -o x.sph
done

# ---- accuracy ----
check "accuracy" "$s" accuracy a.nff --profile reference -d strip.png --json acc.json
check "accuracy report: nothing wrong on one flake" json acc.json \
    'r["accuracy"]["pixels"] == 3072 and
    r["accuracy"]["psnr"][2] > 45 and r["accuracy"]["silhouette"] < 2 and
    r["accuracy"]["wrong_id"] < 4 and r["frame"]["width"] == 64 and
    0 < r["accuracy"]["t_mean"] < r["accuracy"]["t_worst"]'
"$s" accuracy a.nff --profile draft --json draft.json >accuracy.txt 2>&1
wrong='^wrong .*shadow [0-9]*, reflected [0-9]*, refracted [0-9]*$'
check "accuracy prints what it reports" sh -c "grep -q '$wrong' \
    accuracy.txt && grep -q '^psnr  *[0-9.]* dB' accuracy.txt"
check "draft is worse" sh -c "python3 -c 'import json
a, b = (json.load(open(n))[\"accuracy\"][\"psnr\"][2] for n in (\"draft.json\", \"acc.json\"))
assert a + 6 < b, (a, b)'"
"$s" gen tree:3 -o tree.nff >/dev/null 2>&1
set -- tree.nff --size 64x36
"$s" accuracy "$@" --profile draft --frame named.frame >accuracy.txt 2>&1
"$s" render "$@" --profile draft --frame machine.frame >render.txt 2>&1
"$s" reference "$@" --frame truth.frame >reference.txt 2>&1
check "its frame has the scene's ids, where triangles without area are left out" \
    env PYTHONPATH="$root" python3 -c '
from lab.truth.pictures import frame
truth, named, machine = (frame(n + ".frame")[3] for n in ("truth", "named", "machine"))
other = lambda ids: sum(a != b for a, b in zip(ids, truth))
assert other(named) < 40 and other(machine) > 400, (other(named), other(machine))'
"$s" accuracy a.nff --depth 0 --truth 2 --json flat.json >flat.txt 2>&1
check "mirrors left out show against a truth that has them" json flat.json \
    'r["accuracy"]["psnr"][2] < 40 and r["accuracy"]["psnr"][0] > 40 and
     r["accuracy"]["reflected"] > 50'
floor=$root/tests/scenes/facets/horizon.nff
"$s" accuracy "$floor" --json floor.json >floor.txt 2>&1
check "accuracy of a floor without end is that of the scene as written" json floor.json \
    'r["accuracy"]["psnr"][2] > 50 and r["accuracy"]["silhouette"] == 0 and
     r["build"]["planes_cut"]["beyond"] == 124 and r["build"]["planes_cut"]["later"] == 0'
check "... and build warns of its light far away" \
    has "warning: .*horizon.nff:13: the plane goes on beyond the grid: 0.9 % of the" floor.txt
check "strip is three pictures wide" sh -c "oiiotool --info strip.png | grep -q '192 x  *48'"

# ---- background ----
mkdir pictures
check "background of a view" "$s" background a.nff --size 40x30 --pictures pictures --json w.json
check "... its report" json w.json 'len(r["ways"]) == 9 and len(r["series"]) == 5 and not any(
    w["wrong"] for w in r["ways"] if w["way"] in ("none", "rect", "spans") or "exact" in w["way"])'
check "... its pictures" sh -c "oiiotool --info pictures/outline.png | grep -q '640 x  *480' &&
    [ \$(ls pictures | wc -l) = 13 ]"
rm -r pictures

# ---- operations ----
"$s" operations "$root/scenes/views/inside.nff" --size 32x18 --profile standard --json o.json
check "operations of the paper's predicate, and of ours" json o.json \
    'all(r["predicates"][name][case][kind] == n * r["tests"][case] for name, case, kind, n in (
         ("paper", "hit", "mul", 11), ("paper", "hit", "add", 11), ("paper", "behind", "mul", 6),
         ("machine", "hit", "mul", 9), ("machine", "miss", "add", 9),
         ("quadratic", "hit", "mul", 10), ("geometric", "hit", "mul", 7)))'
check "... answer as the exact test does" json o.json \
    'sum(r["tests"].values()) == 40 * r["rays"] == 40 * 576 and all(r["tests"][c] for c in (
         "miss", "hit", "behind")) and not any(p["wrong"] for p in r["predicates"].values())'
check "operations of a machine" sh -c '"$0" operations a.sph | grep -q "^quadratic  each ray"' "$s"

# ---- trees ----
"$s" trees "$root/scenes/facets/room.nff" --size 32x18 --json t.json >trees.txt
check "five trees, of which few steps and tests" json t.json \
    '[t["tree"] for t in r["trees"]] == ["bvh4", "bih", "box4", "boxes", "kd"] and all(
         t["rays"] > 576 and t["steps"] > t["rays"] and 0 < t["tests"] < 40 * t["rays"] and
         t["bytes"] >= t["nodes"] * t["node_bytes"] for t in r["trees"])'
check "... the machine's with the counters of render" sh -c '"$0" render "$1" --size 32x18 \
    --accel box4 --axes camera --json box4.json >box4.txt && python3 -c "import json
c, t = json.load(open(\"box4.json\"))[\"counters\"], json.load(open(\"t.json\"))[\"trees\"][2]
assert t[\"steps\"] == c[\"node_visits\"]
assert t[\"tests\"] == c[\"leaf_tests\"] + c[\"facet_tests\"]"' \
    "$s" "$root/scenes/facets/room.nff"
check "trees as text" sh -c '"$0" trees a.nff --accel bih --max-prims 1 | grep -q "^kd  "' "$s"
fails 2 "trees without a scene" "$s" trees
fails 2 "trees of one kind" "$s" trees a.nff --accel box4
fails 1 "trees of a machine" "$s" trees a.sph
fails 1 "trees of no file" "$s" trees nowhere.nff
printf 'v\nfrom 0 0\n' >broken.nff
fails 1 "trees of a broken scene" "$s" trees broken.nff
check "... file and line" grep -q '^sphaera: broken.nff:2: ' "$TMP/err"

# ---- compare ----
check "a frame equals itself" "$s" compare a.frame a.frame
check "a picture equals itself" "$s" compare a.png a.png
"$s" render a.sph --layer 0 -o b.png --brute --frame b.frame >/dev/null
"$s" render a.nff --size 63x48 -o c.png --frame c.frame >/dev/null
differ() { # pattern, arguments of compare: exit code 1, silent on stderr, pattern on stdout
    pattern=$1
    shift
    "$s" compare "$@" >"$TMP/differ" 2>"$TMP/differ2"
    [ $? -eq 1 ] && [ ! -s "$TMP/differ2" ] && grep -E "$pattern" "$TMP/differ"
}
check "pictures of two layers differ" differ 'pixels differ, by up to .* first at x' a.png b.png
check "pictures of two sizes differ" differ '^sizes differ: 64x48 with 3' a.png c.png
check "frames of two sizes differ" differ '^sizes differ: 64x48 and 63x48' a.frame c.frame
check "work differs with brute force" differ 'counter node_visits' a.frame b.frame
check "... and can be left out" "$s" compare --ignore-work a.frame b.frame
check "picture of the difference" sh -c "'$s' compare a.frame b.frame -d d.png; oiiotool --info \
    d.png | grep -q '192 x  *48, 3 chan'"
"$s" compare a.png b.png --json c.json >/dev/null
check "compare report" json c.json 'not r["same"] and r["difference"]["pixels"] > 0'

# ---- a profile with a width of its own ----
"$s" build a.nff --profile standard:ng=1,pq=15 -o own.sph >/dev/null 2>&1
"$s" info own.sph >own.txt
check "its name, in the order of its widths" has \
    "^profile   standard:pq=15,ng=1: W 16, WD 17, PR 0 (all 33), PQ 15, NG 1, FW 14 bits" own.txt
fails 2 "directions too short for it" "$s" build a.nff --profile standard:wd=16 -o x.sph
check "... and why" has "wd is 16, w is 16: light - point needs w + 1 bits" "$TMP/err"

# ---- refraction and Whitted's sum: two red balls, the first seen through the glass of a third ----
printf '%s\n' v "from 0 0 12" "at 0 0 0" "up 0 1 0" "angle 30" "resolution 64 48" "l 5 9 9 1 1 1" \
    "ambient 1 1 1" "shading sum" "f .9 .3 .3 .3 .1 40 0 0 .3 .3" "s 0 0 -4 1" "s 2.5 0 -3 1" \
    "f 1 1 1 .1 .1 50 .7 .95 .1 0" "s 0 0 0 1.5" >g.nff
"$s" build g.nff -o g.sph --depth 3 --json g.json >build.txt 2>&1
check "build tells what transmits" has "effect *refract *on *g.nff:13 transmits 179/256, depth 3" \
    build.txt
check "... and in the report" json g.json '[e["on"] for e in r["build"]["effects"]
    if e["name"] in ("refract", "specular", "sum")] == [1, 1, 1] and
    {"refract", "specular", "sum"} <= set(r["machine"]["effects"])'
"$s" info g.sph >info.txt
check "info names the core that it asks for" has "^core .*+refract+specular+sum" info.txt
check "brute force shows the same of it" equal "$(picture g.sph)" "$(picture g.sph --brute)"
counted() {
    "$s" render g.sph --counters | awk '/^rays_refracted|^powers/ { print ($2 > 0) }'
}
check "refracted rays and highlights are counted" equal "$(counted)" "$(printf '1\n1')"
check "pictures of depths have the same hash" equal "$(hash g.sph)" \
    "$(hash g.sph --depths -o d.png)"
colours() { # picture, colours
    oiiotool "$1" --colorcount "$2" | awk '{ some += $1 > 0; all += $1 }
        END { exit !(some == NR && all == 64 * 48) }'
}
check "black, red, green, blue, yellow" colours d.png "0,0,0:1,0,0:0,1,0:0,0,1:1,1,0"
"$s" render g.nff --depth 0 --depths -o d.png >/dev/null 2>&1
check "... at depth 0 black and red" colours d.png "0,0,0:1,0,0"

# ---- refusals: a message, an exit code, nothing left behind ----
fails 2 "no command" "$s"
fails 2 "unknown command" "$s" draw
fails 2 "unknown option" "$s" build --fast a.nff -o x.sph
fails 2 "build without output" "$s" build a.nff
fails 2 "build without scene" "$s" build -o x.sph
fails 2 "two scenes" "$s" build a.nff a.nff -o x.sph
for bad in --profile=huge --profile=standard: --profile=standard:pq=99 --tree=oak \
    --background=blue --depth=11 --depth=-1 --depth=1x --size=0x4 --size=64 --size=64x \
    --size=64x48x --size=16384x1 --size=1x16384 --bg-points=3 --bg-points=4097 \
    --bg-border=65 --bg-levels=3 --shadow=maybe --reflect= --lights=9 --lights=all \
    --inside=maybe --traverse=brute --interpenetrate=yes --refract=maybe --specular=1; do
    fails 2 "build $bad" "$s" build a.nff -o x.sph "$bad"
done
for bad in --layer=3 --brute=last --threads=-1; do
    fails 2 "render $bad" "$s" render a.sph -o x.png "$bad"
done
fails 2 "compare of one file" "$s" compare a.png
fails 1 "compare of a picture and a frame" "$s" compare a.png a.frame
fails 1 "compare with nothing" "$s" compare a.png nothing.png
fails 1 "no such scene" "$s" build nothing.nff -o x.sph
fails 1 "no such machine" "$s" render nothing.sph -o x.png
fails 1 "the paper's walk of triangles" "$s" build i.nff --traverse first -o x.sph
check "... names the first of them" has 'i.nff:[0-9]*: traverse first is for spheres' "$TMP/err"
fails 1 "the paper's walk of glass" "$s" build g.nff --traverse first -o x.sph
check "... names the material" has 'g.nff:13: traverse first is for scenes' "$TMP/err"
fails 1 "refraction without inside" "$s" build g.nff --inside off -o x.sph
for bad in --bg-points=8 --bg-border=2 "--bg-border=2 --background=exact" --bg-levels=1 \
    "--bg-levels=1 --background=rect"; do
    # shellcheck disable=SC2086
    fails 2 "build $bad" "$s" build a.nff -o x.sph $bad
done
fails 1 "a time of a scene that has none" "$s" build a.nff --time 3 -o x.sph
check "... says so" has 'a.nff: --time is for AFF scenes' "$TMP/err"
for bad in "--packets --literal" "--brute --packets" "--literal --brute"; do
    # shellcheck disable=SC2086
    fails 2 "render $bad" "$s" render a.sph $bad
done
fails 2 "a cornell of size 5" "$s" gen cornell --size 5 -o x.nff
check "... says so" has '[-][-]size is not for cornell' "$TMP/err"
for bad in "sphereflake --spheres 9" "random --radius 2" "random --plain" "paper5 -n 3" \
    "scenario1 --size 2"; do
    # shellcheck disable=SC2086
    fails 2 "gen $bad" "$s" gen $bad -o x.nff
done
fails 2 "the scene's axes with background" "$s" build a.nff --axes scene --background rect -o x.sph
fails 2 "refraction of depth 0" "$s" build g.nff --refract on --depth 0 -o x.sph
fails 1 "a folder as scene" "$s" build . -o x.sph
check "info of a scene" "$s" info a.nff --json a.json
fails 1 "rays of a scene" "$s" info a.nff --pixel 1,1
check "... says what makes a machine" \
    has 'a.nff: is an NFF scene: --pixel is for machine files; .sphaera build. makes' "$TMP/err"
fails 1 "a scene to load" "$s" load --rom rom a.nff
check "... says so, too" has 'a.nff: is no machine file; .sphaera build. makes' "$TMP/err"
fails 1 "no machine" "$s" info nothing.nff
check "... says that" has 'nothing.nff: cannot open' "$TMP/err"
fails 1 "a machine as scene" "$s" build a.sph -o x.sph
fails 1 "build options for a machine" "$s" render a.sph --depth 1 -o x.png
fails 1 "unknown kind of scene" "$s" gen nothing -o x.nff
fails 2 "background without scene" "$s" background
fails 2 "accuracy without scene" "$s" accuracy
fails 1 "accuracy of a machine" "$s" accuracy a.sph
fails 1 "accuracy of nothing" "$s" accuracy missing.nff
fails 2 "a truth of 11 reflections" "$s" accuracy a.nff --truth 11
fails 1 "background of a machine" "$s" background a.sph
fails 1 "pictures into no folder" "$s" background a.nff --size 8x8 --pictures nothing/there
fails 1 "no such molecule" "$s" import nothing.pdb -o x.nff
printf 'v\nfrom 0 0 zero\n' >bad.nff
fails 1 "broken scene" "$s" build bad.nff -o x.sph
check "... names file and line" has 'bad.nff:2' "$TMP/err"
head -c 700 a.sph >cut.sph
fails 1 "truncated machine" "$s" render cut.sph -o x.png
: >empty.sph
fails 1 "empty machine" "$s" info empty.sph
{ head -c 300 a.sph; printf X; tail -c +302 a.sph; } >flip.sph
fails 1 "damaged machine" "$s" render flip.sph -o x.png
head -c 200 a.frame >cut.frame
fails 1 "truncated frame" "$s" compare a.frame cut.frame
{ head -c 300 a.frame; printf X; tail -c +302 a.frame; } >flip.frame
fails 1 "damaged frame" "$s" compare a.frame flip.frame
fails 1 "output in no folder" "$s" build a.nff -o none/x.sph
fails 1 "picture in no folder" "$s" render a.sph -o none/x.png
fails 1 "report in no folder" "$s" render a.sph --json none/x.json
# ---- a kind of scene in the place of a file ----
"$s" gen random:20 --resolution 32x18 -o random.nff >log
"$s" render random.nff --size 32x18 -o file.png | grep -e '^frame' >file.txt
"$s" render random:20 --size 32x18 -o kind.png | grep -e '^frame' >kind.txt
check "KIND:N is what gen writes of it" same_files file.txt kind.txt
fails 1 "a kind with a number out of range" "$s" render random:0 -o x.png
check "... is told so" has "random:0: '0' is no number from 1 to 16000000" "$TMP/err"
fails 1 "neither a file nor a kind" "$s" render nosuch:3 -o x.png
check "... is told as a file" has "nosuch:3: cannot open" "$TMP/err"
rm -f file.png kind.png

fails 1 "a folder as output" "$s" render a.sph -o .
if [ -c /dev/full ]; then
    fails 1 "full disk: picture" "$s" render a.sph -o /dev/full
    fails 1 "full disk: frame" "$s" render a.sph --frame /dev/full
    fails 1 "full disk: report" "$s" info a.sph --json /dev/full
    fails 1 "full disk: text" sh -c "'$s' info a.sph >/dev/full"
    fails 1 "a device is not replaced" "$s" build a.nff -o /dev/full
    check "... and is still there" test -c /dev/full
fi
check "no output of a failed command" not_there x.sph x.png x.nff x.json none
check "no temporary file" sh -c '! ls | grep -i tmp'
done_testing
