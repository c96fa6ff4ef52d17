# help.awk - help from `target: ... ## text` and `## VARIABLE RULE text` lines of makefiles
# SPDX-License-Identifier: Apache-2.0
#
# Needs cmodel/machine/effects.awk and sim/rules.awk before it and machine.def as the first file:
# {words} in a text are those that a core can be built with, {not in all} those that the core `all`
# has not. usual: names that are printed; empty: all, with all that is said of a variable.
function fill(text, i, words_all, rest) {
    for (i = 1; i <= words; i++) {
        words_all = words_all " " word[i] (most[i] > 1 ? "N" : "")
        if (!all[i]) rest = rest " " word[i]
    }
    sub(/\{words\}/, substr(words_all, 2), text)
    sub(/\{not in all\}/, substr(rest, 2), text)
    return text
}
function shown(name) { return usual == "" || index(" " usual " ", " " name " ") }
function fold(text, lines, n, part, i) { # pieces of at most 66 columns, lines[1..]
    split("", lines)
    n = 1
    while (length(text) > 66) {
        for (i = 66; i > 1 && substr(text, i, 1) != " "; i--);
        lines[n++] = substr(text, 1, i - 1)
        text = substr(text, i + 1)
    }
    lines[n] = text
    return n
}
BEGIN {
    print "Sphaera: a ray tracer in hardware, for spheres, triangles and planes\n"
    print "make TARGET [VARIABLE=value ...]\n"
}
/^[a-z][a-z-]*:[^=].*## / || /^[a-z][a-z-]*: *## / {
    text = $0
    sub(/.*## /, "", text)
    sub(/:.*/, "")
    if (shown($0)) printf "  %-12s %s\n", $0, text
}
/^## [A-Z_]+ / {
    name = ""
    if (!shown($2)) next
    name = $2
    rule = spoken($3)
    sub(/^## [A-Z_]+ +[^ ]+ */, "")
    text = rule (rule != "" && $0 != "" ? ": " : "") $0
    n = fold(text, line)
    for (i = 1; i <= n; i++)
        variables = variables sprintf("  %-14s %-12s %s\n", i > 1 ? "" : name,
                                      i > 1 ? "" : ENVIRON[name], line[i])
}
/^##  +/ && name && usual == "" {
    sub(/^## +/, "")
    n = fold(fill($0), line)
    for (i = 1; i <= n; i++) variables = variables sprintf("  %-14s %-12s %s\n", "", "", line[i])
}
END { printf "\n%s", variables }
