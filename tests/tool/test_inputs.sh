#!/bin/sh
# test_inputs.sh - what is no file of a bounded size is refused at once by every reader of the tool
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
here=$(cd "$(dirname "$0")/../.." && pwd)
cd "$TMP" || exit 1
s=$SPHAERA

has() { grep -q -- "$1" "$TMP/err"; }
refused() { # what the message says, arguments of the tool
    message=$1
    shift
    fails 1 "refused: sphaera $*" timeout 10 "$s" "$@"
    check "... $message" has "^sphaera: .*$message"
}
textured() { # a scene of one sphere with this image
    "$s" gen sphereflake --size 1 --resolution 48x27 | grep -v '^s '
    printf 'texture %s 1 1\ns 0 0 0 1\n' "$1"
}

mkfifo pipe
mkdir folder
mkdir folder.sph
mkfifo pipe.sph
for file in /dev/zero:"a device" pipe:"a pipe" folder:"a folder"; do
    path=${file%%:*} says="${file%%:*}: is ${file#*:}, not a file"
    refused "$says" build "$path" -o x.sph
    refused "$says" import "$path" -o x.nff
    refused "$says" import "$here/tests/fuzz/corpus/pdb/one.pdb" --elements "$path" -o x.nff
    refused "$says" compare "$path" "$path"
    textured "$path" >scene.nff
    refused "scene.nff:[0-9]*: texture: $says" render --allow-paths scene.nff
done
refused "pipe.sph: is a pipe" info pipe.sph
refused "folder.sph: is a folder" render folder.sph

# ---- files that a scene names: in its folder and below, links followed, or as allowed ----
mkdir -p in/scene/sub in/TextureFiles apart
printf 'secret 1\n' >apart/secret
printf 'P3 1 1 255 9 9 9\n' | tee apart/p.ppm in/p.ppm in/TextureFiles/p.ppm \
    in/scene/sub/p.ppm >in/scene/p.ppm
ln -s ../../apart/p.ppm in/scene/link.ppm
ln -s ../../apart in/scene/linked
ln -s sub/p.ppm in/scene/near.ppm
view='v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution 8 5
f 1 1 1 1 0 0 0 1'
triangle='0 0 0 0 0 1 0 0 1 0 0 1 0 0 1'
words() { # a scene of the format that names the file
    case $1 in
    nff) printf '%s\ntexture "%s" 1 1\ns 0 0 0 1\n' "$view" "$2" ;;
    aff) printf '%s\ntt %s %s\n' "$view" "$2" "$triangle" ;;
    include.aff) printf '%s\ni 0 %s\ns 0 0 0 1\n' "$view" "$2" ;;
    obj | lib.obj)
        [ "$1" = obj ] && library=m.mtl || library=$2
        printf 'newmtl m\nmap_Kd %s\n' "$2" >in/scene/m.mtl
        printf 'mtllib %s\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' "$library"
        ;;
    gltf | bin.gltf)
        [ "$1" = gltf ] && list=images || list=buffers
        printf '{"asset":{"version":"2.0"},"%s":[{"uri":"%s","byteLength":4}]}' "$list" "$2"
        ;;
    esac
}
reads() { # whether no message is of a folder; FORMAT, NAME, options
    words "$1" "$2" >"in/scene/s.${1##*.}"
    timeout 10 "$s" info ${3:-} "in/scene/s.${1##*.}" >text 2>&1
    [ $? -lt 2 ] && ! grep -q 'outside the folder' text
}
stays() { # refused by the name that the scene has
    ! reads "$1" "$2" && grep -q "s.*$2.* is outside the folder of the scene" text
}
for format in nff aff include.aff obj lib.obj gltf bin.gltf; do
    for name in p.ppm sub/p.ppm ./sub/../p.ppm near.ppm none.ppm none/p.ppm \
        "$TMP/in/scene/p.ppm"; do
        case $format:$name in lib.obj:* | bin.gltf:* | include.aff:*) continue ;; esac
        check "$format reads $name" reads "$format" "$name"
    done
    for name in ../p.ppm ../../apart/p.ppm ../scene2/p.ppm link.ppm linked/p.ppm \
        "$TMP/apart/p.ppm" ../none.ppm; do
        check "$format does not read $name" stays "$format" "$name"
    done
    check "... but if it is allowed" reads "$format" ../p.ppm --allow-paths
done
check "AFF reads TextureFiles beside its folder" reads aff ../TextureFiles/p.ppm
check "... NFF does not" stays nff ../TextureFiles/p.ppm
cp in/scene/p.ppm in/scene/sub/q.ppm
check "what is included reads above itself" eval 'words aff ../p.ppm >in/scene/sub/inner.aff &&
    sed 1,2d in/scene/sub/inner.aff >in/scene/sub/i.aff && reads include.aff sub/i.aff'
check "... but not above the scene" eval 'sed "s|[.][.]/p|../../p|" in/scene/sub/i.aff \
    >in/scene/sub/j.aff && ! reads include.aff sub/j.aff'
check "a first word of another file is never told" eval '! reads include.aff ../../apart/secret &&
    ! grep -q "secret.*1\|. secret." text'

# ---- sizes ----
truncate -s 100M large.png
textured large.png >scene.nff
refused "large.png: has 104857600 bytes, more than the 68157440" build scene.nff -o x.sph
truncate -s 4G huge.png
refused "huge.png: has 4294967296 bytes, more than the" compare huge.png huge.png
printf 'P2 16777212 2 255 1' >wide.pgm
refused "wide.pgm: 16777212 x 2 pixels of 1 bytes are more than three" compare wide.pgm wide.pgm
python3 "$here/tests/fuzz/corpus.py" broken
cp broken/image/compressed .
refused "compressed: a BMP of 24 bits a pixel, compressed as one of 8" compare compressed compressed
cp broken/image/canvas.gif .
refused "canvas.gif: a GIF of 13622 x 13109 pixels, which has only 56" compare canvas.gif canvas.gif
cp broken/image/long_reason .
refused 'long_reason: TIFF.* y=32,.* tag ignored$' compare long_reason long_reason
truncate -s 4G zeros.pdb
refused "zeros.pdb:1: byte 0x00" import zeros.pdb -o x.nff

# A frame file that says it has 65536 x 65536 pixels.
"$s" gen sphereflake --size 1 --resolution 8x4 -o s.nff
"$s" render s.nff --frame s.frame >out.txt
{
    head -c 12 s.frame
    printf '\000\000\001\000\000\000\001\000'
    tail -c +21 s.frame
} >lies.frame
refused "lies.frame: frame file ends early: .* 1374389[0-9]* by its header" \
    compare lies.frame s.frame
{
    cat s.frame
    echo
} >long.frame
refused "long.frame: frame file is too long" compare long.frame s.frame
check "the frame itself is sound" "$s" compare s.frame s.frame
check "nothing was written" sh -c '! ls x.sph x.nff'

# ---- info, of scenes of which the numbers are as small and large as they may be ----
described() { # scene, from here
    timeout 5 "$s" info "$1" >log 2>&1
    case $? in
        0) grep -q "^$1:[0-9]*: used: camera, 1 time" log || { cat log && return 1; } ;;
        1) grep -q "^sphaera: $1:[0-9 ]" log || { cat log && return 1; } ;;
        *) cat log && return 1 ;;
    esac
    timeout 5 "$s" build "$1" --size 8x5 -o small.sph >log 2>&1 ||
        { grep -q "^sphaera: $1:[0-9 ]" log || { cat log && return 1; }; return 0; }
    timeout 5 "$s" info small.sph --pixel 4,2 >log 2>&1 || { cat log && return 1; }
}
each_described() {
    for number in 5e-324 1e-300 0 1 1e17 1e30; do
        for word in from at up l s c plane hither angle; do
            sed "s/^\($word \).*/\1$number $number $number $number/" "$1" >numbers.nff
            described numbers.nff || { echo "$word $number" && return 1; }
        done
    done
}
for scene in "$here"/tests/fuzz/corpus/nff/*; do
    case $scene in *skipped* | *moved_beyond*) continue ;; esac
    cp "$scene" numbers.nff
    check "info of ${scene##*/}" described numbers.nff
done
check "info of changed numbers" each_described "$here/scenes/one_sphere.nff"
done_testing
