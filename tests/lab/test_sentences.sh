#!/bin/sh
# test_sentences.sh - what help and pages say of the whole is so
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

says() { # text, command: it is printed, lines joined
    text=$1
    shift
    "$@" 2>&1 | tr '\n' ' ' | tr -s ' ' >"$TMP/said"
    head -c 200 "$TMP/said" && echo
    grep -qF -- "$text" "$TMP/said"
}
nowhere() { # text: in no page and in no claim, lines joined
    for page in README.md $(find docs -name '*.md') lab/papers/claims.py; do
        ! says "$1" cat "$page" >"$TMP/where" || { echo "$page: $1" && return 1; }
    done
}
primitives="spheres, triangles and planes"
check "make help names what is drawn" says "$primitives" make help
check "the tool's help too" says "$primitives" "$SPHAERA" --help
check "the core has frame store and AXI around it: rt_top" nowhere "have to be put around the core"
check "core.md links it" says "](rt_top.md)" sed -n '/^## Limits/,$p' docs/reference/core.md
check "a ray that waits is the paper's ray stack" nowhere "there is no stack"
check "the paper's Figure 10 names no number" nowhere '"5 spheres, a light'
cold() { # what a page calls cold was not measured behind a first pass
    ! { says "cold caches" cat docs/results/speed_and_area.md &&
        says "WARM=1" sed '/^<!-- begin: measured/,/^<!-- end/d' docs/results/speed_and_area.md; }
}
check "cold caches are not those of WARM=1" cold
done_testing
