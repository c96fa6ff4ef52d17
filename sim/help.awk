# help.awk - help from `target: ... ## text` and `## VARIABLE text` lines of makefiles
# SPDX-License-Identifier: Apache-2.0
BEGIN {
    n = split(ENVIRON["HELP_VALUES"], pairs, /; */)
    for (i = 1; i <= n; i++) {
        eq = index(pairs[i], "=")
        value[substr(pairs[i], 1, eq - 1)] = substr(pairs[i], eq + 1)
    }
    print "Sphaera: a ray tracer for spheres in hardware\n\nmake TARGET [VARIABLE=value ...]\n"
}
/^[a-z][a-z-]*:[^=].*## / || /^[a-z][a-z-]*: *## / {
    text = $0
    sub(/.*## /, "", text)
    sub(/:.*/, "")
    printf "  %-12s %s\n", $0, text
}
/^## [A-Z_]+ / {
    name = $2
    sub(/^## [A-Z_]+ +/, "")
    variables = variables sprintf("  %-12s %-18s %s\n", name, value[name], $0)
}
/^##  +/ && name {
    sub(/^## +/, "")
    variables = variables sprintf("  %-12s %-18s %s\n", "", "", $0)
}
END { printf "\n%s", variables }
