#!/bin/sh
# test_show_icarus.sh - rt_top in Icarus, from registers to symbols: the golden model's frame
# SPDX-License-Identifier: Apache-2.0
# With layers, too: MUX changes within a picture, and each layer is shown from the next one on. A
# pixel of a frame, and a word of the machine, that are changed show that the comparison can fail.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
tool=${BUILD:-build}/sphaera
made() { # options
    "$tool" build scenes/paper5.nff --profile draft --size 8x6 --depth 2 --interpenetrate off \
        --background rect "$@" -o "$TMP/m.sph" &&
        "$tool" render "$TMP/m.sph" --frame "$TMP/m.frame" &&
        python3 -m lab show-files "$TMP" "$TMP/m.sph" "$TMP/m.frame"
    words=$("$tool" info "$TMP/m.sph" | sed -n 's/^core *//p')
    core=$( (sim/cores.py profile draft && sim/cores.py parameters "$words") | tr ' ' '\n' |
        sed -n 's/\(.*\)=\(.*\)/.\1(\2)/p' | paste -sd,)
}
built() { # layers, spheres that trees are built of
    # shellcheck disable=SC2046  # lists of words
    iverilog -g2005 -DCORE_PARAMETERS="$core" -DWIDTH=8 -DHEIGHT=6 -DLAYERS="$1" \
        -DBUILD="${2:-0}" -Y .v \
        -s tb_show_icarus -o "$TMP/tb" \
        $(find rtl -name '*.v*' -exec dirname {} + | sort -u | sed 's/.*/-I& -y&/') \
        -Itb/video tb/top/tb_show_icarus.v
}
show() { # folder of the three files
    vvp -n "$TMP/tb" "+machine=$1/machine.hex" "+memory=$1/memory.hex" "+frame=$1/frame.hex" \
        >"$TMP/said" && cat "$TMP/said" && grep -q '^ok' "$TMP/said"
}
wrong() { # file, sed command
    rm -rf "$TMP/other" && mkdir "$TMP/other" && cp "$TMP"/*.hex "$TMP/other" &&
        sed -i "$2" "$TMP/other/$1.hex" && ! cmp -s "$TMP/$1.hex" "$TMP/other/$1.hex" &&
        ! show "$TMP/other" && grep -q '^not ok' "$TMP/said"
}
check "machine and golden frame" made
check "rt_top for Icarus" built 0
check "pictures are black, then the golden model's frame" show "$TMP"
check "a pixel that differs is noticed" wrong frame '20s/.*/000001/'
check "another background is noticed" wrong machine '15s/.*/00102030/'
check "rt_top with layers" built 1
check "each layer is shown when MUX chooses it" show "$TMP"
check "a pixel of a layer that differs is noticed" wrong frame '68s/.*/000001/'
check "a machine of tree hw" made --tree hw
check "rt_top that builds trees" built 0 16
check "a frame of the tree that it builds" show "$TMP"
check "a record that differs is noticed" wrong memory \
    '43s/..$/00/;47s/..$/00/;51s/..$/00/;55s/..$/00/'
done_testing
