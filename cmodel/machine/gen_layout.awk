# gen_layout.awk - machine.def to a C header (-v lang=c) or Verilog headers (the other lang)
# SPDX-License-Identifier: Apache-2.0
#
# Needs effects.awk before it; sim/layout.sh runs it. layout: layout of memory, registers, numbers.
# What rt_core, what is around it and modules in it have in common: effects, a parameter for each
# width and effect; core_parameters, the others too; effects_pass and core_pass, what is given to
# parameters of the same name; core_rules, how many units there are and what is legal.
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
function head(file, what) {
    printf "// %s - generated from machine.def by gen_layout.awk; do not edit\n", file
    printf "// SPDX-License-Identifier: Apache-2.0\n// %s\n", what
}
function parameter(name, value, what) { # the last ends a list: no comma
    name = sprintf("    parameter %-10s = %s%s", name, value, name == size[sizes] ? "" : ",")
    printf "%-33s// %s\n", name " ", what
}
function words_from(i, to) {
    for (; i <= to; i++)
        parameter(core[i], all[i], (most[i] > 1 ? "0.." most[i] : "0 or 1") ": " about[i])
}
function effect_parameters(i) {
    head("rt_effects.vh", "Widths and effects: the first of the parameters of a module.")
    for (i = 1; i <= n_widths; i++)
        parameter(width[i], "`RT_PROFILE_STANDARD_" width[i], width_about[i])
    print "    // effects that are elaborated, a machine that asks for more is refused " \
          "(MISSING_EFFECT)"
    words_from(1, effects)
}
function core_parameters(i) {
    head("rt_core_parameters.vh", "All parameters of rt_core: the last of those of a module.")
    print "    `include \"rt_effects.vh\""
    words_from(effects + 1, words)
    print "    // sizes, on which only cells and cycles depend"
    for (i = 1; i <= sizes; i++)
        parameter(size[i], standard[i], least[i] ".." largest[i] \
                  (power[i] ? ", power of two" : "") ": " size_about[i])
}
function check(legal, message) { # one line of rt_core_rules.vh
    gsub(/[+]/, "_plus_", message)
    checks = checks sprintf("    `RT_CHECK(%s, rt_core_%s)\n", legal, message)
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
function core_rules(i, n, part, k, line) { # lines that end where an alternative does
    head("rt_core_rules.vh", "Units of an engine, legal values of parameters, alone and together.")
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
    all_checks()
    printf "%s", checks
}
function connect(name, end) {
    name = "." name "(" name ")" end
    if (length(line name) > 90) {
        print line
        line = ""
    }
    line = line (line ? " " : "        ") name
}
function effects_pass(i) {
    head("rt_effects_pass.vh", "rt_effects.vh to an instance, by name: the first that it is given.")
    for (i = 1; i <= n_widths; i++) connect(width[i], ",")
    for (i = 1; i <= effects; i++) connect(core[i], ",")
    print line
}
function core_pass(i) {
    head("rt_core_pass.vh", "rt_core_parameters.vh to an instance, by name: all that it is given.")
    print "        `include \"rt_effects_pass.vh\""
    for (i = effects + 1; i <= words; i++) connect(core[i], ",")
    for (i = 1; i <= sizes; i++) connect(size[i], i < sizes ? "," : "")
    print line
}
function def(name, value) {
    if (lang != "c" && lang != "layout") return
    if (lang == "c") printf "#define SPH_%s %s\n", name, value
    else printf "`define RT_%s %s\n", name, value
}
BEGIN {
    if (lang == "c") {
        print "/* layout.h - generated from machine.def by gen_layout.awk; do not edit"
        print " * SPDX-License-Identifier: Apache-2.0\n */"
        print "#ifndef SPH_LAYOUT_H\n#define SPH_LAYOUT_H\n"
    } else if (lang == "layout") {
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
    if (lang == "layout") {
        def(p "W", $3); def(p "WD", $4); def(p "PQ", $5); def(p "NG", $6); def(p "FW", $7)
        def(p "PR", $8)
    }
}
$1 == "width" {
    p = "WIDTH_" toupper($2) "_"
    why = $7
    for (i = 8; i <= NF && $i != ":"; i++) why = why " " $i
    widths = widths sprintf("%s{\"%s\", offsetof(struct sph_profile, %s), %s, %s, %s, %s, \"%s\"}",
                            widths ? ", " : "", $2, $2, $3, $4, $5, $6, why)
    if (lang == "layout") def(p "LSB", $3)
    width[++n_widths] = toupper($2)
    width_about[n_widths] = $0
    sub(/^.* : /, "", width_about[n_widths])
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
    counter_name[++counters] = tolower($3)
}
$1 == "error" {
    def("ERROR_" $3, $2)
    errors = errors sprintf("%s\"%s\"", errors ? ", " : "", tolower($3))
    n_errors++
}
END {
    if (failed) exit 1
    if (lang == "effects") effect_parameters()
    else if (lang == "effects_pass") effects_pass()
    else if (lang == "core_parameters") core_parameters()
    else if (lang == "core_pass") core_pass()
    else if (lang == "core_rules") core_rules()
    if (lang != "c" && lang != "layout") exit
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
        for (i = 1; i <= sizes; i++)
            each_size = each_size sprintf(" \\\n    X(%s, %s)", size[i], standard[i])
        for (i = 1; i <= paces; i++)
            each_pace = each_pace sprintf(" \\\n    X(%s, %s, %s)", toupper(pace_of[i]),
                                          pace_size[i], pace_value[i])
        for (i = 1; i <= units; i++)
            each_unit = each_unit sprintf(" \\\n    X(%s, (%s))", unit[i], how_many[i])
        for (i = 1; i <= rates; i++)
            each_rate = each_rate sprintf(" \\\n    X(%s, (%s))", rate[i], rate_is[i])
        for (i = 1; i <= loads; i++) {
            text = load[i]
            gsub(/_/, " ", text)
            each_load = each_load sprintf(" \\\n    X(%s, \"%s\", %s, %s)", load[i], text,
                                          load_units[i], load_clocks[i])
        }
        for (i = 1; i <= counters; i++) each_counter = each_counter \
            sprintf(" \\\n    X(%s, %s)", toupper(counter_name[i]), counter_name[i])
        def("EACH_COUNTER(X)", each_counter)
        def("EACH_SIZE(X)", each_size)
        def("EACH_PACE(X)", each_pace)
        def("EACH_UNIT_COUNT(X)", each_unit)
        def("EACH_RATE(X)", each_rate)
        def("EACH_LOAD(X)", each_load)
        print "\n#endif"
    } else {
        def("EFFECTS_BUILT", "(32'd0" built ")")
        def("DEEPEST", "(REFRACT != 0 && REFLECT < `RT_REFRACT_DEPTH ? " \
                       "`RT_REFRACT_DEPTH : REFLECT)")
        print "`endif"
    }
}
