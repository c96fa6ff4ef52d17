#!/bin/sh
# core.sh - synthesises the core once with Yosys and keeps what it says
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/core.sh PROFILE-TARGET-LIST-engines1[-pipesN][-leaf_unitsN][-shadesN][-rootN]
#            [-quotientN][-SIZEn...] [-top] [-flat] FOLDER
#   PROFILE, SIZE: sim/cores.py, as parts of a file name; LIST: the same
#   top: rt_top with its video output around the core, not rt_core alone
# Leaves in FOLDER:
#   parameters  what the core was elaborated with, and the seconds that it took
#   rtl.json    stat before mapping: bits of memory as they are declared
#   stat.json   stat after mapping, for each module its own cells
#   multiply    operand widths of the multipliers that are left (generic)
#   depth       longest path between registers, block RAMs and multipliers, cells
#   sources.d   the files that were read, for make
#   log         everything else
set -eu
cd "$(dirname "$0")/.."
key=$1 out=$2
rest=${key#*-}
profile=${key%%-*} target=${rest%%-*}
variant=${rest#*-}
flat= top=rt_core shell=
case $variant in *-flat) flat=1 variant=${variant%-flat} ;; esac
case $variant in *-top) top=rt_top shell=' VIDEO=1' variant=${variant%-top} ;; esac

# Widths and pace from the one definition; the others are in the key, behind the list.
sizes=$(awk '$1 == "size" { print tolower($2) }' cmodel/machine/machine.def)
own=
while :; do
    last=${variant##*-}
    name=${last%%[0-9]*}
    number=${last#"$name"}
    case $name in root | quotient) name=${name}_step ;; esac
    echo "$sizes" | grep -qx "$name" || break
    own="$(echo "$name" | tr a-z A-Z)=$number $own"
    variant=${variant%-*}
done
parameters=
for size in $(sim/cores.py profile "$profile"); do
    case " $own" in *" ${size%=*}="*) ;; *) parameters="$parameters$size " ;; esac
done
parameters="$parameters$(sim/cores.py parameters "$variant") ${own% }$shell"
# shellcheck disable=SC2086  # words
sim/cores.py legal $parameters
set_all=$(echo "$parameters" | sed 's/\([A-Z_]*\)=\([0-9]*\)/-set \1 \2/g')

folders=$(find rtl -name '*.v*' -exec dirname {} + | sort -u)
include='' library=''
for d in $folders; do include="$include -I$d" library="$library -libdir $d"; done

# Storage and multipliers end a path; what is left is counted cell by cell.
depth="flatten; opt_clean; delete t:*FF* t:FD* t:LD* t:*RAM* t:DP16KD t:PDPW16KD t:*DPR16X4 \
    t:*MULT* t:DSP48E1 t:SB_MAC16 t:SDP* t:PDP* t:SRL* t:\$mem_v2 t:\$mul t:\$_*DFF* \
    t:\$scopeinfo; tee -q -o $out/depth ltp"
. synth/target.sh
[ "$target" != generic ] || map="$map; tee -q -o $out/multiply dump -m t:\$mul"

mkdir -p "$out"
. sim/beside.sh
beside "$out/stat.json"
printf '  %-4s %s\n' SYN "$key"
start=$(date +%s)
# shellcheck disable=SC2086  # lists of words on purpose
nice "${YOSYS:-yosys}" -q -l "$out/log" -E "$out/sources" -p "
    verilog_defaults -add $include -DSYNTHESIS $defines;
    read_verilog rtl/*/$top.v; chparam $set_all $top; hierarchy -check -top $top $library;
    proc; check -assert; tee -q -o $out/rtl.json stat -json;
    $map; check -assert; tee -q -o $new stat -json;
    write_rtlil $out/netlist.il; $depth" >"$out/errors" 2>&1 || {
    cat "$out/errors" >&2
    exit 1
}
seconds=$(($(date +%s) - start))
echo "$parameters SECONDS=$seconds" >"$out/parameters"
headers=$(find rtl -name '*.vh')
sources=$(sed 's/^[^:]*://; s,//,/,g' "$out/sources" | tr ' ' '\n' | grep '^rtl/.*\.v$' | sort -u)
# shellcheck disable=SC2086,SC2016  # one line each; make knows its build folder by other names too
{
    echo '$(S)'"/$key/stat.json:" $sources $headers
    echo $sources $headers:
} >"$out/sources.d"
named "$out/stat.json"
printf '  %-4s %s, %s s\n' done "$key" "$seconds"
