#!/bin/sh
# prove.sh - proves the properties of proofs.txt with yosys-smtbmc and z3; prints a table
# SPDX-License-Identifier: Apache-2.0
#
#   prove.sh [PATTERN]   only proofs whose name has the pattern in it; quick: the quick ones
#   RTL=folder           of the Verilog files (rtl); BUILD=folder for what is written (build)
#   NICE=command         before every yosys and z3 (nice)
# Exit 0: all proved. 1: some fail. 2: some cannot be built, or have no verdict.
set -u
cd "$(dirname "$0")/.." || exit 2
pattern=${1:-} RTL=${RTL:-rtl} BUILD=${BUILD:-build} NICE=${NICE:-nice}
dir=$BUILD/formal
mkdir -p "$dir" || exit 2
: >"$dir/table"
worst=0

# Verdict on one proof, in $verdict: a base case of as many clocks as the step spans, then the step.
prove() { # name, top, parameters, files of rtl, files of formal, depth
    out=$dir/$1
    sources= models= sets=
    for f in $4; do sources="$sources $RTL/$f"; done
    for f in $5; do models="$models formal/$f"; done
    for p in $3; do sets="$sets -chparam ${p%%=*} ${p#*=}"; done
    # RTL without its own assertions: they are about its users, but for those of a user's proof
    $NICE yosys -q -p "read_verilog -I$RTL/math -I$RTL/trace -I$RTL/shell $sources;
        read_verilog -formal $models; hierarchy -check -top $2 $sets; prep -flatten -nordff;
        async2sync; opt_clean; dffunmap; opt_clean; check -assert;
        write_smt2 -wires $out.smt2" >"$out.log" 2>&1 || { verdict=error; return; }
    verdict=proved
    if ! $NICE yosys-smtbmc -s z3 --presat -t $(($6 + 1)) "$out.smt2" >>"$out.log" 2>&1; then
        verdict="fails within $(($6 + 1)) clocks"
    elif ! $NICE yosys-smtbmc -s z3 -i -t "$6" "$out.smt2" >>"$out.log" 2>&1; then
        verdict="step fails"
    fi
    # no verdict of the solver: it was stopped, or the assumptions contradict each other
    [ "$verdict" = proved ] || grep -q 'Status: FAILED' "$out.log" || verdict=error
}

while IFS='|' read -r name top params rtl formal depth speed; do
    case $name in
    '#'* | '') continue ;;
    '= '*) property=${name#= } && continue ;;
    esac
    name=${name%% *} speed=${speed# } speed=${speed%% *} top=${top# } top=${top%% *}
    case $pattern in
    quick) [ "$speed" = quick ] || continue ;;
    *) case $name in *"$pattern"*) ;; *) continue ;; esac ;;
    esac
    start=$(date +%s%N)
    # shellcheck disable=SC2086,SC2116  # blanks go
    prove "$name" "$top" "$params" "$rtl" "$formal" $(echo $depth)
    tenths=$((($(date +%s%N) - start) / 100000000))
    case $verdict in
    proved) ;;
    error) worst=2 ;;
    *) [ $worst -eq 2 ] || worst=1 ;;
    esac
    echo "  PROVE $name: $verdict"
    [ "$verdict" = proved ] || grep -E 'ERROR|Assert failed' "$dir/$name.log" | head -n 3
    module=${rtl##*/} module=${module%%.v*}
    # shellcheck disable=SC2086,SC2116
    printf '%s|%s|%s|k=%s|%d.%d|%s|%s\n' "$name" "$module" "$(echo $params)" "$(echo $depth)" \
        $((tenths / 10)) $((tenths % 10)) "$verdict" "$property" >>"$dir/table"
done <formal/proofs.txt

[ -s "$dir/table" ] || { echo "no proof of that name: $pattern"; exit 2; }
awk -F'|' 'BEGIN {
        form = "%-16s %-14s %-26s %-7s %7s  %-8s %s\n"
        printf form, "proof", "module", "parameters", "method", "seconds", "", "property" }
    { printf form, $1, $2, $3, $4, $5, $6, $7; sum += $5; proved += $6 == "proved" }
    END { printf "%d of %d proved in %.1f s (k: depth of the induction)\n", proved, NR, sum }' \
    "$dir/table"
exit $worst
