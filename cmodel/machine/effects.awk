# effects.awk - effects, parts and sizes in machine.def, read by whatever follows it
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -f cmodel/machine/effects.awk -f PROGRAM [...] cmodel/machine/machine.def
# Leaves, in order, word[1..words], the first `effects` of them effects, number[word], and by number
# core, bit (-1: none), most, all, asked, option, needs, excludes (lists of words) and about; sizes
# as size[1..sizes], and by number standard, least, largest, power (1: of two) and size_about; units
# as unit[1..units] and how_many, rules as rule_name[1..rules] and must_hold; rates as
# rate[1..rates] and rate_is, loads as load[1..loads], load_units and load_clocks; of paces
# pace_of[1..paces], pace_size and pace_value.
function effects_fail(why) {
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    failed = 1
    exit 1
}
function effects_unknown(list, part, n, i) { # the first of these words that stands nowhere
    n = split(list, part, ",")
    for (i = 1; i <= n; i++) if (!(part[i] in number)) return part[i]
    return ""
}
$1 == "effect" || $1 == "part" {
    if ($2 in number) effects_fail($2 " stands twice")
    if ($2 !~ /^[a-z]+$/) effects_fail("\"" $2 "\" is no word of small letters")
    if ($1 == "effect" && words != effects + 0) effects_fail("an effect stands above each part")
    word[++words] = $2
    number[$2] = words
    if ($1 == "effect") effects = words
    core[words] = toupper($2); bit[words] = -1; most[words] = 1; option[words] = "none"
    full = ""
    for (i = 3; i <= NF && $i != ":"; i++) {
        field = substr($i, 1, index($i, "=") - 1)
        given = substr($i, index($i, "=") + 1)
        if (field == "core") core[words] = given
        else if (field == "bit") bit[words] = given + 0
        else if (field == "most") most[words] = given + 0
        else if (field == "all") full = given
        else if (field == "asked") asked[words] = given
        else if (field == "option") option[words] = given
        else if (field == "needs") needs[words] = given
        else if (field == "excludes") excludes[words] = given
        else effects_fail("\"" $i "\" is none of core, bit, most, all, asked, option, needs, " \
                          "excludes")
    }
    all[words] = full == "" ? most[words] : full + 0
    if (option[words] !~ /^(when|count|off|none)$/)
        effects_fail("option is \"" option[words] "\", none of when, count, off and none")
    if (bit[words] >= 0 && bit[words] in taken) effects_fail("bit " bit[words] " is taken")
    if (bit[words] < 0 && asked[words] == "") effects_fail("nothing asks for " $2)
    if (bit[words] >= 0) taken[bit[words]] = 1
    if (bit[words] >= bits) bits = bit[words] + 1
}
$1 == "size" {
    size[++sizes] = $2
    standard[sizes] = $3; least[sizes] = $4; largest[sizes] = $5; power[sizes] = $6 == "power"
    text = $0
    if (!sub(/^.* : /, "", text)) effects_fail($2 ": what it is does not stand behind a colon")
    size_about[sizes] = text
    next
}
$1 == "unit" || $1 == "legal" || $1 == "rate" {
    text = $0
    if (!sub(/^[^:]* : /, "", text)) effects_fail($2 ": no expression stands behind a colon")
    if ($1 == "unit") { unit[++units] = $2; how_many[units] = text }
    else if ($1 == "rate") { rate[++rates] = $2; rate_is[rates] = text }
    else { rule_name[++rules] = $2; must_hold[rules] = text }
    next
}
$1 == "load" {
    if (split($0, text_part, / +: /) != 3) effects_fail($2 ": not `load name : units : clocks`")
    load[++loads] = $2; load_units[loads] = text_part[2]; load_clocks[loads] = text_part[3]
    next
}
$1 == "pace" {
    for (i = 3; i <= NF; i++) {
        for (k = 1; k <= sizes && size[k] != substr($i, 1, index($i, "=") - 1); k++) ;
        given = substr($i, index($i, "=") + 1) + 0
        if (k > sizes) effects_fail("\"" $i "\" is no size=value")
        if (given < least[k] || given > largest[k])
            effects_fail($i " is not in " least[k] ".." largest[k])
        pace_of[++paces] = $2; pace_size[paces] = size[k]; pace_value[paces] = given
    }
    next
}
words && /(^| ): / {
    text = $0
    sub(/^.*[ ]: /, "", text)
    sub(/^ *: /, "", text)
    if (about[words] == "") about[words] = text
}
END {
    if (failed) exit 1
    for (i = 1; i <= words; i++) {
        if (about[i] == "") effects_fail(word[i] ": what it is does not stand behind a colon")
        unknown = effects_unknown(needs[i]) effects_unknown(excludes[i])
        if (unknown != "") effects_fail(word[i] ": there is no " unknown)
    }
}
