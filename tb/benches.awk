# benches.awk - lines of the lists of benches with the widths of their profiles filled in
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -v pattern=TEXT [-v all=1] -f tb/benches.awk cmodel/machine/machine.def tb/benches*.txt
# Prints those whose BENCH/CONFIGURATION has the pattern in it. In a list
#   each            stands for every profile, a line each; without `all` for the first and the last
#   more            before a line: only with `all`
#   NAME@PROFILE    is configuration NAME with the widths of a profile
#   W, WD, PQ, NG, FW, PR   alone are the width of the profile; XW=2*W+2*WD is made of them
function fail(why) {
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    failed = 1
    exit 1
}
function number(word, profile) {
    if (word ~ /^[0-9]+$/) return word
    if (!((profile, word) in width)) fail(word " is no number, and no width of " profile)
    return width[profile, word]
}
function value(text, profile, sum, term, factor, n, m, i, j, product) {
    if (text !~ /^[A-Z0-9+*]+$/) return text
    n = split(text, term, "+")
    for (i = 1; i <= n; i++) {
        m = split(term[i], factor, "*")
        product = 1
        for (j = 1; j <= m; j++) product *= number(factor[j], profile)
        sum += product
    }
    return sum
}
function line(name, profile, i, text, at) {
    if (($3, name) in named) fail($3 "/" name " stands twice")  # both would share a folder
    named[$3, name] = 1
    text = name " " $2 " " $3
    for (i = 4; i <= NF; i++) {
        at = index($i, "=")
        if ($i == "/") text = text " /"
        else if (at) text = text " " substr($i, 1, at) value(substr($i, at + 1), profile)
        else text = text " " $i "=" number($i, profile)
    }
    if (index($3 "/" name, pattern)) print text
}
NR == FNR {
    if ($1 != "profile") next
    profiles[++count] = $2
    split("W WD PQ NG FW PR", key, " ")
    for (k = 1; k <= 6; k++) width[$2, key[k]] = $(k + 2)
    next
}
/^#/ || !NF { next }
$1 == "more" {
    if (!all) next
    sub(/^more +/, "")
}
$1 == "each" {
    for (p = 1; p <= count; p += all ? 1 : count - 1) line(profiles[p], profiles[p])
    next
}
{
    n = split($1, part, "@")
    line(part[1], part[n])
}
END { exit failed }
