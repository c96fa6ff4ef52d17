#!/bin/sh
# run_bench.sh - builds and runs block benches: run_bench.sh [pattern [seed [vectors]]]
# SPDX-License-Identifier: Apache-2.0
#
# pattern selects lines of tb/benches*.txt by bench/profile, e.g. tb_leaf or tb_leaf/standard; of
# all lines (/, the default) those that are for ALL=1 are left out without it.
# run_bench.sh --tools builds what all benches have in common, and no more.
# A line: configuration, module, bench, parameters of the module / only the bench's; tb/benches.awk
# says how it takes the widths of a profile from machine.def.
#   BENCH_BUILD  build folder (build); all that is made here lies in its folder tb
#   BENCH_JOBS   benches at once (1)
#   BENCH_OPT    compiler's effort (-O1, or what the head of a bench says it is compiled with)
#   HARD_CASE    number of a named case: these vectors and no others (tb/hard.h)
cd "$(dirname "$0")/.." || exit 1
BENCH_BUILD=${BENCH_BUILD:-build} BENCH_OPT=${BENCH_OPT:-}
export BENCH_BUILD BENCH_OPT
out=$BENCH_BUILD/tb shared=$BENCH_BUILD/sim/obj
models="$BENCH_BUILD/test/libhard.a $BENCH_BUILD/libsphaera.a"
# Whether one of the files that a compiler's dependency file names is newer than a result.
outdated() { # result, dependency files
    result=$1
    shift
    [ -f "$result" ] && [ -f "$1" ] && [ -f "$2" ] || return 0
    # shellcheck disable=SC2046  # a list of words on purpose
    [ -n "$(find $(cat "$@" | sed 's/^[^:]*://' | tr -d '\\') -newer "$result" 2>&1 |
        head -n 1)" ]
}

# How hard the compiler works on a bench: BENCH_OPT, else what its head says, else -O1.
effort_of() { # source
    said=${BENCH_OPT:-$(sed -n 's/^ \* Compiled with \(-O.\),.*/\1/p; /\*\//q' "$1")}
    echo "${said:--O1}"
}
# Builds a line's bench unless it is there; 0 if it can be run.
build() { # profile, module, bench, parameters
    profile=$1 top=$2 bench=$3
    shift 3
    dir=$out/$bench-$profile generics= macros= inner=1
    for p; do
        if [ "$p" = / ]; then
            inner=
            continue
        fi
        macros="$macros -D$p"
        [ -z "$inner" ] || generics="$generics -G$p"
    done
    mkdir -p "$dir"
    source=$(find tb -name "$bench.cpp")
    effort=$(effort_of "$source")
    line="$top $generics $macros $effort $(cat "$shared/versions")"
    echo "$line" | cmp -s - "$dir/line" || rm -f "$dir/bench.o"
    echo "$line" >"$dir/line"
    if outdated "$dir/bench.o" "$dir/bench.d" "$dir/V${top}__ver.d"; then
        rm -f "$dir/bench" "$dir"/*.cpp "$dir"/*.o
        # shellcheck disable=SC2046,SC2086  # lists of words on purpose
        verilator --cc --top-module "$top" --language 1364-2005 -Wall -O3 --x-assign unique \
            --x-initial unique $(find rtl tb/board -type d | sed 's/.*/-y & -I&/') $generics \
            -Mdir "$dir" $(find rtl -name "$top.v") || return 1
        sh sim/at_once.sh "$dir" "$source" >"$dir/all.cpp"
        # shellcheck disable=SC2046,SC2086  # lists of words on purpose
        $(cat "$shared/compile$effort") -DPROFILE="\"$profile\"" $macros -isystem "$dir" -MD \
            -MF "$dir/bench.d" -c "$dir/all.cpp" -o "$dir/bench.o" || return 1
    fi
    # shellcheck disable=SC2086,SC2046  # lists of words on purpose
    [ -z "$(find "$dir/bench.o" $models -newer "$dir/bench" 2>&1)" ] ||
        $(cat "$shared/link") "$dir/bench.o" "$shared"/bench_*.o $models -Wl,--as-needed \
            $(pkg-config --libs gmp mpfr expat) -lm -lpthread -o "$dir/bench"
}

if [ "${1:-}" = --one ]; then
    line=$2
    shift 2
    # shellcheck disable=SC2086  # a list of words on purpose
    set -- "$(set -- $line && echo "$3-$1")" "$@"
    log=$out/$1.log
    # shellcheck disable=SC2086
    if build $line >"$log" 2>&1; then
        # $finish in the RTL ends a bench with status 0, but without its last line
        "$out/$1/bench" "${2:-1}" ${3:+"$3"} >"$log" 2>&1 && grep -q '^ok' "$log" && rc=0 || rc=1
        [ $rc = 0 ] || grep -q '^not ok' "$log" || echo "not ok $1: ended early" >>"$log"
    else
        echo "not ok $1: does not build" >>"$log"
        rc=1
    fi
    cat "$log"
    exit $rc
fi

pattern=${1:-/}
[ $# -gt 0 ] && shift
mkdir -p "$out" "$BENCH_BUILD/sim"
# shellcheck disable=SC2086  # a list of words on purpose
env -u MAKEFLAGS -u MFLAGS make --no-print-directory B="$BENCH_BUILD" \
    $models >"$out/model.log" || { cat "$out/model.log"; exit 1; }
tools() { # efforts
    for effort; do
        flock "$BENCH_BUILD/sim/.tools.lock" env -u MAKEFLAGS -u MFLAGS make -s \
            --no-print-directory -f make/verilated.mk B="$BENCH_BUILD" OPT="$effort" bench-tools ||
            exit 1
    done
}
[ "$pattern" != --tools ] || {
    # shellcheck disable=SC2086  # a list of words on purpose
    tools ${BENCH_OPT:--O0 -O1}
    exit 0
}

work=$(mktemp -d "$out/.list.XXXXXXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 130' HUP INT TERM
[ "$pattern" = / ] && all=${ALL:-} || all=1
awk -v pattern="$pattern" -v all="$all" -f tb/benches.awk cmodel/machine/machine.def \
    tb/benches*.txt >"$work/list" || exit 1
tr '\n' '\0' <"$work/list" >"$work/lines"
efforts=$(cut -d' ' -f3 "$work/list" | sort -u | while read -r bench; do
    effort_of "$(find tb -name "$bench.cpp")"
done | sort -u)
if [ ! -s "$work/lines" ]; then
    echo "not ok run_bench.sh: nothing matches $pattern"
    exit 1
fi
# shellcheck disable=SC2086  # a list of words on purpose
tools $efforts
xargs -0 -P "${BENCH_JOBS:-1}" -I LINE sh "$0" --one LINE "$@" <"$work/lines" && rc=0 || rc=1
exit $rc
