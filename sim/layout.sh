#!/bin/sh
# layout.sh - what follows from machine.def, top.def and modes.def: headers
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/layout.sh [FOLDER]
# Writes layout.h and rt_layout.vh, parameters of the core (rt_effects.vh, rt_core_parameters.vh),
# how they are passed on (..._pass.vh) and its rules (rt_core_rules.vh), of rt_top rt_top.vh,
# sphaera_regs.h and rt_top.rdl, of modes of video rt_modes.vh and sphaera_modes.h; to FOLDER if it
# is given, else in their places. A file that stays the same keeps its time.
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
to_folder=${1:-}
text=$(generate c)
printf '%s\n' "$text" | put $def/layout.h
for name in layout effects effects_pass core_parameters core_pass core_rules; do
    text=$(generate $name)
    printf '%s\n' "$text" | put rtl/core/rt_$name.vh
done
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
