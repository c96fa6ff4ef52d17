#!/bin/sh
# run_bench.sh - builds and runs block benches: run_bench.sh [pattern [seed [vectors]]]
# SPDX-License-Identifier: Apache-2.0
# pattern selects lines of tb/benches.txt by bench/profile, e.g. tb_leaf or tb_leaf/standard.
# Everything built lies under build/tb.
cd "$(dirname "$0")/.." || exit 1
pattern=${1:-/}
[ $# -gt 0 ] && shift

out=build/tb
mkdir -p $out
make --no-print-directory build/libsphaera.a >$out/model.log || { cat $out/model.log; exit 1; }
include=$(verilator --getenv VERILATOR_ROOT)/include
search=$(find rtl -type d | sed 's/.*/-y & -I&/' | tr '\n' ' ')
for part in verilated verilated_threads; do
    [ -f $out/$part.o ] && continue
    g++ -std=c++17 -O2 -I"$include" -c "$include/$part.cpp" -o $out/$part.o.$$ &&
        mv $out/$part.o.$$ $out/$part.o || exit 1
done

status=0
tests=0
# shellcheck disable=SC2086,SC2013  # lists of words on purpose
while read -r profile top bench params; do
    case "$profile" in '#'* | '') continue ;; esac
    case "$bench/$profile" in *"$pattern"*) ;; *) continue ;; esac
    dir=$out/$bench-$profile
    generics=
    macros="-DPROFILE=\"$profile\""
    for p in ${params%%/*}; do
        generics="$generics -G$p"
    done
    for p in ${params%%/*} ${params#"${params%/*}"}; do
        [ "$p" = / ] && continue
        macros="$macros -D$p"
    done
    mkdir -p $dir
    newest=$(find rtl tb/$bench.cpp tb/bench.h tb/benches.txt build/libsphaera.a -newer $dir/bench \
        2>&1 | head -n 1)
    if [ -n "$newest" ]; then
        rm -f $dir/bench $dir/*.cpp
        verilator --cc --top-module $top --language 1364-2005 -Wall -O3 --x-assign unique \
            --x-initial unique $search $generics -Mdir $dir $(find rtl -name $top.v) \
            $(find sim -name waivers.vlt) &&
            g++ -std=c++17 -O2 -Wall -Wextra -Wno-unused-parameter $macros -Icmodel -Itb -I$dir \
                -isystem "$include" tb/$bench.cpp $dir/*.cpp $out/verilated*.o \
                build/libsphaera.a -lm -lpthread -o $dir/bench
    fi
    tests=$((tests + 1))
    if [ -x $dir/bench ]; then
        $dir/bench "$@" || status=1
    else
        echo "not ok $bench $profile: does not build"
        status=1
    fi
done <tb/benches.txt
[ $tests = 0 ] && echo "not ok run_bench.sh: nothing matches $pattern" && status=1
exit $status
