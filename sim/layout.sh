#!/bin/sh
# layout.sh - what follows from machine.def, top.def and modes.def: headers, lines between marks
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/layout.sh [FOLDER]
# Writes layout.h and rt_layout.vh, of rt_top rt_top.vh, sphaera_regs.h and rt_top.rdl, of modes of
# video rt_modes.vh and sphaera_modes.h, and in rt_core.v, rt_top.v and tb_core_icarus.v the lines
# between `// KIND of machine.def` and `// end of KIND`; to FOLDER if it is given, else in their
# places. A file that stays the same keeps its time.
set -eu
cd "$(dirname "$0")/.."
. sim/beside.sh
def=cmodel/machine
generate() { awk -v lang="$1" -f $def/effects.awk -f $def/gen_layout.awk $def/machine.def; }
generate_top() {
    awk -v lang="$1" -f $def/gen_top.awk VERSION $def/machine.def $def/top.def
}
put() { # file: takes stdin
    to=${to_folder:+$to_folder/${1##*/}}
    to=${to:-$1}
    mkdir -p "${to%/*}"
    beside "$to"
    cat >"$new"
    named_anew "$to"
}
splice() { # file: its text with fresh lines between marks
    awk -v parameters="$(generate parameters)" -v connections="$(generate connections)" \
        -v units="$(generate units)" '
        /^ *\/\/ end of (parameters|connections|units)$/ { inside = 0 }
        !inside
        /^ *\/\/ parameters of machine.def$/ { print parameters; inside = 1 }
        /^ *\/\/ connections of machine.def$/ { print connections; inside = 1 }
        /^ *\/\/ units of machine.def$/ { print units; inside = 1 }
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
for job in "v rtl/video/rt_modes.vh" "c driver/sphaera_modes.h"; do
    text=$(awk -v lang="${job%% *}" -f sim/modes.awk rtl/video/modes.def)
    printf '%s\n' "$text" | put "${job#* }"
done
text=$(generate_top v)
printf '%s\n' "$text" | put rtl/top/rt_top.vh
text=$(generate_top c)
printf '%s\n' "$text" | put driver/sphaera_regs.h
text=$(generate_top rdl)
printf '%s\n' "$text" | put docs/reference/rt_top.rdl
for file in rtl/core/rt_core.v rtl/top/rt_top.v tb/core/tb_core_icarus.v; do
    text=$(splice $file)
    printf '%s\n' "$text" | put $file
done
