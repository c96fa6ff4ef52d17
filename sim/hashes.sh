#!/bin/sh
# hashes.sh - picture hashes of the golden model, the text of scenes/hashes.txt; `make hashes`
# SPDX-License-Identifier: Apache-2.0
# usage: [SPHAERA=build/sphaera] sim/hashes.sh
cd "$(dirname "$0")/.." || exit 1
SPHAERA=${SPHAERA:-build/sphaera}
size=64x36 depth=2

# Options of a scene of scenes/effects, from the table there.
options() {
    case $1 in
    effects/*) awk -v name="${1#*/}" '$1 == name && $3 != "-" { gsub(/,/, " ", $3); print $3 }' \
        scenes/effects/effects.txt ;;
    esac
}
# Profiles that a scene is drawn in: of pairs of effects that are simulated in small, one.
profiles() {
    case $1 in
    effects/*) awk -v name="${1#*/}" '$1 == name && $2 !~ /full|pair/ { print "standard" }' \
        scenes/effects/effects.txt ;;
    esac
}
cat <<'END'
# hashes.txt - hash of the golden model's picture of every scene in every profile
# SPDX-License-Identifier: Apache-2.0
# Written by `make hashes`, compared by `make test`: a change here is a change of the pictures.
# scene profile tree size depth hash
END
for scene in scenes/*.nff scenes/effects/*.nff scenes/facets/*.nff scenes/refraction/*.nff; do
    name=${scene#scenes/} name=${name%.nff} tree=balanced
    more=$(options "$name")
    case $more in *--tree=paper*) tree=paper ;; esac
    some=$(profiles "$name")
    for profile in ${some:-draft standard fine reference}; do
        # shellcheck disable=SC2086  # a list of words on purpose
        hash=$("$SPHAERA" render "$scene" --profile $profile --tree $tree --size $size \
            --depth $depth $more 2>&1 | awk '
                $1 == "picture" { hash = $2 }
                /would do$/ { hash = "refused" }
                END { print hash ? hash : "error" }')
        echo "$name $profile $tree $size $depth $hash"
    done
done
