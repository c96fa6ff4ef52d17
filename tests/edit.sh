#!/bin/sh
# edit.sh - one edit in a file, for tests that put faults into copies of the sources; sourced
# SPDX-License-Identifier: Apache-2.0
#
# Replaces the text FROM, which must stand exactly once in a file, by TO. A space in FROM stands for
# one or more blanks.
edit() {
    awk '
        { text = text $0 "\n" }
        END {
            from = ENVIRON["FROM"]
            gsub(/[][\\.^$*+?(){}|\/]/, "\\\\&", from)
            gsub(/ +/, "[ \n]+", from)
            for (rest = text; match(rest, from); rest = substr(rest, RSTART + 1)) n++
            if (n != 1) {
                printf "stands %d times in the file, not once: %s\n", n, ENVIRON["FROM"]
                exit 1
            }
            match(text, from)
            printf "%s%s%s", substr(text, 1, RSTART - 1), ENVIRON["TO"],
                substr(text, RSTART + RLENGTH) >ENVIRON["NEW"]
        }' "$1" && mv "$NEW" "$1"
}
