#!/bin/sh
# sizes.sh - other sizes of the core, which only cells and cycles depend on, from their names
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/sizes.sh LIST [name]
#   LIST  size=value,... (a `size` of machine.def in small letters), or as a part of a file name,
#         size1-size2; may be empty. ENGINES and what else has a variable of its own is refused.
# Prints parameters of rtl/core/rt_core.v, NAME=VALUE, all on one line; with `name` the part of a
# file name. rt_core checks what goes together, this script each by itself.
set -eu
here=$(dirname "$0")
awk -v text="$1" -v want="${2:-}" "$(cat "$here/nearest.awk")"'
function fail(why) {
    print "sizes " text ": " why > "/dev/stderr"
    failed = 1
    exit 1
}
FILENAME ~ /variables.mk$/ { if ($1 == "##") own[tolower($2)] = $2; next }
$1 == "size" && !(tolower($2) in own) {
    known[++sizes] = tolower($2)
    least[known[sizes]] = $4
    most[known[sizes]] = $5
    power[known[sizes]] = $6 == "power"
}
END {
    if (failed) exit 1
    n = split(text, part, /[,-]/)
    for (i = 1; i <= n; i++) {
        if (part[i] !~ /^[a-z_]+=?[0-9]+$/) fail("\"" part[i] "\" is no size=value")
        name = value = part[i]
        sub(/=?[0-9]+$/, "", name)
        sub(/^[a-z_]+=?/, "", value)
        value += 0
        if (name in own) fail(name " has the variable " own[name])
        if (!(name in least)) {
            meant = nearest(name, known, sizes)
            for (k = 1; k <= sizes; k++) list = list " " known[k]
            fail("there is no \"" name "\"" (meant != "" ? "; is " meant " meant?" : "") \
                 " There are" list)
        }
        if (name in seen) fail(name " is given twice")
        seen[name] = 1
        if (value < least[name] || (most[name] ~ /^[0-9]+$/ && value > most[name] + 0))
            fail(name " is " value ", not in " least[name] ".." most[name])
        for (two = 1; two < value; two *= 2);
        if (power[name] && value && two != value)
            fail(name " is " value ", no power of two")
        line = line (i > 1 ? (want == "name" ? "-" : " ") : "") \
               (want == "name" ? name value : toupper(name) "=" value)
    }
    print line
}' "$here/../make/variables.mk" "$here/../cmodel/machine/machine.def"
