# only.awk - says that no suite has ONLY in its name, and which one may be meant
# SPDX-License-Identifier: Apache-2.0
#
# After nearest.awk. only: what was asked for; suites: all names. Exit code 1.
BEGIN {
    n = split(suites, name, " ")
    for (i = 1; i <= n; i++) { # an ending counts if there is one
        word[i] = name[i]
        if (only !~ /[.]/) sub(/[.].*/, "", word[i])
        if (!(word[i] in whole)) whole[word[i]] = name[i]
    }
    meant = nearest(only, word, n)
    if (meant != "") meant = whole[meant]
    for (i = 1; i <= n; i++) { # without what people leave out
        short[i] = name[i]
        sub(/^test_/, "", short[i])
        sub(/[.].*/, "", short[i])
    }
    if (meant == "") meant = nearest(only, short, n)
    print "ONLY=" only ": no suite has this in its name" \
          (meant != "" ? "; is " meant " meant?" : "; `ls tests/*/test_*` shows them") \
          > "/dev/stderr"
    exit 1
}
