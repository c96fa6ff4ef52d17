#!/bin/sh
# test_light.sh - pictures as people see them: transfer curves, light of more than 8 bits, samples
# SPDX-License-Identifier: Apache-2.0
#
# oiiotool converts, resizes and compares by itself: it shares nothing with the tool but the file.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
s=$SPHAERA
cp scenes/paper5.nff "$TMP"
cd "$TMP" || exit 1
has() { grep -q -- "$1" "$2"; }
off() { # pictures, most, least: how far channels are apart at most, of 255
    oiiotool "$1" --ch R,G,B "$2" --ch R,G,B --absdiff --printstats 2>&1 |
        awk -v most="$3" -v least="$4" '/Stats Max/ {
            for (i = 3; i <= 5; i++) if (255 * $i > max) max = 255 * $i
            seen = 1
        } END { print max, "of", most; exit !(seen && max <= most + 0.001 && max >= least) }'
}
draw() { "$s" render paper5.nff --size 48x27 "$@" >text; }

# ---- transfer ----
draw -o srgb.tif --exr light.exr --frame a.frame
draw -o linear.tif --transfer linear --frame b.frame
draw -o named.tif --transfer srgb
check "sRGB is the default" cmp srgb.tif named.tif
check "the frame is the same" cmp a.frame b.frame
oiiotool light.exr --ch R,G,B --colorconvert linear sRGB -d uint8 -o expected.tif
check "it is OpenImageIO's sRGB of the light" off srgb.tif expected.tif 1 0
check "and no other picture than linear by chance" off srgb.tif linear.tif 255 60
check "OpenEXR has more than 8 bits of it" off light.exr linear.tif 0.5 0.25
for named in srgb:sRGB linear:linear; do
    draw -o "${named%:*}.png" --transfer "${named%:*}"
    check "PNG says ${named#*:}" sh -c \
        "oiiotool --info -v ${named%:*}.png | grep -q 'oiio:ColorSpace: \"${named#*:}\"'"
done
"$s" compare a.frame a.frame -d both.tif >text
oiiotool linear.tif --colorconvert linear sRGB -d uint8 -o expected.tif
oiiotool both.tif --cut 48x27+0+0 -o left.tif
check "frames side by side too" off left.tif expected.tif 1 0

# ---- samples ----
draw --samples 3 -o few.tif --exr few.exr --frame few.frame
"$s" render paper5.nff --size 144x81 --exr many.exr --frame many.frame >text
check "the frame has every sample" cmp few.frame many.frame
oiiotool many.exr --ch R,G,B --resize:filter=box 48x27 -d float -o expected.exr
check "light is averaged before the curve" off few.exr expected.exr 0 0
oiiotool expected.exr --colorconvert linear sRGB -d uint8 -o expected.tif
check "... and then as people see it" off few.tif expected.tif 1 0
check "one sample draws another picture" off few.tif srgb.tif 255 20
check "a mean has no id" sh -c "! oiiotool --info -v few.exr | grep -q 'id (uint)'"
"$s" build paper5.nff --size 48x27 --samples 3 -o m.sph >text
"$s" render m.sph --samples 3 -o machine.tif >text
check "a machine is sampled as its scene is" cmp few.tif machine.tif
"$s" render paper5.nff --size 16x9 --samples 2 --frames 0..0 -o f.tif >text
check "a sequence too" sh -c "oiiotool --info f-0000.tif | grep -q '16 x  *9'"

# ---- refused ----
wrong() { # text of the message, options
    text=$1
    shift
    fails 2 "render $*" "$s" render paper5.nff --size 8x8 -o x.png "$@"
    check "... is told" has "$text" err
}
wrong "'gamma' is none of linear, srgb" --transfer gamma
wrong "'0' is no number from 1 to 16" --samples 0
wrong "'17' is no number from 1 to 16" --samples 17
wrong "'2x2' is no number from 1 to 16" --samples 2x2
wrong "depths and --walk are false colours" --samples 2 --depths
fails 1 "a machine of other samples" "$s" render m.sph --samples 7 -o x.png
check "... is told" has "m.sph: a frame of 144x81 has no whole pixels of 7 x 7 samples" err
fails 1 "too many" "$s" render paper5.nff --size 5000x8 --samples 4 -o x.png
check "... is told" has "4 x 4 samples of 5000x8 pixels: sides of a frame are 1..16383" err
check "nothing is written" test ! -e x.png

# ---- layers: what is known of one pixel ----
cat >ball.nff <<'END'
v from 9 0 0 at 0 0 0 up 0 1 0 angle 20 resolution 65 49
b 0 0 0
l 9 3 4
f 0.8 0.4 0.2 1 0 1 0 1
s 0 0 0 1
END
"$s" render ball.nff --profile reference -o ball.exr >text
layers() { # column, row: Z, normal, albedo and level there
    oiiotool ball.exr --ch Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B,level --cut "1x1+$1+$2" \
        --printstats | sed -n 's/.*Avg: \(.*\) (float)/\1/p'
}
near() { # numbers that must come, of the pixel that follows
    wanted=$1
    shift
    layers "$@" | tee said | awk -v wanted="$wanted" '
        { n = split(wanted, w, " "); for (i = 1; i <= n; i++) d = $i - w[i] > d ? $i - w[i] : \
            w[i] - $i > d ? w[i] - $i : d }
        END { exit !(NR == 1 && n == 8 && NF == 8 && d < 0.004) }' || { cat said; return 1; }
}
check "the middle is 8 away, and looks along x" near "8 1 0 0 0.8 0.4 0.2 -1" 32 24
# 9 - t and a t of |(9 - t, a t)| = 1, where a is 16 tan(10 degrees) / 49
check "eight rows higher the normal points up" near "8.1159 0.8841 0.4673 0 0.8 0.4 0.2 -1" 32 16
check "beside it there is nothing" sh -c "oiiotool ball.exr --ch Z --cut 1x1+0+0 --printstats |
    grep 'InfCount: 1'"
check "a mean has no layers" sh -c \
    "'$s' render ball.nff --samples 5 --size 13x9 -o mean.exr >text &&
    ! oiiotool --info -v mean.exr | grep 'N.X'"
check "the reference has none" sh -c "'$s' reference ball.nff -o exact.exr >text &&
    oiiotool --info -v exact.exr | grep 'id (uint)' && ! oiiotool --info -v exact.exr | grep 'N.X'"
done_testing
