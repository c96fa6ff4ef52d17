# rules.awk - rules of make/variables.mk, as it says them
# SPDX-License-Identifier: Apache-2.0
#
# Reads machine.def, whose constants may be bounds, then variables.mk: known[1..n_known] are the
# names, rule_of[NAME] their rules. widths: parameters of a core, NAME=VALUE, that bounds may name.
function bound(sum, part, n, i, total) { # -1: it is open, or not known here
    n = split(sum, part, "+")
    for (i = 1; i <= n; i++) {
        if (part[i] !~ /^[0-9]+$/ && !(part[i] in constant)) return -1
        total += part[i] ~ /^[0-9]+$/ ? part[i] : constant[part[i]]
    }
    return n ? total : -1
}
function range(rule, ends) { # 0..MOST for people
    split(rule, ends, /\.\./)
    if (ends[2] == "") return ends[1] " and more"
    return ends[1] " to " (bound(ends[2]) < 0 ? ends[2] : bound(ends[2]))
}
# A rule for people; the words in it are choice[1..n_choices]. Kinds are left out.
function spoken(rule, alternative, n, i, text) {
    n = split(rule, alternative, "|")
    n_choices = 0
    for (i = 1; i <= n; i++) {
        if (sub(/@/, " (make ", alternative[i])) alternative[i] = alternative[i] ")"
        if (alternative[i] == "" || alternative[i] ~ /^</) continue
        if (alternative[i] ~ /\.\./) alternative[i] = range(alternative[i])
        else choice[++n_choices] = alternative[i]
        text = text (text != "" ? ", " : "") alternative[i]
    }
    return text
}
BEGIN {
    n = split(widths, part, " ")
    for (i = 1; i <= n; i++) {
        split(part[i], pair, "=")
        constant[pair[1]] = pair[2]
    }
}
$1 == "const" { constant[$2] = $3 }
/^## [A-Z_]+ / {
    known[++n_known] = $2
    rule_of[$2] = $3
}
