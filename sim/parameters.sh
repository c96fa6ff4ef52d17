#!/bin/sh
# parameters.sh - what a core is elaborated with, from the names of what it can do
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/parameters.sh LIST | --names [all|counted] | --table | --help
#   LIST     all, all-NAME (all but one), none, or words joined by +, the first of which may be all;
#            words are those of effects and parts in machine.def, with a count if most is above 1
#   --names  every such word, one a line; those that the core `all` has; those with a count
#   --table  the whole list, a line each: word, parameter, bit, most, all, needs, excludes, meaning
# Prints the parameters of rtl/core/rt_core.v, NAME=VALUE, all on one line. all-NAME leaves out
# what needs NAME too, and all+bih what does not go with a BIH.
set -eu
[ $# -gt 0 ] || {
    sed -n 's/^# usage: /usage: /p' "$0" >&2
    exit 1
}
machine=$(dirname "$0")/../cmodel/machine
awk -v list="$1" -v which="${2:-}" -f "$machine/effects.awk" -f "$(dirname "$0")/nearest.awk" -f - \
    "$machine/machine.def" <<'END'
function fail(why) {
    print list why > "/dev/stderr"
    failed = 1
    exit 1
}
function lacks(i, part, n, k) { # 1 if something that i needs is not there
    n = split(needs[i], part, ",")
    for (k = 1; k <= n; k++) if (!value[number[part[k]]]) return 1
    return 0
}
function leave_out(excluded, part, n, k) { # parts of the core `all`
    n = split(excluded, part, ",")
    for (k = 1; k <= n; k++) value[number[part[k]]] = 0
}
function spoken(text) { # a list of words in a sentence
    gsub(/,/, " and ", text)
    return text
}
function words_of(i) { return word[i] (most[i] > 1 ? "1.." most[i] : "") }
END {
    if (failed) exit 1
    if (list == "--names" || list == "--help") {
        if (list == "--help")
            print "all, all-NAME (all but one), none, or words joined by +, with a count:"
        for (i = 1; i <= words; i++) {
            if (list == "--help") printf "  %-16s %s%s\n", words_of(i), about[i],
                                         needs[i] ? "; needs " spoken(needs[i]) : ""
            else if (which == "all" ? all[i] : which == "counted" ? most[i] > 1 : 1) print word[i]
        }
        exit
    }
    if (list == "--table") {
        for (i = 1; i <= words; i++)
            printf "%s\t%s\t%s\t%d\t%d\t%s\t%s\t%s\n", word[i], core[i],
                   bit[i] < 0 ? "" : bit[i], most[i], all[i], needs[i], excludes[i], about[i]
        exit
    }
    but = rest = list
    if (sub(/^all-/, "", but)) rest = "all"; else but = ""
    whole = sub(/^all(\+|$)/, "", rest)
    n = rest == "none" ? 0 : split(rest, part, "+")
    bad = but && !(but in number) ? but : !rest && !whole ? "(nothing)" : ""
    for (k = 1; k <= n && !bad; k++) {
        name = part[k]
        count = 1
        if (match(name, /[0-9]+$/)) {
            count = substr(name, RSTART) + 0
            name = substr(name, 1, RSTART - 1)
        }
        i = number[name]
        if (!i || count < 1 || count > most[i] || (most[i] > 1 && name == part[k]))
            bad = part[k] != "" ? part[k] : "(nothing)"
        else wanted[i] = count
    }
    if (bad) {
        name = bad
        sub(/[0-9]+$/, "", name)
        meant = nearest(name, word, words)
        text = bad " names nothing that a core can be built with" \
               (meant != "" ? "; is " meant " meant?" : ".") \
               " There are all, all-NAME, none, and names joined by + of"
        for (i = 1; i <= words; i++) text = text " " words_of(i)
        print text > "/dev/stderr"
        exit 1
    }
    if (whole) {
        for (i = 1; i <= words; i++) value[i] = word[i] == but ? 0 : all[i]
        for (i = effects + 1; i <= words; i++) if (i in wanted) leave_out(excludes[i])
        do {
            gone = 0
            for (i = 1; i <= words; i++) if (value[i] && lacks(i)) gone = !(value[i] = 0)
        } while (gone)
    }
    for (i in wanted) value[i] = wanted[i]
    for (i = 1; i <= words; i++) {
        if (value[i] && lacks(i)) fail(": " word[i] " needs " spoken(needs[i]))
        k = i > effects && value[i] ? split(excludes[i], part, ",") : 0
        for (; k; k--)
            if (value[number[part[k]]]) fail(": " word[i] " does not go with " part[k])
    }
    for (i = 1; i <= words; i++) printf "%s%s=%d", (i > 1 ? " " : ""), core[i], value[i]
    print ""
}
END
