# faults.awk - table of the faults put into model and RTL, and the case or test that notices each
# SPDX-License-Identifier: Apache-2.0
#
# usage: awk -f tests/hard/faults.awk tests/hard/mutants.txt tests/hard/rtl_mutants.txt
# The fault of one name in both files is one line.
/^(mutant|more) / {
    name = $0
    sub(/^[a-z]+ +/, "", name)
    if (!(name in model) && !(name in rtl)) order[++n] = name
    later = $1 == "more"
}
/^(file|bench) / { where = $2 }
/^(case|test) / {
    if (FNR == NR) model[name] = "`" where "`, " ($1 == "test" ? "`" $2 "`" : $2)
    else rtl[name] = "`" where "`, " $2 (later ? " *" : "")
}
END {
    print "| fault | model: file, case | RTL: bench, case |\n|---|---|---|"
    for (i = 1; i <= n; i++)
        printf "| %s | %s | %s |\n", order[i], model[order[i]], rtl[order[i]]
}
