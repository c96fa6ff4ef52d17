#!/bin/sh
# test_missing.sh - without OpenImageIO, assimp and SDL the tool is built, draws what has no image,
# and names what is missing
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
root=$PWD

# ---- building: a pkg-config that knows none of them ----
cat >"$TMP/pkg-config" <<END
#!/bin/sh
for word; do case \$word in OpenImageIO | assimp | sdl2) exit 1 ;; esac; done
exec $(command -v pkg-config) "\$@"
END
chmod +x "$TMP/pkg-config"
PATH=$TMP:$PATH env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -n V=1 B="$TMP/b" tool library \
    >"$TMP/plan" 2>&1
check "the tool would be built" grep -q -- "-o .*new.*b/sphaera" "$TMP/plan"
check "... without them" sh -c "! grep -E 'OpenImageIO|assimp|SDL2|image/.*[.]cpp' '$TMP/plan'"

# ---- what no build does without ----
asked() { # goal, package: without it make says what installs it
    printf '#!/bin/sh\ncase "$*" in *%s*) exit 1 ;; esac\n' "$2" >"$TMP/pkg-config"
    ! PATH=$TMP:$PATH env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -n B="$TMP/b" $1 \
        2>"$TMP/err" && grep "installed: make setup ${1%% *}[.]" "$TMP/err"
}
check "without libraries make asks for them" asked tool expat
check "without cmocka make test does" asked "test ONLY=test_facet" cmocka

# ---- the tool alone ----
mkdir "$TMP/alone"
cp "$SPHAERA" "$TMP/alone/sphaera"
tool=$TMP/alone/sphaera
cd "$TMP" || exit 1
check "draws a scene" "$tool" render "$root/scenes/paper5.nff" --size 16x9 -o paper5.png
check "... the same" sh -c "'$SPHAERA' render '$root/scenes/paper5.nff' --size 16x9 -o whole.png &&
    cmp paper5.png whole.png"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj
says() { # words; the command fails with exit code 1 and says them
    words=$1
    shift
    fails 1 "$words" "$@"
    check "... in words" grep -q "$words" "$TMP/err"
}
says "needs OpenImageIO (make images-setup)" "$tool" render "$root/scenes/texture/kitchen.nff" \
    --size 16x9 -o x.png
says "m.obj: meshes are read by assimp, without which this was built" "$tool" render m.obj -o x.png
check "nothing is written" [ ! -e x.png ]
done_testing
