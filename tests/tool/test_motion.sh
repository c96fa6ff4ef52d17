#!/bin/sh
# test_motion.sh - frames of moving scenes through the tool: --at, --frames
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
robot=scenes/texture/robot.nff
size="--size 32x18 --profile fine"

has() { grep -qE -- "$1" "$2"; } # pattern, file

# shellcheck disable=SC2086  # options on purpose
check "a sequence of machines" "$s" build $robot $size --frames 1..3 -o "$TMP/all.sph" \
    --json "$TMP/all.json"
for frame in 1 2 3; do
    # shellcheck disable=SC2086
    "$s" build $robot $size --at $frame -o "$TMP/one.sph" >"$TMP/text" 2>&1
    check "frame $frame is what --at builds" cmp "$TMP/one.sph" "$TMP/all-000$frame.sph"
done
check "--at tells its bases" has '^bases +370 made' "$TMP/text"
check "still primitives keep theirs" python3 -c 'import json, sys
first, second, third = json.load(open(sys.argv[1]))["frames"]
b = [f["bases"] for f in (first, second, third)]
assert [f["at"] for f in (first, second, third)] == [1, 2, 3]
assert b[0]["computed"] == 370 and b[0]["kept"] == 0 and b[0]["log"] == 370
assert b[1] == b[2] and b[1]["computed"] == b[1]["log"] == 81 and b[1]["kept"] == 289' \
    "$TMP/all.json"
# shellcheck disable=SC2086
"$s" build $robot $size -o "$TMP/rest.sph" >/dev/null
check "frame 1 is not frame 0" sh -c "! cmp -s '$TMP/rest.sph' '$TMP/all-0001.sph'"

# shellcheck disable=SC2086
fails 1 "pictures into no folder" "$s" render $robot $size --frames 2..3 -o "$TMP/v.1/a.png" \
    --frame "$TMP/a.frame"
mkdir "$TMP/v.1"
# shellcheck disable=SC2086
check "in a folder that is there" "$s" render $robot $size --frames 2..3 -o "$TMP/v.1/a.png" \
    --frame "$TMP/a.frame"
"$s" render "$TMP/one.sph" -o "$TMP/one.png" --frame "$TMP/one.frame" >/dev/null
check "frame 3 is the picture of its machine" cmp "$TMP/one.png" "$TMP/v.1/a-0003.png"
check "and so is the frame file" "$s" compare "$TMP/one.frame" "$TMP/a-0003.frame"

sed 's/^b .*/&\nfly 2 2 1.5 6.3 -0.2 1.15 0/' $robot >"$TMP/fly.nff"
cp scenes/texture/*.png "$TMP"
fly() { # shellcheck disable=SC2086
    "$s" build "$TMP/fly.nff" $size --profile draft --effects all "$@" >"$TMP/text" 2>&1
}
fly --frames 1..3 -o "$TMP/fly.sph"
for frame in 1 2 3; do
    fly --at $frame -o "$TMP/fly$frame.sph"
    check "frame $frame with a camera that flies" cmp "$TMP/fly$frame.sph" "$TMP/fly-000$frame.sph"
done

# A tree that is refitted: other visits, the same picture.
# shellcheck disable=SC2086
"$s" render $robot $size --frames 0..3 --refit on -o "$TMP/refit.png" --json "$TMP/refit.json" \
    >"$TMP/text"
# shellcheck disable=SC2086
"$s" render $robot $size --frames 0..3 -o "$TMP/built.png" --json "$TMP/built.json" >"$TMP/text"
for frame in 1 2 3; do
    check "picture $frame of a tree refitted" cmp "$TMP/refit-000$frame.png" \
        "$TMP/built-000$frame.png"
done
check "the report tells" python3 -c 'import json, sys
a, b = (json.load(open(f))["frames"] for f in sys.argv[1:])
assert [f["refitted"] for f in a + b] == [False] + 3 * [True] + 4 * [False]
assert all(f["tree_cost"] == 1 for f in b) and a[3]["tree_cost"] != 1
assert all(f["memory_bytes"] > 0 and f["build_seconds"] >= 0 for f in a)
assert all(f["frame"]["picture_hash"] == g["frame"]["picture_hash"] for f, g in zip(a, b))
assert a[3]["counters"]["node_visits"] != b[3]["counters"]["node_visits"]' \
    "$TMP/refit.json" "$TMP/built.json"
fails 1 "--refit of one frame" "$s" render $robot --refit on
fails 2 "--refit auto:x" "$s" render $robot --frames 0..1 --refit auto:x

# Films, of frames and of pictures that are there; nothing else is left behind.
mkdir "$TMP/film"
# shellcheck disable=SC2086
check "a GIF of frames" "$s" render $robot $size --frames 1..3 -o "$TMP/film/a.gif"
check "a GIF of pictures" "$s" movie -o "$TMP/film/b.gif" "$TMP/built-0001.png" \
    "$TMP/built-0002.png" "$TMP/built-0003.png"
check "they are the same, of three frames" python3 -c 'import sys
a, b = (open(f, "rb").read() for f in sys.argv[1:])
assert a == b and a.count(b"\x21\xf9\x04") == 3' "$TMP/film/a.gif" "$TMP/film/b.gif"
fails 1 "pictures of two sizes" "$s" movie -o "$TMP/film/c.gif" "$TMP/built-0001.png" \
    docs/pictures/hall.png
fails 2 "a film of one frame" "$s" render $robot -o "$TMP/film/c.gif"
fails 2 "a film by another name" "$s" movie -o "$TMP/film/c.avi" "$TMP/built-0001.png"
fails 1 "MP4 without ffmpeg" env PATH=/nowhere "$s" movie -o "$TMP/film/c.mp4" "$TMP/built-0001.png"
check "... which is said" has "ffmpeg is not installed" "$TMP/err"
if command -v ffmpeg >/dev/null; then
    check "MP4" "$s" movie -o "$TMP/film/d.mp4" "$TMP/built-0001.png" "$TMP/built-0002.png"
    check "it is one" sh -c "head -c 12 '$TMP/film/d.mp4' | grep -q ftyp"
    rm -f "$TMP/film/d.mp4"
fi
check "no other file" test "$(echo "$TMP"/film/*)" = "$TMP/film/a.gif $TMP/film/b.gif"

# What the harness of rt_top counts, beside what build reports.
mkdir "$TMP/top"
# shellcheck disable=SC2086
"$s" build $robot $size --frames 0..3 -o "$TMP/top/f.sph" --json "$TMP/top/build.json" >"$TMP/text"
python3 -c 'import json, sys
print("bytes\tupload\tdraw\twritten\tpixels_a_burst")
for f in json.load(open(sys.argv[1]))["frames"]:
    print(f["memory_bytes"], 10, 20 + f["at"], 30, 6.5, sep="\t")' "$TMP/top/build.json" \
    >"$TMP/top/frames.tsv"
check "time to image" python3 -m lab image-times "$TMP/top"
check "in a report" python3 -c 'import json, sys
r = json.load(open(sys.argv[1]))
assert r["command"] == "top" and [f["draw_cycles"] for f in r["frames"]] == [20, 21, 22, 23]' \
    "$TMP/top/report.json"
check "as the schema has it" python3 -W ignore -m jsonschema -i "$TMP/top/report.json" \
    docs/reference/report.schema.json
sed -i '$d' "$TMP/top/frames.tsv"
check "a frame too few is told" sh -c "! python3 -m lab image-times '$TMP/top'"

film() { # its frames are those of a sequence
    rm -rf "${BUILD:-build}/film"
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory film B="${BUILD:-build}" \
        SCENE=moving/orbit SIZE=16x9 PROFILE=draft FRAMES=1..3 MOVIE="$TMP/film.gif" >"$TMP/made" &&
        "$s" render scenes/moving/orbit.nff --size 16x9 --profile draft --frames 1..3 --depth 2 \
            -o "$TMP/whole.png" >"$TMP/drawn" && test -s "$TMP/film.gif" || return 1
    for n in 1 2 3; do cmp "${BUILD:-build}"/film/*/$n.png "$TMP/whole-000$n.png" || return 1; done
}
check "make film draws what render --frames does" film
fails_film() { ! env -u MAKEFLAGS -u MFLAGS make -s film B="${BUILD:-build}" "$@"; }
check "... and wants a file" fails_film FRAMES=0..1
check "... and a range" fails_film FRAMES=2..1 MOVIE="$TMP/none.gif"
check "... of which there is none then" test ! -e "$TMP/none.gif"

for command in build render; do
    # shellcheck disable=SC2086  # options
    check "$command --frames --progress tells how far it is" sh -c "'$s' $command $robot \
        $size --frames 0..1 --progress -o '$TMP/told.png' 2>&1 >/dev/null |
        grep -q 'building  *[0-9]* %'"
done
for way in 3 1..x ..2 2..1 0..65536; do
    fails 2 "--frames $way" "$s" render $robot --frames $way
done
fails 2 "--at 65536" "$s" render $robot --at 65536
fails 2 "--at with --frames" "$s" build $robot --at 1 --frames 0..1 -o "$TMP/x.sph"
for command in build render; do
    fails 2 "$command: --time with --frames" "$s" $command $robot --time 1 --frames 0..1 \
        -o "$TMP/x.png"
    check "... says so" has '--frames and --time exclude' "$TMP/err"
done
fails 1 "--at of a still scene" "$s" build scenes/paper5.nff --at 3 -o "$TMP/x.sph"
check "... names it" has 'paper5.nff: --at 3: nothing in the scene moves' "$TMP/err"
fails 1 "--at of a machine" "$s" render "$TMP/one.sph" --at 1
fails 1 "--frames of a machine" "$s" render "$TMP/one.sph" --frames 0..1
sed 's/^move.*/move 0 0 0 -.25 0 0 0/' $robot >"$TMP/gone.nff"
# shellcheck disable=SC2086
fails 1 "growing to nothing" "$s" build "$TMP/gone.nff" $size --frames 2..5 -o "$TMP/gone.sph"
line=$(grep -n '^move' "$TMP/gone.nff" | head -1 | cut -d: -f1)
check "... with file, line and frame" has "gone.nff:$line: .move.: nothing is left at frame 4" \
    "$TMP/err"
check "frames before it were written" test -f "$TMP/gone-0003.sph"
check "it was not" test ! -e "$TMP/gone-0004.sph"
done_testing
