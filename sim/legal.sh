#!/bin/sh
# legal.sh - whether parameters of a core go together
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/legal.sh NAME=NUMBER...
# Parameters of rtl/core/rt_core.v; what is not given has its default, of the profile standard.
# Rules are those of machine.def, `unit` and `legal`. What does not hold is said on stderr, with
# the values that it is about; exit code 1 then.
set -eu
here=$(dirname "$0")/../cmodel/machine
given() { # taken as they are: names and numbers, from here on
    for word; do
        case $word in
        *[!A-Z_0-9=]* | [!A-Z]* | *=*[!0-9]* | *=)
            echo "legal.sh: $word is no NAME=NUMBER" >&2
            exit 2
            ;;
        esac
        eval "$word"
    done
}
wrong() { # rule, parameters
    said=$(echo "$1" | sed 's/_\([a-z0-9]\)/ \1/g; s/\([a-z0-9]\)_/\1 /g') about=
    shift
    for name; do
        case " $about" in *" $name="*) ;; *) about="$about $name=$(eval "echo \$$name")" ;; esac
    done
    echo "${about# }: $said" >&2
    bad=1
}
program=$(awk -f "$here/effects.awk" -f - "$here/machine.def" <<'END'
function named(text, list) { # parameters that an expression names; the first of a unit is its own
    for (; match(text, /[A-Z][A-Z_]*/); text = substr(text, RSTART + RLENGTH))
        list = list " " (substr(text, RSTART, RLENGTH) in own ? own[substr(text, RSTART, RLENGTH)] \
                                                              : substr(text, RSTART, RLENGTH))
    return list
}
$1 == "profile" && $2 == "standard" {
    printf "W=%d WD=%d PQ=%d NG=%d FW=%d PR=%d\n", $3, $4, $5, $6, $7, $8
}
END {
    if (failed) exit 1
    for (i = 1; i <= words; i++) print core[i] "=" all[i]
    for (i = 1; i <= sizes; i++) print size[i] "=" standard[i]
    print "given \"$@\""
    for (i = 1; i <= units; i++) {
        match(how_many[i], /[A-Z_]+/)
        own[unit[i]] = substr(how_many[i], 1, RLENGTH)
        print unit[i] "=$((" how_many[i] "))"
    }
    for (i = 1; i <= rules; i++)
        print "[ $((" must_hold[i] ")) = 1 ] || wrong " rule_name[i] named(must_hold[i])
}
END
)
eval "$program"
exit "${bad:-0}"
