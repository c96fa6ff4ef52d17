#!/bin/sh
# hashes.sh - picture hashes of the golden model, the text of scenes/hashes.txt; `make hashes`
# SPDX-License-Identifier: Apache-2.0
# usage: [SPHAERA=build/sphaera] [SIZE=64x36] sim/hashes.sh
#        [SPHAERA=build/sphaera] sim/hashes.sh --naive NAIVE [K]
# With --naive the text of scenes/hashes_naive.txt: smaller pictures, drawn by the naive model, the
# program NAIVE; with K the K-th, the 2K-th, ... of them.
naive= nth=1
[ "${1:-}" != --naive ] || { naive=$(realpath "$2") nth=${3:-1}; }
cd "$(dirname "$0")/.." || exit 1
SPHAERA=${SPHAERA:-build/sphaera}
size=${SIZE:-64x36} depth=2
[ -z "$naive" ] || size=16x9

# Options of a scene of scenes/effects, from the table there.
options() {
    case $1 in
    effects/*) awk -v name="${1#*/}" '$1 == name && $3 != "-" { gsub(/,/, " ", $3); print $3 }' \
        scenes/effects/effects.txt ;;
    limits/equal_depth) echo --accel=box4 ;;
    esac
}
# Profiles that a scene is drawn in: of pairs of effects that are simulated in small, one.
profiles() {
    case $1 in
    effects/*) awk -v name="${1#*/}" '$1 == name && $2 !~ /full|pair/ { print "standard" }' \
        scenes/effects/effects.txt ;;
    texture/*) echo standard ;;
    esac
}
naive_hash() { # scene, options of build
    if ! "$SPHAERA" build "$@" -o "$at" >"$at.log" 2>&1; then
        grep -q 'would do$' "$at.log" && echo refused || echo error
        return
    fi
    "$naive" "$at" 2>&1 | awk '{ hash = $2 } / mismatches$/ { bad = 1 }
        END { print bad || !hash ? "error" : hash }'
}
if [ -n "$naive" ]; then
    work=$(mktemp -d) || exit 1
    trap 'rm -rf "$work"' EXIT
    trap 'exit 130' HUP INT TERM
    at=$work/machine
    cat <<'END'
# hashes_naive.txt - hash of the naive model's picture of every scene
# SPDX-License-Identifier: Apache-2.0
# Written by `make hashes`; `make test` compares the golden model's pictures with it.
# scene profile tree size depth hash
END
else
    cat <<'END'
# hashes.txt - hash of the golden model's picture of every scene in every profile
# SPDX-License-Identifier: Apache-2.0
# Written by `make hashes`, compared by `make test`: a change here is a change of the pictures.
# scene profile tree size depth hash
END
fi
n=0
scenes_of() { # file: FILE:NAME of each
    sed -n 's/^scene //p' "$1" | LC_ALL=C sort | sed "s|^|$1:|"
}
for scene in scenes/*.nff $(scenes_of scenes/limits/limits.nff) \
    $(scenes_of scenes/effects/effects.nff) scenes/facets/*.nff scenes/refraction/*.nff \
    scenes/texture/*.nff; do
    name=${scene#scenes/} name=${name%.nff} tree=balanced
    case $name in
    *:*) name=${name%%/*}/${name#*:} ;;
    esac
    more=$(options "$name")
    case $more in *--tree=paper*) tree=paper ;; *--accel=box4*) tree=box4 ;; esac
    [ $tree = box4 ] || more="--tree $tree $more"
    some=$(profiles "$name")
    for profile in ${some:-draft standard fine reference}; do
        n=$((n + 1))
        [ $((n % nth)) -eq 0 ] || continue
        if [ -n "$naive" ]; then
            # shellcheck disable=SC2086  # a list of words on purpose
            hash=$(naive_hash "$scene" --profile $profile --size $size \
                --depth $depth $more)
            echo "$name $profile $tree $size $depth $hash"
            continue
        fi
        # shellcheck disable=SC2086  # a list of words on purpose
        hash=$("$SPHAERA" render "$scene" --profile $profile --size $size \
            --depth $depth $more 2>&1 | awk '
                $1 == "picture" { hash = $2 }
                /would do$/ { hash = "refused" }
                END { print hash ? hash : "error" }')
        echo "$name $profile $tree $size $depth $hash"
    done
done
