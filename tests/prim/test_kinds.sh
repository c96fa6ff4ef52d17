#!/bin/sh
# test_kinds.sh - a kind of primitive more gets into the RTL by two files of rtl/prim
# SPDX-License-Identifier: Apache-2.0
#
# In a copy of the RTL the steps of docs/design/extending.md are done for the kind `wedge`,
# a copy of rt_facet behind ports of its own: it answers what a triangle answers. Then a primitive
# gives point and normal nine clocks later than today's do: rt_hit makes the same surfaces of them.
# All runs in Icarus, in seconds.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
here=$PWD
mkdir -p "$TMP/copy" && cp -r VERSION cmodel lab rtl sim tb "$TMP/copy" && cd "$TMP/copy" || exit 1

# ---- a kind more ----
sed -i 's/^kind   2      plane .*/&\nkind   3      wedge/' cmodel/machine/machine.def
mkdir driver docs && python3 -m lab layout || exit 1
run() { # top, files
    top=$1
    shift
    # shellcheck disable=SC2046  # lists of words on purpose
    iverilog -g2005 -Wall -s "$top" -o "$TMP/$top" "$@" $(find rtl -name '*.v') \
        $(find rtl -name '*.vh' -exec dirname {} + | sort -u | sed 's/^/-I/') >"$TMP/log" 2>&1 &&
        ! grep -v -e timescale -e 'tests/prim' "$TMP/log" && vvp -n "$TMP/$top" && return
    cat "$TMP/log"
    return 1
}
answers() { run "$@" >said; cat said; grep -q '^same' said; }
differs() { run "$@" >said; cat said; grep -q '^differs' said; }
kinds() { "$1" two_kinds "$here/tests/prim/two_kinds.v"; }
check "a record of the new kind is none, before" kinds differs

prim=rtl/prim/rt_prim.v
cp $prim "$TMP/prim"
sed 's/module rt_facet \(.\)(/module rt_wedge \1(/' rtl/prim/rt_facet.v >rtl/prim/rt_wedge.v
sed -n '/wire \[RB-1:0\] facet_result/,/results\[RB\*FACET/p' $prim |
    sed -e '/EVENT_FACET/d; s/facet_result/wedge_result/g; s/FACET\]/WEDGE]/g' \
        -e 's/RB\*FACET/RB*WEDGE/; s/rt_facet \(.\)(/rt_wedge \1(/; s/u_facet/u_wedge/' \
        -e 's/event_o.*DIVIDE\]/wedge_divide/' \
        -e 's/(kind_is(head, `RT_TRIANGLE).*/kind_is(head, `RT_WEDGE);/' \
        -e '1s/^/            wire wedge_divide;\n/' >"$TMP/unit"
sed -i -e 's/FACET = 1, UNITS = FACETS != 0 ? 2/FACET = 1, WEDGE = 2, UNITS = FACETS != 0 ? 3/' \
    -e "/results\[RB\*FACET/r $TMP/unit" $prim
check "a unit and its lines in rt_prim, and it answers as a triangle does" kinds answers
sed -i 's/kind_is(head, `RT_WEDGE)/kind_is(head, `RT_TRIANGLE)/' $prim
check "... not if its kind is confused" kinds differs
cp "$TMP/prim" $prim

# ---- point and normal that come later ----
sed -e 's/module rt_hit /module rt_hit_late /; s/rt_hit_point \(.\)(/rt_prim_point_late \1(/' \
    -e 's/`RT_PRIM_POINT_LATER && //' \
    rtl/shade/rt_hit.v >rtl/shade/rt_hit_late.v
late() { "$1" late_point "$here/tests/prim/late_point.v" "-Plate_point.INTERVAL=$2"; }
for interval in 8 12; do
    check "a primitive may give point and normal later: a hit every $interval clocks" \
        late answers $interval
done
sed -i 's/ && !late;/;/' rtl/shade/rt_hit_late.v
for interval in 8 12; do
    check "... not if rt_hit goes on without them: $interval" late differs $interval
done

# ---- kinds stay in their folder ----
cd "$here" || exit 1
named() { # file of rtl, line: what make lint says of a copy in which the file has it
    rm -rf "$TMP/copy" && mkdir "$TMP/copy" && cp -r cmodel rtl sim docs "$TMP/copy" &&
        sed -i "s/^endmodule/$2\n&/" "$TMP/copy/$1" &&
        ! sh "$TMP/copy/sim/lint_text.sh" >"$TMP/said" 2>/dev/null &&
        grep -A 1 'outside of rtl/prim' "$TMP/said" | grep "^$1:" | grep -F ":$2"
}
check "make lint tells of a kind that is named elsewhere" \
    named rtl/trace/rt_leaf_unit.v "wire plane = kind == \`RT_PLANE;"
check "... of its field" named rtl/shade/rt_hit.v "wire any = k[\`RT_PRIM_KIND_LSB +: 8];"
check "... of its name" named rtl/shade/rt_surface.v 'reg r_facet_q;'
done_testing
