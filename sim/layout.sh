#!/bin/sh
# layout.sh - what follows from machine.def: two layout headers, and lines between marks
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/layout.sh [FOLDER]
# Writes layout.h and rt_layout.vh, and in rt_core.v and tb_core_icarus.v the lines between
# `// KIND of machine.def` and `// end of KIND`; to FOLDER if it is given, else in their places. A
# file that stays the same keeps its time.
set -eu
cd "$(dirname "$0")/.."
def=cmodel/machine
generate() { awk -v lang="$1" -f $def/effects.awk -f $def/gen_layout.awk $def/machine.def; }
put() { # file: takes stdin
    to=${to_folder:+$to_folder/${1##*/}}
    to=${to:-$1}
    cat >"$to.tmp"
    if cmp -s "$to.tmp" "$to"; then rm "$to.tmp"; else mv "$to.tmp" "$to"; fi
}
splice() { # file: its text with fresh lines between marks
    awk -v parameters="$(generate parameters)" -v connections="$(generate connections)" '
        /^ *\/\/ end of (parameters|connections)$/ { inside = 0 }
        !inside
        /^ *\/\/ parameters of machine.def$/ { print parameters; inside = 1 }
        /^ *\/\/ connections of machine.def$/ { print connections; inside = 1 }
        END { exit inside }' "$1" || {
        echo "$1: a mark without an end" >&2
        exit 1
    }
}
to_folder=${1:-}
text=$(generate c)
printf '%s\n' "$text" | put $def/layout.h
text=$(generate v)
printf '%s\n' "$text" | put rtl/core/rt_layout.vh
for file in rtl/core/rt_core.v tb/core/tb_core_icarus.v; do
    text=$(splice $file)
    printf '%s\n' "$text" | put $file
done
