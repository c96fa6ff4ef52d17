# bundles.awk - bundles.def to a Verilog header (-v lang=v) or a C++ header (-v lang=c)
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -v lang=v|c -f sim/bundles.awk cmodel/machine/machine.def rtl/engine/bundles.def
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
    if (adds && lang == "v") define(toupper(name) "_ADDS", adds)
    adds = ""
    bits[name] = 1
}
# An event `counter NAME [if PARAMETER]`: a statement that adds it, as rt_core sums up.
function count_event(field, width, named, when, at) {
    if (!(named in counter)) fail("no counter of machine.def: " named)
    at = "add_e[8*`RT_COUNT_" named " +: 8]"
    adds = adds sprintf(" \\\n    %s%s = %s + {%d'd0, %s[`RT_%s_%s]};",
                        (when ? "if (" when " != 0) " : ""), at, at, 8 - width,
                        substr(name, 1, index(name, "_") - 1), toupper(name), field)
    only[counter[named]] = when
}
# How many counters, from 0 on, a core has: up to the last one that something in it counts.
function counters_used(i, text, n) {
    for (i in counter) if (!only[counter[i]] && counter[i] >= n) n = counter[i] + 1
    text = n
    for (i = n; i in only; i++)
        if (!(i + 1 in only) || only[i] != only[i + 1]) text = only[i] " != 0 ? " i + 1 " : " text
    return "(" text ")"
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
FILENAME ~ /machine\.def$/ {
    if ($1 == "counter") counter[$3] = $2 + 0
    next
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
    if ($4 == "counter") {
        sub(/:$/, "", $5)
        sub(/:$/, "", $7)
        count_event($2, $3, $5, $6 == "if" ? $7 : "")
    }
    next
}
{ fail("neither bundle nor field: " $1) }
END {
    if (bad) exit 1
    close_bundle()
    if (lang == "v") define("COUNTERS_USED", counters_used())
    print lang == "v" ? "`endif" : "#endif"
}
