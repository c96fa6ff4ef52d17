#!/bin/sh
# test_window.sh - pictures whose middle is not where the view goes: shifted, by eyes that move, of
# pairs and of walls, against pictures that are not shifted and real numbers that know no grid
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
oblique=scenes/oblique.nff
said() { check "... and says so" grep -qF -- "$1" "$TMP/err"; }
draw() { "$s" render "$@" >"$TMP/text" 2>&1 || cat "$TMP/text" >&2; }
hash_of() { "$s" render "$@" 2>&1 | sed -n 's/^picture //p'; }
equal() { # name, options of two renders
    check "$1" [ "$(eval "hash_of $2")" = "$(eval "hash_of $3")" ]
}

# ---- the eye moves, the screen stays ----
cat >"$TMP/straight.nff" <<END
v from 0 0 8 at 0 0 0 up 0 1 0 angle 40 resolution 64 36
$(sed '1,/^resolution/d' $oblique)
END
standard="--profile standard"
equal "the scene's shift is that of an eye that moved" "$oblique $standard" \
    "$TMP/straight.nff $standard --eye-shift 3,1.5"
equal "... and moves back" "$TMP/straight.nff $standard" "$oblique $standard --eye-shift -3,-1.5"
draw "$TMP/straight.nff" $standard --stereo 0.7 -o "$TMP/pair.png"
for eye in left:-0.35 right:0.35; do
    draw "$TMP/straight.nff" $standard --eye-shift "${eye#*:},0" -o "$TMP/one.png"
    check "the ${eye%:*} one of a pair" "$s" compare "$TMP/one.png" "$TMP/pair-${eye%:*}.png"
done
check "both machines of a pair" "$s" build $oblique --stereo 0.7 -o "$TMP/pair.sph" \
    --json "$TMP/pair.json"
check "... and their reports" [ -s "$TMP/pair-left.json" -a -s "$TMP/pair-right.json" ]
check "info tells where the view goes" sh -c "'$s' build $oblique --profile fine \
    -o '$TMP/o.sph' && '$s' info '$TMP/o.sph' | grep -qF 'the view meets it at (50.0455, 8.22727)'"
angle=$(python3 -c "from math import *; print(repr(2 * degrees(atan(2 * tan(radians(20))))))")
sed "s/8 at/4 at/; s/angle 40/angle $angle/" "$TMP/straight.nff" >"$TMP/near.nff"
equal "the eye comes nearer: the screen stays" "$TMP/near.nff $standard" \
    "$TMP/straight.nff $standard --eye-shift 0,0,-4"

# ---- background, by every way that the machine has, along both kinds of axes ----
for way in rect spans exact "exact --bg-levels 1" "exact --bg-levels 2"; do
    equal "background $way leaves the picture" "$oblique" "$oblique --background $way"
done
equal "along the scene's axes, every tree" "scenes/facets/room.nff --shift -0.3,0.2 --accel box4" \
    "scenes/facets/room.nff --shift -0.3,0.2 --accel bih"

# ---- what does not know the shift: a part of a larger picture; lines of the scene in decimals ----
# python: dB of a picture against a part of another one, of the double reference
cat >"$TMP/crop.py" <<END
import sys
sys.path.insert(0, ".")
from lab.truth import exact, pictures
def part(path, x, y, size):
    width, _, colours = pictures.ppm(path)
    return b"".join(colours[3 * ((y + j) * width + x):][:3 * size[0]] for j in range(size[1]))
def db(a, b):
    import math
    off = sum((p - q) ** 2 for p, q in zip(a, b))
    return math.inf if not off else 10 * math.log10(255 ** 2 * len(a) / off)
END
# 64x36 is a part of 128x108, whose height has three times the tangent: of scenes with every kind
# of primitive and effect; the part lies 9 pixels right of the middle, 12 above it.
cp scenes/texture/*.png "$TMP"
for scene in oblique paper5 facets/room refraction/water texture/hall; do
    file=scenes/$scene.nff
    angle=$(sed -n 's/.*angle \([0-9.]*\).*/\1/p' "$file" | head -1)
    wide=$(python3 -c "from math import *
print(repr(2 * degrees(atan(3 * tan(radians($angle / 2))))))")
    sed "s/angle [0-9.]*/angle $wide/; /^shift/d" "$file" >"$TMP/wide.nff"
    draw "$file" --profile fine --size 64x36 --shift 0.25,0.3333333333333333 -o "$TMP/part.ppm" \
        --transfer linear
    "$s" reference "$TMP/wide.nff" --size 128x108 --transfer linear -o "$TMP/wide.ppm" >"$TMP/text"
    check "$scene: a part of a larger picture by the double reference" python3 -c "
exec(open('$TMP/crop.py').read())
mine, other = part('$TMP/part.ppm', 0, 0, (64, 36)), part('$TMP/wide.ppm', 41, 24, (64, 36))
away = part('$TMP/wide.ppm', 40, 24, (64, 36))
print(db(mine, other), 'dB; a pixel aside', db(mine, away))
assert db(mine, other) > 45 > db(mine, away) + 10"
done
check "what is seen is what decimals of fifty digits see" python3 -c "
exec(open('$TMP/crop.py').read())
import subprocess
subprocess.run(['$s', 'render', '$oblique', '--frame', '$TMP/f'], check=True,
               stdout=subprocess.DEVNULL)
ids, near = exact.see('$oblique', (64, 36))
assert list(ids) == pictures.frame('$TMP/f')[3] and not any(near)"
"$s" export $oblique --size 64x36 -o "$TMP/o.pov" >"$TMP/text" 2>&1
check "POV-Ray gets a direction that is not square to its screen" python3 -c "
import re
found = re.search(r'direction <(.*?)> right <(.*?)> up <(.*?)>', open('$TMP/o.pov').read())
d, r, u = ([float(n) for n in part.split(',')] for part in found.groups())
dot = lambda a, b: sum(p * q for p, q in zip(a, b))
for by, got in ((36 / 64 * -0.51515201614774181, dot(d, r) / dot(r, r)),
                (-0.25757600807387091, dot(d, u) / dot(u, u))):
    assert abs(by - got) < 1e-9, (by, got)"
if command -v povray >"$TMP/which"; then
    check "... and sees the same" python3 -c "
exec(open('$TMP/crop.py').read())
import subprocess
subprocess.run('povray +I$TMP/o.pov +O$TMP/o.png +FN8 File_Gamma=1.0 +W64 +H36 -D -A -GA '
               'Declare=Ids=1'.split(), check=True, stderr=subprocess.DEVNULL)
subprocess.run('oiiotool $TMP/o.png --ch R,G,B -d uint8 -o $TMP/o.ppm'.split(), check=True)
subprocess.run(['$s', 'render', '$oblique', '--frame', '$TMP/f'], check=True,
               stdout=subprocess.DEVNULL)
data = pictures.ppm('$TMP/o.ppm')[2]
seen = [int.from_bytes(data[i:i + 3], 'little') for i in range(0, len(data), 3)]
frame = pictures.frame('$TMP/f')[3]
assert seen == frame, [(a, b) for a, b in zip(seen, frame)][:20]"
else
    echo "ok $((checks += 1)) - # SKIP there is no povray: make truth-setup"
fi

# ---- walls: machines whose pictures join into the large one ----
cat >"$TMP/join.py" <<END
import subprocess, sys
sys.path.insert(0, ".")
from lab.truth import pictures
tool, folder, scene, columns, rows, width, height, *options = sys.argv[1:]
columns, rows, width, height = int(columns), int(rows), int(width), int(height)
def draw(*more):
    subprocess.run([tool, "render", scene, *options, *more, "-o", folder + "/t.ppm"], check=True,
                   stdout=subprocess.DEVNULL)
    return pictures.ppm(folder + "/t.ppm")[2]
wall = []
for y in range(rows):
    tiles = [draw("--size", f"{width}x{height}", "--wall", f"{columns}x{rows}:{x},{y}")
             for x in range(columns)]
    for line in range(height):
        wall += [t[3 * width * line:3 * width * (line + 1)] for t in tiles]
assert b"".join(wall) == draw("--size", f"{columns * width}x{rows * height}"), "it differs"
END
while read -r scene columns rows size options; do
    # shellcheck disable=SC2086  # options
    check "$scene: a wall of $columns x $rows, $options" python3 "$TMP/join.py" "$s" "$TMP" \
        "scenes/$scene.nff" $columns $rows ${size%x*} ${size#*x} $options
done <<END
oblique 3 2 20x17 --profile standard
paper100 2 2 40x23 --profile draft --background exact
paper100 2 1 32x36 --profile standard --background rect --effects met
facets/room 2 2 25x18 --profile fine --accel box4
texture/hall 3 1 21x36 --profile standard --accel bvh4 --shift 0.2,0
refraction/water 1 3 64x12 --profile standard --accel bih
END

# ---- what is refused ----
fails 2 "a shift of one number" "$s" render $oblique --shift 3
said "is not 2 numbers from -64 to 64"
fails 2 "a shift of a word" "$s" render $oblique --shift 3,x
fails 2 "an eye shift of four numbers" "$s" render $oblique --eye-shift 1,2,3,4
said "2 or more numbers"
fails 2 "a tile beside the wall" "$s" render $oblique --wall 2x2:2,0
said "'2x2:2,0' is no place in a wall"
fails 1 "an eye behind the screen" "$s" render $oblique --eye-shift 0,0,-8
said "8 before the screen, the eye cannot move 8 towards it"
fails 1 "an eye far aside" "$s" render $oblique --eye-shift 1e6,0
said "\`shift\`"
fails 2 "a pair on standard output" "$s" render $oblique --stereo 1 --json -
said "two files of each kind"
fails 1 "a shift of a machine" "$s" render "$TMP/o.sph" --shift 1,0
said "--shift is for scenes"
fails 1 "a raster that is too far aside for its directions" "$s" build $oblique --size 1000x1000 \
    --profile draft --shift 30,0 -o "$TMP/x.sph"
said "or a lesser shift"
while read -r word; do
    sed "s/^shift.*/$word/" $oblique >"$TMP/bad.nff"
    fails 1 "\`$word\`" "$s" render "$TMP/bad.nff"
    said "bad.nff:"
done <<END
shift 1
shift 65 0
shift 0 nan
shift 0 0 shift 0 0
END
done_testing
