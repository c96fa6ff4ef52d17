# gen_layout.awk - machine.def to a C header (-v lang=c) or a Verilog header (-v lang=v)
# SPDX-License-Identifier: Apache-2.0
#
# Needs effects.awk before it. sim/layout.sh runs it, also for what stands in Verilog files between
# marks: lang=parameters, a parameter for each effect, part and size; lang=connections, its
# connection; lang=units, how many units there are.
function mask(list, part, n, i, bits_set) { # of words, by their place in the list
    n = split(list, part, ",")
    for (i = 1; i <= n; i++) bits_set += 2 ^ (number[part[i]] - 1)
    return bits_set + 0
}
function range(text, end) { # "3..4" or "3": one of its two ends
    if (!index(text, "..")) return text
    return end ? substr(text, index(text, "..") + 2) : substr(text, 1, index(text, "..") - 1)
}
function entry(i, when, count, lo, hi) { # X(NAME, word, ...) of SPH_EACH_PART
    when = asked[i]
    count = when
    if (index(when, "=")) {
        lo = substr(when, index(when, "=") + 1)
        when = substr(when, 1, index(when, "=") - 1)
        count = index(lo, ":") ? substr(lo, index(lo, ":") + 1) : ""
        sub(/:.*/, "", lo)
        hi = range(lo, 1)
        lo = range(lo, 0)
    } else when = ""
    return sprintf("X(%s, %s, \"%s\", %d, %d, %d, %s, %d, %d, %s, %s, %s, %s, \"%s\")",
                   toupper(word[i]), word[i], core[i], bit[i], most[i], all[i],
                   "SPH_OPTION_" toupper(option[i]), mask(needs[i]), mask(excludes[i]),
                   when == "" ? "-1" : "SPH_REG_" when, lo == "" ? "0" : lo, hi == "" ? "0" : hi,
                   count == "" ? "-1" : "SPH_REG_" count, about[i])
}
function parameter(name, value, range_text, what) { # the last ends a list: no comma
    name = sprintf("    parameter %-10s = %s%s", name, value, name == size[sizes] ? "" : ",")
    printf "%-33s// %s: %s\n", name " ", range_text, what
}
function parameters(i) {
    for (i = 1; i <= words; i++)
        parameter(core[i], all[i], most[i] > 1 ? "0.." most[i] : "0 or 1", about[i])
    for (i = 1; i <= sizes; i++)
        parameter(size[i], standard[i], least[i] ".." largest[i] (power[i] ? ", power of two" : ""),
                  size_about[i])
}
function check(legal, message) { # one line of RT_CHECK_CORE
    gsub(/[+]/, "_plus_", message)
    checks = checks sprintf(" \\\n    `RT_CHECK(%s, rt_core_%s)", legal, message)
}
function between(name, from, to, two, legal) {
    legal = sprintf("%s >= %s && %s <= %s", name, from, name, to)
    if (two) legal = legal sprintf(" && (%s & (%s - 1)) == 0", name, name)
    check(legal, name "_must_be_" (two ? "a_power_of_two_from_" : "") from "_to_" to)
}
function all_checks(i, k, n, part, legal) {
    for (i = 1; i <= words; i++) {
        between(core[i], 0, most[i])
        n = split(needs[i], part, ",")
        for (k = 1; k <= n; k++)
            check(core[i] " == 0 || " core[number[part[k]]] " != 0",
                  core[i] "_needs_" core[number[part[k]]])
        n = i > effects ? split(excludes[i], part, ",") : 0
        for (k = 1; k <= n; k++)
            check(core[i] " == 0 || " core[number[part[k]]] " == 0",
                  core[i] "_excludes_" core[number[part[k]]])
    }
    for (i = 1; i <= sizes; i++) between(size[i], least[i], largest[i], power[i])
    for (i = 1; i <= rules; i++) check(must_hold[i], rule_name[i])
}
function numbers(i, n, part, k, line) { # of units, lines that end where an alternative does
    for (i = 1; i <= units; i++) {
        line = "    localparam " unit[i] " ="
        n = split(how_many[i] ";", part, / : /)
        for (k = 1; k <= n; k++) {
            if (length(line part[k]) > 84) {
                print line
                line = "                            "
            }
            line = line (k > 1 ? " : " : " ") part[k]
        }
        print line
    }
}
function connections(i, line, next_one) {
    for (i = 1; i <= words + sizes; i++) {
        next_one = i <= words ? core[i] : size[i - words]
        next_one = "." next_one "(" next_one ")" (i < words + sizes ? "," : "")
        if (length(line next_one) > 90) {
            print line
            line = ""
        }
        line = line (line ? " " : "        ") next_one
    }
    print line
}
function def(name, value) {
    if (lang != "c" && lang != "v") return
    if (lang == "c") printf "#define SPH_%s %s\n", name, value
    else printf "`define RT_%s %s\n", name, value
}
BEGIN {
    if (lang == "c") {
        print "/* layout.h - generated from machine.def by gen_layout.awk; do not edit"
        print " * SPDX-License-Identifier: Apache-2.0\n */"
        print "#ifndef SPH_LAYOUT_H\n#define SPH_LAYOUT_H\n"
    } else if (lang == "v") {
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
    if (lang == "v") def(p "LSB", $3)
    between(toupper($2), $5, $6)
}
$1 == "const"   { def($2, $3) }
$1 == "kind" {
    def(toupper($3), $2)
    kinds++
    unbounded += ($4 == "unbounded") * 2 ^ $2
    each_kind = each_kind " \\\n    X(" $3 ")"
}
$1 == "field" && $3 == "stride" { def(toupper($2) "_STRIDE", $5); next }
$1 == "field"   { def(toupper($2 "_" $3) "_LSB", $4); def(toupper($2 "_" $3) "_BITS", $5) }
$1 == "reg"     { def("REG_" $3, $2); regs = regs " \\\n    X(" $3 ")" }
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
    if (failed) exit 1
    if (lang == "parameters") { parameters(); exit }
    if (lang == "connections") { connections(); exit }
    if (lang == "units") { numbers(); exit }
    for (i = 1; i <= words; i++) {
        if (bit[i] >= 0) {
            def("EFFECT_" toupper(word[i]), bit[i])
            effects_mask += 2 ^ bit[i]
            built = built sprintf(" | (%s != 0 ? 32'd1 << %d : 32'd0)", core[i], bit[i])
        }
        if (i <= effects) each_effect = each_effect " \\\n    " entry(i)
        else each_part = each_part " \\\n    " entry(i)
    }
    def("EFFECT_BITS", bits)
    def("KINDS", kinds)
    def("KINDS_UNBOUNDED", unbounded)
    def("COUNTERS", counters); def("COUNTERS_BOTH", both); def("ERRORS", n_errors)
    if (lang == "c") {
        def("PROFILE_TABLE", row); def("WIDTH_TABLE", widths)
        def("COUNTER_NAMES", names); def("ERROR_NAMES", errors)
        def("EFFECT_MASK", effects_mask)
        def("EACH_EFFECT(X)", each_effect)
        def("EACH_PART(X)", "SPH_EACH_EFFECT(X)" each_part)
        def("EACH_REG(X)", regs)
        def("EACH_KIND(X)", each_kind)
        print "\n#endif"
    } else {
        def("EFFECTS_BUILT", "(32'd0" built ")")
        def("DEEPEST", "(REFRACT != 0 && REFLECT < `RT_REFRACT_DEPTH ? " \
                       "`RT_REFRACT_DEPTH : REFLECT)")
        all_checks()
        def("CHECK_CORE", checks)
        print "`endif"
    }
}
