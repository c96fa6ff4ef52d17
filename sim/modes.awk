# modes.awk - modes.def to a Verilog header (-v lang=v), a C header (c) or tables of the page (md)
# SPDX-License-Identifier: Apache-2.0
function fail(text) {
    print FILENAME ":" FNR ": " text >"/dev/stderr"
    bad = 1
    exit 1
}
function macro(name) {
    gsub(/[^A-Z0-9]/, "_", name)
    return name
}
# The numbers of a mode, in the order of the fields.
function values(i, text) {
    for (i = 1; i <= fields; i++) text = text (i > 1 ? ", " : "") value[field[i]]
    return text
}
function concatenation(i, text) { # the last field stands highest
    for (i = fields; i; i--) text = text (i < fields ? ", " : "") bits[i] "'d" value[field[i]]
    return text
}
# What the display takes at most, MB/s: pixels of a row by the time of a row.
function rate(bytes) {
    return sprintf("%.0f", value["H_ACTIVE"] * bytes * khz / h_total / 1000)
}
function row() {
    printf "| %s | %.3f | %d, %d, %d, %d | %s | %d, %d, %d, %d | %s | %d x %d | %.2f | ", name, \
        khz / 1000, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, h_total, v_total, \
        khz * 1000 / h_total / v_total
    printf "%s / %s | %s |\n", rate(4), rate(2), standard
}
BEGIN {
    if (lang == "v") {
        print "// rt_modes.vh - generated from modes.def by sim/modes.awk; do not edit"
        print "// SPDX-License-Identifier: Apache-2.0"
        print "// mode_i[`RT_MODE_H_SYNC] is a field of the bundle; `RT_MODE_640X480 is a whole one"
        print "`ifndef RT_MODES_VH\n`define RT_MODES_VH"
    } else if (lang == "c") {
        print "/* sphaera_modes.h - generated from modes.def by sim/modes.awk; do not edit"
        print " * SPDX-License-Identifier: Apache-2.0"
        print " * SPHAERA_MODES(X): X(name, kHz, fields as SPHAERA_MODE_FIELDS names them) each. */"
        print "#ifndef SPHAERA_MODES_H\n#define SPHAERA_MODES_H"
    } else {
        print "| mode | MHz | active, front, sync, back | hsync | rows: the same | vsync |" \
              " whole frame | Hz | MB/s, 32 / 16 bit | standard |"
        print "|---|---|---|---|---|---|---|---|---|---|"
    }
}
/^ *(#|$)/ { next }
$1 == "field" {
    if ($2 in known) fail($2 " stands twice")
    if ($3 !~ /^[1-9][0-9]*$/) fail($2 ": " $3 " is no width")
    known[$2] = 1
    field[++fields] = $2
    bits[fields] = $3
    if (lang == "v") printf "`define RT_MODE_%s %d +: %d\n", $2, at, $3
    names = names (fields > 1 ? ", " : "") tolower($2)
    at += $3
    next
}
$1 == "mode" {
    name = $2
    khz = $3
    if (name in known) fail(name " stands twice")
    known[name] = 1
    if (NF < 14) fail(name " has no standard, or too few numbers")
    for (i = 3; i <= 13; i++)
        if (i == 8 || i == 13 ? $i !~ /^[-+]$/ : $i !~ /^[1-9][0-9]*$/)
            fail(name ": \"" $i "\" is no " (i == 8 || i == 13 ? "polarity" : "number"))
    split("H_ACTIVE H_FRONT H_SYNC H_BACK H_POL V_ACTIVE V_FRONT V_SYNC V_BACK V_POL", word, " ")
    for (i = 1; i <= 10; i++) value[word[i]] = i % 5 ? $(i + 3) : $(i + 3) == "+"
    standard = $0
    for (i = 1; i <= 13; i++) sub(/^[^ ]+ +/, "", standard)
    h_total = $4 + $5 + $6 + $7
    v_total = $9 + $10 + $11 + $12
    if (lang == "v")
        printf "`define RT_MODE_%s {%s}\n", macro(toupper(name)), concatenation()
    if (lang == "c")
        modes = modes " \\\n    X(\"" name "\", " khz ", " values() ")"
    if (lang == "md") row()
    next
}
{ fail("neither field nor mode: " $1) }
END {
    if (bad) exit 1
    if (lang == "v") print "`define RT_MODE_BITS " at "\n`endif"
    if (lang == "c") {
        print "#define SPHAERA_MODE_FIELDS " names
        print "#define SPHAERA_MODES(X)" modes "\n#endif"
    }
}
