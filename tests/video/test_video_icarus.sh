#!/bin/sh
# test_video_icarus.sh - rt_video in Icarus: frames of a small mode, decoded from their symbols
# SPDX-License-Identifier: Apache-2.0
# A fault in the decoder's memory shows that the comparison can fail.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
show() { # a file of tb/video
    # shellcheck disable=SC2046  # lists of words
    iverilog -g2005 -Wall -Y .v -Itb/video -s tb_video_icarus -o "$TMP/tb" \
        $(find rtl -name '*.v*' -exec dirname {} + | sort -u | sed 's/.*/-I& -y&/') "$1" &&
        vvp -n "$TMP/tb" >"$TMP/said" && cat "$TMP/said" && grep -q '^ok' "$TMP/said"
}
check "frames are those of memory" show tb/video/tb_video_icarus.v
sed 's/base + y \* STRIDE/base + y * STRIDE + 4/' tb/video/tb_video_icarus.v >"$TMP/wrong.v"
beside() { ! show "$TMP/wrong.v" && grep -q '^not ok' "$TMP/said"; }
check "a row that stands elsewhere is noticed" beside
done_testing
