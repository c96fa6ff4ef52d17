# gen_layout.awk - machine.def to a C header (-v lang=c) or a Verilog header (-v lang=v)
# SPDX-License-Identifier: Apache-2.0
function def(name, value) {
    if (lang == "c") printf "#define SPH_%s %s\n", name, value
    else printf "`define RT_%s %s\n", name, value
}
BEGIN {
    if (lang == "c") {
        print "/* layout.h - generated from machine.def by gen_layout.awk; do not edit"
        print " * SPDX-License-Identifier: Apache-2.0\n */"
        print "#ifndef SPH_LAYOUT_H\n#define SPH_LAYOUT_H\n"
    } else {
        print "// rt_layout.vh - generated from machine.def by gen_layout.awk; do not edit"
        print "// SPDX-License-Identifier: Apache-2.0"
        print "`ifndef RT_LAYOUT_VH\n`define RT_LAYOUT_VH"
    }
}
{ sub(/#.*/, "") }
$1 == "profile" {
    row = row sprintf("%s{\"%s\", %s, %s, %s, %s, %s, %s}", row ? ", " : "", $2, $3, $4, $5, $6,
                      $7, $8)
    p = "PROFILE_" toupper($2) "_"
    if (lang == "v") {
        def(p "W", $3); def(p "WD", $4); def(p "PQ", $5); def(p "NG", $6); def(p "FW", $7)
        def(p "PR", $8)
    }
}
$1 == "width" {
    p = "WIDTH_" toupper($2) "_"
    why = $7
    for (i = 8; i <= NF; i++) why = why " " $i
    widths = widths sprintf("%s{\"%s\", offsetof(struct sph_profile, %s), %s, %s, %s, %s, \"%s\"}",
                            widths ? ", " : "", $2, $2, $3, $4, $5, $6, why)
    if (lang == "v") { def(p "LSB", $3); def(p "MIN", $5); def(p "MAX", $6) }
}
$1 == "const"   { def($2, $3) }
$1 == "field" && $3 == "stride" { def(toupper($2) "_STRIDE", $5); next }
$1 == "field"   { def(toupper($2 "_" $3) "_LSB", $4); def(toupper($2 "_" $3) "_BITS", $5) }
$1 == "reg"     { def("REG_" $3, $2) }
$1 == "effect"  { def("EFFECT_" $3, $2) }
$1 == "counter" {
    def("COUNT_" $3, $2)
    names = names sprintf("%s\"%s\"", names ? ", " : "", tolower($3))
    if ($4 == "both") both += 2 ^ $2
    counters++
}
$1 == "error" {
    def("ERROR_" $3, $2)
    errors = errors sprintf("%s\"%s\"", errors ? ", " : "", tolower($3))
    n_errors++
}
END {
    def("COUNTERS", counters); def("COUNTERS_BOTH", both); def("ERRORS", n_errors)
    if (lang == "c") {
        def("PROFILE_TABLE", row); def("WIDTH_TABLE", widths)
        def("COUNTER_NAMES", names); def("ERROR_NAMES", errors)
        print "\n#endif"
    } else print "`endif"
}
