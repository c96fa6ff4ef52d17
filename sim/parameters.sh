#!/bin/sh
# parameters.sh - what a core is elaborated with, from the names of what it can do
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/parameters.sh LIST
#   LIST  all, all-NAME (all but one), none, or names joined by +, the first of which may be all:
#         shadow reflectN lightsN inside first interpenetrate facets texture coarseN refract
#         specular sum rect spans conesN bih
#         (N: reflections 1..5, lights 1..8, spheres of exact background separation 1..16, bits
#         that levels of textures have less 1..8, which needs texture;
#         interpenetrate needs first and inside, so all-first and all-inside leave it out too;
#         refract needs inside, specular needs sum;
#         all has no texture, with which a core has 4/10 more cells, and no refract, specular and
#         sum: all+texture+refract+specular+sum has them; with bih
#         the core walks a BIH, which knows neither first nor interpenetrate: all+bih has neither)
# Prints the parameters of rtl/core/rt_core.v, NAME=VALUE, all on one line.
set -eu
awk -v list="$1" 'BEGIN {
    n = split("shadow reflect lights inside first interpenetrate facets texture coarse " \
              "refract specular sum rect spans cones bih", name, " ")
    split("1 5 8 1 1 1 1 1 8 1 1 1 1 1 16 1", most, " ")
    split("1 5 8 1 1 1 1 0 0 0 0 0 1 1 1 0", full, " ")
    but = list
    if (sub(/^all-/, "", but)) list = "all"; else but = ""
    all = sub(/^all(\+|$)/, "", list)
    for (i = 1; i <= n; i++) {
        number[name[i]] = i
        value[i] = all && name[i] != but ? full[i] : 0
    }
    if (but == "first") value[number["interpenetrate"]] = 0
    if (but == "inside") value[number["interpenetrate"]] = 0
    bad = but && !(but in number) ? but : ""
    bih = list ~ /(^|\+)bih(\+|$)/
    if (bih && all) value[number["first"]] = value[number["interpenetrate"]] = 0
    words = list == "none" ? 0 : split(list, word, "+")
    for (w = 1; w <= words && !bad; w++) {
        key = word[w]
        count = 1
        if (match(key, /[0-9]+$/)) {
            count = substr(key, RSTART) + 0
            key = substr(key, 1, RSTART - 1)
        }
        i = number[key]
        if (!i || count < 1 || count > most[i] || (most[i] > 1 && key == word[w]))
            bad = word[w] != "" ? word[w] : "(nothing)"
        else value[i] = count
    }
    if (!bad && !list && !all) bad = "(nothing)"
    if (!bad && value[number["refract"]] && !value[number["inside"]]) {
        print list ": refract needs inside" > "/dev/stderr"
        exit 1
    }
    if (!bad && value[number["coarse"]] && !value[number["texture"]]) {
        print list ": coarse needs texture" > "/dev/stderr"
        exit 1
    }
    if (!bad && value[number["specular"]] && !value[number["sum"]]) {
        print list ": specular needs sum" > "/dev/stderr"
        exit 1
    }
    if (!bad && bih && value[number["first"]]) {
        print list ": bih does not go with first" > "/dev/stderr"
        exit 1
    }
    if (!bad && value[number["interpenetrate"]] &&
        !(value[number["first"]] && value[number["inside"]])) {
        print list ": interpenetrate needs first and inside" > "/dev/stderr"
        exit 1
    }
    if (bad) {
        printf "%s names nothing that a core can be built with: all, all-NAME, none, or names " \
               "joined by + of", bad > "/dev/stderr"
        for (i = 1; i <= n; i++)
            printf " %s%s", name[i], (most[i] > 1 ? "1.." most[i] : "") > "/dev/stderr"
        print "" > "/dev/stderr"
        exit 1
    }
    for (i = 1; i <= n; i++)
        printf "%s%s=%d", (i > 1 ? " " : ""), (name[i] == "bih" ? "ACCEL" : toupper(name[i])),
               value[i]
    print ""
}'
