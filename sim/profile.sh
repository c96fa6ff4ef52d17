#!/bin/sh
# profile.sh - the widths and the pace of a profile, from its name and what replaces widths
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/profile.sh PROFILE [name]
#   PROFILE  a name of machine.def, alone or with widths of its own: NAME:key=value,... (keys w, wd,
#            pr, pq, ng, fw), or the same as a part of a file name, NAME_keyVALUE_...
# Prints parameters of rtl/core/rt_core.v, NAME=VALUE, all on one line; with `name` the part of a
# file name. The tool and rt_core check what widths go together, this script each by itself.
set -eu
here=$(dirname "$0")
awk -v text="$1" -v want="${2:-}" "$(cat "$here/nearest.awk")"'
function fail(why) {
    print "profile " text ": " why > "/dev/stderr"
    failed = 1
    exit 1
}
BEGIN {
    n = split(text, part, /[:,_]/)
    plain = text
    gsub(/[:,]/, "_", plain)
    gsub(/=/, "", plain)
}
$1 == "profile" {
    names = names " " $2
    list[++profiles] = $2
}
$1 == "profile" && $2 == part[1] {
    found = 1
    split("w wd pq ng fw pr", key, " ")
    for (i = 1; i <= 6; i++) value[key[i]] = $(i + 2)
    own_w = $3
    own_wd = $4
}
$1 == "pace" && $2 == part[1] { for (i = 3; i <= NF; i++) pace = pace " " $i }
$1 == "width" { least[$2] = $5; most[$2] = $6 }
END {
    if (failed) exit 1
    if (!found) {
        meant = nearest(part[1], list, profiles)
        fail((meant != "" ? "is " meant " meant? " : "") "There are" names \
             ", and each with widths of its own, NAME:key=value,...")
    }
    for (i = 2; i <= n; i++) {
        if (!match(part[i], /[0-9]+$/)) fail("\"" part[i] "\" is no key=value")
        number = substr(part[i], RSTART) + 0
        name = substr(part[i], 1, RSTART - 1)
        sub(/=$/, "", name)
        if (!(name in value)) fail("\"" name "\" is none of w, wd, pr, pq, ng and fw")
        if (name in seen) fail(name " is given twice")
        seen[name] = 1
        if (number < least[name] || number > most[name] + (name == "pr"))
            fail(name " is " number ", not in " least[name] ".." most[name])
        value[name] = number
    }
    if (value["pr"] == value["w"] + value["wd"]) value["pr"] = 0
    if (want == "name") print plain
    else {
        for (i = 1; i <= 6; i++)
            printf "%s%s=%d", (i > 1 ? " " : ""), toupper(key[i]), value[key[i]]
        print (value["w"] == own_w && value["wd"] == own_wd ? pace : "")
    }
}' "$here/../cmodel/machine/machine.def"
