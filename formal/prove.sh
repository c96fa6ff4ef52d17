#!/bin/sh
# prove.sh - proves the properties of proofs.txt with yosys-smtbmc, z3 and programs; prints a table
# SPDX-License-Identifier: Apache-2.0
#
#   prove.sh [PATTERN]   only proofs whose name has the pattern in it; =NAME: that one; quick: the
#                        quick ones
#   BUILD=folder         for what is written (build)
#   CBMC=program         CBMC (that of the path, else of BUILD/cbmc)
#   NICE=command         before everything that takes long (nice)
# Exit 0: all proved. 1: some fail. 2: some cannot be built, or have no verdict.
set -u
cd "$(dirname "$0")/.." || exit 2
pattern=${1:-} BUILD=${BUILD:-build} NICE=${NICE:-nice} CC=${CC:-gcc}
dir=$BUILD/formal
include=$(find rtl -name '*.v*' -exec dirname {} + | sort -u | sed 's/^/-I/' | tr '\n' ' ')
cbmc=${CBMC:-$(command -v cbmc || command -v "$BUILD/cbmc/usr/bin/cbmc")} absent=
mkdir -p "$dir" || exit 2
: >"$dir/table"
worst=0

# Each of these sets $verdict on one proof and leaves a log.
# name, top, parameters, files of rtl, memories stood for, depth
induction() { # a base case of as many clocks as the step spans, then the step
    out=$dir/$1
    sources= models=formal/$2.v sets=
    for f in $4; do sources="$sources rtl/$f"; done
    for f in $5; do models="$models formal/f_$f.v"; done
    for p in $3; do sets="$sets -set ${p%%=*} ${p#*=}"; done
    set -- "$1" "$2" "$3" "$4" "$5" "${6#any}"
    # clocks that are inputs: a step is the time between two edges of any
    [ "$depth" = "$6" ] && clocks=async2sync || clocks=clk2fflogic
    # RTL without its own assertions: they are about its users, but for those of a user's proof
    $NICE yosys -q -p "read_verilog $include $sources;
        read_verilog -formal $include $models; ${sets:+chparam $sets $2;}
        hierarchy -check -top $2; prep -flatten -nordff;
        $clocks; opt_clean; dffunmap; opt_clean; check -assert;
        write_smt2 -wires $out.smt2" >"$out.log" 2>&1 || { verdict=error; return; }
    verdict=proved
    # in bit vectors only, unrolled, z3 works with a SAT solver: hundreds of times as fast
    smt="-s z3 --noprogress"
    grep -q Array "$out.smt2" || smt="$smt --unroll --logic QF_BV"
    case $6 in
    from*) # from any state, in which the properties say nothing before that clock
        clock=${6#from}
        $NICE yosys-smtbmc $smt --presat -t "$clock:$((clock + 1))" "$out.smt2" >>"$out.log" 2>&1 ||
            verdict="fails in clock $clock"
        [ "$verdict" = proved ] || grep -q 'Status: FAILED' "$out.log" || verdict=error
        return ;;
    esac
    if ! $NICE yosys-smtbmc $smt --presat -t $(($6 + 1)) "$out.smt2" >>"$out.log" 2>&1; then
        verdict="fails within $(($6 + 1)) clocks"
    elif ! $NICE yosys-smtbmc $smt -i -t "$6" "$out.smt2" >>"$out.log" 2>&1; then
        verdict="step fails"
    fi
    # no verdict of the solver: it was stopped, or the assumptions contradict each other
    [ "$verdict" = proved ] || grep -q 'Status: FAILED' "$out.log" || verdict=error
}
alike() { # from any state; a product is any function of its factors, the same one everywhere
    out=$dir/$1 clock=${6#alike}
    sources= sets= models=formal/$2.v
    for f in $4; do sources="$sources rtl/$f"; done
    for f in $5; do models="$models formal/f_$f.v"; done
    for p in $3; do sets="$sets -set ${p%%=*} ${p#*=}"; done
    # no wreduce: products of the same factors have the same width
    $NICE yosys -q -p "read_verilog $include $sources; read_verilog -formal $include $models;
        ${sets:+chparam $sets $2;} hierarchy -check -top $2; proc; flatten; opt_expr; opt_clean;
        async2sync; opt_clean; dffunmap; opt_clean; check -assert;
        write_smt2 -wires $out.smt2" >"$out.log" 2>&1 || { verdict=error; return; }
    # what smtbmc would ask a solver, with the answers of a proof; z3 gives its own, at once: first
    # whether there is such a run at all, then whether one breaks the property
    printf 'sat\nunsat\n' >"$out.dummy"
    yosys-smtbmc -s dummy --dummy "$out.dummy" --noprogress --unroll --logic QF_BV --presat \
        -t "$clock:$((clock + 1))" --dump-smt2 "$out.asked" "$out.smt2" >>"$out.log" 2>&1
    # a function for each width of factors and product
    sed -n 's/.*(_ BitVec \([0-9]*\)) .*(bvmul .*/\1/p' "$out.asked" | sort -u |
        sed 's/.*/(declare-fun times_& ((_ BitVec &) (_ BitVec &)) (_ BitVec &))/' >"$out.times"
    sed -e 's/\((_ BitVec \([0-9]*\)) .*\)(bvmul /\1(times_\2 /' \
        -e "s/(set-logic QF_BV)/(set-logic QF_UFBV)/; /^(set-logic/r $out.times" \
        -e '/^(push/s/.*/(echo "asked")/' \
        -e '/^(exit/d; /^(pop/d; /^(set-info :status/d; /^(check-sat)/d' \
        "$out.asked" >"$out.alike"
    ! grep -q bvmul "$out.alike" || { verdict=error; return; }
    { sed '/^(echo/,$d' "$out.alike" && echo '(check-sat)'; } >"$out.run"
    { grep -v '^(echo' "$out.alike" && echo '(check-sat)'; } >"$out.breaks"
    verdict=error
    answers=$($NICE z3 "$out.run" 2>&1)/$($NICE z3 "$out.breaks" 2>&1)
    echo "$answers" >>"$out.log"
    case $answers in
    sat/unsat) verdict=proved ;;
    sat/sat) verdict="fails in clock $clock" ;;
    esac
}
reach() { # abc's pdr looks for the invariant itself; memories become flip-flops
    out=$dir/$1
    sources= sets=
    for f in $4; do sources="$sources rtl/$f"; done
    for f in $5; do sources="$sources rtl/memory/rt_$f.v"; done
    for p in $3; do sets="$sets -set ${p%%=*} ${p#*=}"; done
    $NICE yosys -q -p "read_verilog -Irtl/core $sources formal/$2.v; ${sets:+chparam $sets $2;}
        hierarchy -check -top $2; proc; flatten; opt; memory; opt -full; techmap; opt; dffunmap;
        setundef -undriven -anyseq; abc -g AND -fast; opt_clean; write_aiger -zinit $out.aig" \
        >"$out.log" 2>&1 || { verdict=error; return; }
    $NICE yosys-abc -c "read_aiger $out.aig; scorr; dc2; pdr -T 1000" >>"$out.log" 2>&1
    verdict=error
    ! grep -q '^Property proved' "$out.log" || verdict=proved
    ! grep -q 'was asserted in frame' "$out.log" || verdict="an answer is wrong"
}
lemma() { # every check-sat says what `:status` before it says
    if $NICE z3 "formal/$2" >"$dir/$1.log" 2>&1; then
        verdict=proved
        grep -qE '^(unsat|sat)$' "$dir/$1.log" || verdict=error
        ! grep -q unknown "$dir/$1.log" || verdict=error
    else
        verdict=error
        ! grep -q 'check annotation' "$dir/$1.log" || verdict="a lemma fails"
    fi
}
program() { # with the model's own functions; exit 0: all inputs hold, 1: one does not
    sources= sets=
    for f in trace/filter trace/setup prim/sphere math/arith core/stages; do
        sources="$sources cmodel/$f.c"
    done
    for p in $3; do sets="$sets -D$p"; done
    # shellcheck disable=SC2086  # lists of words
    $CC -std=c11 -O2 -Wall -Wextra -Wconversion -Wshadow -Werror -ffunction-sections \
        -fdata-sections -Wl,--gc-sections -Icmodel $sets -o "$dir/$1" "formal/$2" $sources \
        >"$dir/$1.log" 2>&1 || { verdict=error; return; }
    $NICE "$dir/$1" >>"$dir/$1.log" 2>&1
    case $? in 0) verdict=proved ;; 1) verdict="an input fails" ;; *) verdict=error ;; esac
}
exact() { # clang takes out all traps of a function that says when an operation leaves its type
    sets= function=
    for p in $3; do
        case $p in FUNCTION=*) function=${p#*=} ;; *) sets="$sets -D$p" ;; esac
    done
    # shellcheck disable=SC2086  # lists of words
    $NICE clang -std=c11 -O3 -Wno-missing-prototypes -Wno-bit-int-extension -Icmodel $sets \
        -fsanitize=undefined,implicit-conversion -fsanitize-trap=all \
        -fno-sanitize=alignment,null,object-size,pointer-overflow -fno-vectorize \
        -fno-slp-vectorize -mllvm -inline-threshold=1000000 -mllvm -unroll-threshold=100000 \
        -S -emit-llvm -o "$dir/$1.ll" "formal/$2" >"$dir/$1.log" 2>&1 || { verdict=error; return; }
    sed -n "/^define .*@$function(/,/^}/p" "$dir/$1.ll" >>"$dir/$1.log"
    verdict=error
    # all of it stands there, so that a trap of what it calls counts
    grep -q '^define' "$dir/$1.log" || return
    ! grep 'call [^@]*@' "$dir/$1.log" | grep -qv '@llvm\.' || return
    verdict=proved
    ! grep -q 'call .*@llvm\.ubsantrap' "$dir/$1.log" || verdict="a trap is left"
}
bounded() { # CBMC: no check of a function fails, no loop goes on, and its end is reached
    sets= function=
    for p in $3; do
        case $p in FUNCTION=*) function=${p#*=} ;; *) sets="$sets -D$p" ;; esac
    done
    # shellcheck disable=SC2086  # lists of words
    set -- "$1" --function "$function" -Icmodel $sets --unwind 52 "formal/$2"
    name=$1
    shift
    $NICE "$cbmc" "$@" -DREACH >"$dir/$name.log" 2>&1
    verdict=error
    grep -q '^VERIFICATION FAILED' "$dir/$name.log" || return
    $NICE "$cbmc" "$@" --unwinding-assertions --bounds-check --pointer-check \
        --div-by-zero-check --signed-overflow-check --undefined-shift-check --conversion-check \
        >"$dir/$name.log" 2>&1
    ! grep -q '^VERIFICATION SUCCESSFUL' "$dir/$name.log" || verdict=proved
    ! grep -q '^VERIFICATION FAILED' "$dir/$name.log" || verdict="a check fails"
}
simulation() { # all inputs of a module without state; says "proved" or what fails
    sources= sets=
    for f in $4; do sources="$sources rtl/$f"; done
    for p in $3; do sets="$sets -P$2.$p"; done
    # shellcheck disable=SC2086  # lists of words
    iverilog -g2005 -Wall $include $sets -s "$2" -o "$dir/$1.vvp" "formal/$2.v" $sources \
        >"$dir/$1.log" 2>&1 || { verdict=error; return; }
    $NICE vvp -n "$dir/$1.vvp" >>"$dir/$1.log" 2>&1
    verdict=error
    ! grep -qx proved "$dir/$1.log" || verdict=proved
    ! grep -q '^fails' "$dir/$1.log" || verdict="an input fails"
}

# shellcheck disable=SC2162  # a line may go on behind a backslash
while IFS='|' read name top params rtl memories depth speed; do
    case $name in
    '#'* | '') continue ;;
    '= '*) property=${name#= } && continue ;;
    esac
    name=${name%% *} speed=${speed# } speed=${speed%% *} top=${top# } top=${top%% *}
    case $pattern in
    quick) [ "$speed" = quick ] || continue ;;
    =*) [ "=$name" = "$pattern" ] || continue ;;
    *) case $name in *"$pattern"*) ;; *) continue ;; esac ;;
    esac
    # shellcheck disable=SC2086,SC2116  # blanks go
    depth=$(echo $depth) params=$(echo $params) rtl=$(echo $rtl) memories=$(echo $memories)
    [ "$params" != - ] || params=
    [ "$rtl" != - ] || rtl=
    [ "$memories" != - ] || memories=
    case $top in
    *.smt2) how=lemma method=z3 module=${top%.smt2} ;;
    c_*.c) how=exact method=clang module=${top%.c} ;;
    b_*.c)
        how=bounded method=cbmc module=${top%.c}
        [ -n "$cbmc" ] || { absent=1 && continue; }
        ;;
    *.c) how=program method=all module=${top%.c} ;;
    p_*) how=reach method=pdr module=${rtl%%.v*} module=${module##*/} ;;
    s_*) how=simulation method=all module=${rtl%%.v*} module=${module##*/} ;;
    *) how=induction method=k=${depth#any}
        case $depth in
        from*) method=t=${depth#from} ;;
        alike*) how=alike method=p=${depth#alike} ;;
        esac
        module=${rtl%%.v*} module=${module##*/} ;;
    esac
    start=$(date +%s%N)
    $how "$name" "$top" "$params" "$rtl" "$memories" "$depth"
    tenths=$((($(date +%s%N) - start) / 100000000))
    case $verdict in
    proved) ;;
    error) worst=2 ;;
    *) [ $worst -eq 2 ] || worst=1 ;;
    esac
    echo "  PROVE $name: $verdict"
    [ "$verdict" = proved ] ||
        grep -E 'ERROR|error|Assert failed|fails' "$dir/$name.log" | head -n 3
    printf '%s|%s|%s|%s|%d.%d|%s|%s\n' "$name" "$module" "$params" "$method" \
        $((tenths / 10)) $((tenths % 10)) "$verdict" "$property" >>"$dir/table"
done <formal/proofs.txt

[ -z "$absent" ] || echo "CBMC is not installed (make cbmc-setup): its proofs are left out"
[ -s "$dir/table" ] || { echo "no proof of that name: $pattern"; exit 2; }
awk -F'|' 'BEGIN {
        form = "%-16s %-14s %-26s %-7s %7s  %-8s %s\n"
        printf form, "proof", "module", "parameters", "method", "seconds", "", "property" }
    { printf form, $1, $2, $3, $4, $5, $6, $7; sum += $5; proved += $6 == "proved" }
    END { printf "%d of %d proved in %.1f s (k: depth of the induction, t: clocks from " \
          "any state, p: so, products being a function, pdr: of abc, z3: integers, " \
          "all: every input, clang: no trap left, cbmc: no check fails)\n", proved, NR, sum }' \
    "$dir/table"
exit $worst
