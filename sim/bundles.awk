# bundles.awk - bundles.def to a Verilog header (-v lang=v) or a C++ header (-v lang=c)
# SPDX-License-Identifier: Apache-2.0
function fail(text) {
    print FILENAME ":" FNR ": " text >"/dev/stderr"
    bad = 1
    exit 1
}
# A width as an expression of the language; a bundle's name stands for its bits.
function expression(width) {
    if (width in bits) return tick "RT_" toupper(width) "_BITS"
    if (width !~ /^[0-9A-Z_+*()]+$/) fail("no width: " width)
    gsub(/[A-Z]+_BITS/, (lang == "v" ? "`RT_" : "SPH_") "&", width)
    if (lang == "v") gsub(/SLOTW/, "$clog2(SLOTS)", width)
    return width
}
# The sum of the widths so far; numbers and equal terms are added up.
function sum(i, all, term) {
    all = ""
    for (i = 1; i <= terms; i++) {
        term = count[i] == 1 ? word[i] : count[i] "*" (word[i] ~ /[+]/ ? "(" word[i] ")" : word[i])
        all = all (i > 1 ? "+" : "") term
    }
    return all (terms && number ? "+" : "") (number || !terms ? number : "")
}
function add(width, i) {
    if (width ~ /^[0-9]+$/) {
        number += width
        return
    }
    for (i = 1; i <= terms && word[i] != width; i++)
        ;
    if (i > terms) count[terms = i] = 0
    word[i] = width
    count[i]++
}
function define(name, value) {
    if (lang == "v") printf "`define RT_%s %s\n", name, value
    else printf "#define RT_%s %s\n", name, value
}
function close_bundle() {
    if (name) define(toupper(name) "_BITS", "(" sum() ")")
    bits[name] = 1
}
BEGIN {
    tick = lang == "v" ? "`" : ""
    if (lang == "v") {
        print "// rt_bundles.vh - generated from bundles.def by sim/bundles.awk; do not edit"
        print "// SPDX-License-Identifier: Apache-2.0"
        print "// bus[`RT_RAY_ORG] is field ORG of a bus of `RT_RAY_BITS bits, a bundle ray"
        print "`ifndef RT_BUNDLES_VH\n`define RT_BUNDLES_VH\n`include \"rt_layout.vh\""
    } else {
        print "/* bundles.h - generated from bundles.def by sim/bundles.awk; do not edit"
        print " * SPDX-License-Identifier: Apache-2.0"
        print " * The arguments low bit, bits of bench::put() and bench::get() for each field. */"
        print "#ifndef SPH_BUNDLES_H\n#define SPH_BUNDLES_H\n#include \"machine/layout.h\""
    }
}
/^ *(#|$)/ { next }
$1 == "bundle" {
    close_bundle()
    name = $2
    terms = 0
    number = 0
    next
}
$1 == "field" {
    if (!name) fail("a field before its bundle")
    if ((name, $2) in known) fail("twice: " $2)
    known[name, $2] = 1
    width = expression($3)
    if (lang == "v") define(toupper(name) "_" $2, sum() " +: " width)
    else define(toupper(name) "_" $2, "(" sum() "), (" width ")")
    add(width)
    next
}
{ fail("neither bundle nor field: " $1) }
END {
    if (bad) exit 1
    close_bundle()
    print lang == "v" ? "`endif" : "#endif"
}
