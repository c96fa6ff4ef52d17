#!/bin/sh
# test_case.sh - make case: its four parts on one page, of what a small run in Icarus left
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
export BUILD
made() { # as test_report.sh has it
    env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory case B="$BUILD" JOBS=1 \
        SIM=icarus SIZE=12x8 "$@"
}
page=
of() { # scene, profile: its page
    made "SCENE=$1" "PROFILE=$2" >"$TMP/said" 2>&1 || { cat "$TMP/said" && return 1; }
    page=$(sed -n '$s|^look at file://||p' "$TMP/said")
    [ -f "$page" ]
}
has() { grep -qE -- "$1" "$page"; }
alone() { # nothing is asked for elsewhere
    ! grep -oE '(src|href)="[^"]*"|url\([^)]*\)|@import' "$page" | grep -vE '"(data:|$)'
}

# ---- scenes, and what their pages say ----
while IFS='|' read -r scene profile what words; do
    [ -z "$scene" ] || check "$scene: a page" of "$scene" "$profile"
    check "... $what" has "$words"
done <<'END'
paper5|draft|(a) a row a profile, the plot|<td>reference</td>
||... with the RTL's own cycles|Cycles of draft are the RTL
||... and its picture|<svg
||(b) floats beside integers|<td>reflected</td><td>float32</td>
||... and no red pixel|none is red
||(c) the whole core|the whole one, all effects on</td><td><code>all
||... why an effect is on, with file and line|mirrors [0-9]*/256
||... energy|Energy, as standard cells of 0.18 um: ~
||(d) units|Where cycles go
huge_tiny|standard|left out, as no ray meets it|<li>inside: .*no ray of this frame
tests/tool/floats/eye_in_triangle.nff|reference|facets alone|<td>no primitive has an image
||... a frame that floats get wrong|float32 sees another primitive in [1-9]
||... which is marked|<tr class="wrong"><td[^>]*>primary
END
check "... every file is in the page" alone

# ---- a fault ----
run=${page%/case.html}
cp -r "$run" "$TMP/wrong"
report() { python3 -m lab case "$TMP/wrong"; }
python3 - "$TMP/wrong/report.json" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
report["mismatches"] = 1
json.dump(report, open(sys.argv[1], "w"))
END
check "a run with a fault has a page too" report
page=$TMP/wrong/case.html
check "... that begins with it" has '<div class="verdict wrong">1 mismatches'
check "the report links the page" grep -q 'href="case.html"' "$TMP/wrong/report.html"
refused() { ! report >"$TMP/said" 2>&1 && grep -q "^case: .*rtl.clocks" "$TMP/said"; }
head -c 100 "$TMP/wrong/rtl.clocks" >"$TMP/cut" && mv "$TMP/cut" "$TMP/wrong/rtl.clocks"
check "a file that is cut is refused" refused
done_testing
