# beside.sh - files of scripts that are whole or not there; sourced
# SPDX-License-Identifier: Apache-2.0
#
# beside FILE      makes a folder beside FILE that nobody else has, and sets $new to a name in it,
#                  which is no file yet; it is removed when the shell ends, a subshell too
# named FILE       gives what is made as $new the name FILE, whatever stands there
# named_anew FILE  the same, unless it is what stands there: a file keeps its time
# Two calls, processes or containers do not meet, and no link that somebody put there is followed.
beside() {
    beside_folder=$(mktemp -d "$(dirname -- "$1")/.whole.XXXXXXXXXX") || exit 1
    new=$beside_folder/new
    trap 'rm -rf "$beside_folder"' EXIT
    trap 'exit 130' HUP INT TERM
}
named() {
    mv -fT -- "$new" "$1" || exit 1
    rm -rf "$beside_folder"
}
named_anew() {
    if cmp -s -- "$new" "$1"; then rm -rf "$beside_folder"; else named "$1"; fi
}
