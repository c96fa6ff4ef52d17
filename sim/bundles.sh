#!/bin/sh
# bundles.sh - what follows from the definition of the engine's bundles: two headers, lines at ports
# SPDX-License-Identifier: Apache-2.0
#
# usage: sim/bundles.sh [FOLDER | --check]
# Writes rt_bundles.vh for modules, bundles.h for benches, and in the modules the fields of each
# bundle below the port that has it; to FOLDER if it is given, else in their places. A file that
# stays the same keeps its time. --check looks at the ports alone: exit code 1 if one is not so.
set -eu
cd "$(dirname "$0")/.."
. sim/beside.sh
defs='cmodel/machine/machine.def rtl/engine/bundles.def'
modules=$(grep -lE '^    (input|output) .*`RT_[A-Z_]+_BITS' rtl/*/*.v)
to_folder=${1:-}
put() { # file, command that prints it
    to=${to_folder:+$to_folder/${1##*/}}
    to=${to:-$1}
    shift
    beside "$to"
    "$@" >"$new"
    named_anew "$to"
}
if [ "$to_folder" = --check ]; then
    # shellcheck disable=SC2086  # lists of words
    wrong=$(awk -v check=1 -f sim/port_fields.awk $defs $modules)
    [ -z "$wrong" ] || { printf '%s\n' "$wrong" && exit 1; }
    exit
fi
# shellcheck disable=SC2086  # a list of words
put rtl/engine/rt_bundles.vh awk -v lang=v -f sim/bundles.awk $defs
# shellcheck disable=SC2086  # a list of words
put tb/bundles.h awk -v lang=c -f sim/bundles.awk $defs
for file in $modules; do
    # shellcheck disable=SC2086  # a list of words
    put "$file" awk -f sim/port_fields.awk $defs "$file"
done
