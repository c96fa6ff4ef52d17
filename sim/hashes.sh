#!/bin/sh
# hashes.sh - picture hashes of the golden model, the text of scenes/hashes.txt; `make hashes`
# SPDX-License-Identifier: Apache-2.0
# usage: [SPHAERA=build/sphaera] sim/hashes.sh
cd "$(dirname "$0")/.." || exit 1
SPHAERA=${SPHAERA:-build/sphaera}
tree=balanced size=64x36 depth=2
cat <<'END'
# hashes.txt - hash of the golden model's picture of every scene in every profile
# SPDX-License-Identifier: Apache-2.0
# Written by `make hashes`, compared by `make test`: a change here is a change of the pictures.
# scene profile tree size depth hash
END
for scene in scenes/*.nff; do
    for profile in draft standard fine reference; do
        hash=$("$SPHAERA" render "$scene" --profile $profile --tree $tree --size $size \
            --depth $depth 2>&1 | awk '
                $1 == "picture" { hash = $2 }
                /would do$/ { hash = "refused" }
                END { print hash ? hash : "error" }')
        echo "$(basename "$scene" .nff) $profile $tree $size $depth $hash"
    done
done
