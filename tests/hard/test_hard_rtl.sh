#!/bin/sh
# test_hard_rtl.sh - faults put into the RTL are noticed by the vectors of one named hard case each
# SPDX-License-Identifier: Apache-2.0
#
# Each mutant of tests/hard/rtl_mutants.txt is one edit in a copy of the RTL. Its bench drives the
# vectors of the case and nothing else (HARD_CASE, tb/hard.h): it must fail, and name the case. The
# sound RTL must pass the same vectors.
#   MUTANT=pattern  only mutants whose name or bench has the pattern in it
#   ALL=1           all of the list (`make hard-rtl`)
set -u
self=$0
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../edit.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
export BUILD TMP BENCH_BUILD=build

# A folder that looks like this one, built as far as all benches share it.
tree() { # its name
    mkdir -p "$1/build/test" "$1/build/sim"
    cp -al Makefile VERSION make cmodel formal tb sim synth tests "$1/"
    cp -al "$BUILD/libsphaera.a" "$BUILD/obj" "$BUILD/flags" "$BUILD/sources" "$1/build/"
    cp -al "$BUILD/test/obj" "$BUILD/test/libhard.a" "$1/build/test/"
    cp -al "$BUILD/sim/obj" "$1/build/sim/"
    cp -r "$TMP/rtl" "$1/rtl"
}
# A job file: name, bench, file, from, to, case. 0: noticed, 1: not noticed, 2: could not be run.
mutant() {
    {
        IFS= read -r name
        IFS= read -r bench
        IFS= read -r file
        IFS= read -r FROM
        IFS= read -r TO
        IFS= read -r HARD_CASE
    } <"$1"
    here=$1.dir NEW=$1.new
    export FROM TO NEW HARD_CASE
    tree "$here"
    edit "$here/rtl/$file" || return 2
    sh "$here/tb/run_bench.sh" "$bench" 1 >"$1.out" 2>&1
    cat "$1.out"
    rm -rf "$here"
    grep -q '^not ok .* vectors differ' "$1.out" || return $((2 - $(grep -c '^ok' "$1.out")))
    grep -q "^#   named case $HARD_CASE, " "$1.out" || return 1
}
# A job file: name, bench, cases. Every case must be driven, and pass.
sound() {
    {
        IFS= read -r name
        IFS= read -r bench
        IFS= read -r numbers
    } <"$1"
    here=$1.dir
    tree "$here"
    sh "$here/tb/run_bench.sh" "$bench" 1 1 || return 1
    for number in $numbers; do
        HARD_CASE=$number "$here"/build/tb/*/bench 1 || return 1
    done
    rm -rf "$here"
}
if [ "${1:-}" = --job ]; then
    case $2 in
    *.sound) sound "$2" >"$2.log" 2>&1 ;;
    *) mutant "$2" >"$2.log" 2>&1 ;;
    esac
    echo $? >"$2.rc"
    exit 0
fi

# ---- jobs; of the mutants that are not run the edit, at least ----
jobs=0
while read -r key rest; do
    case $key in
    mutant) name=$rest run=1 ;;
    more) name=$rest run=${ALL:-}${MUTANT:-} ;;
    file) file=$rest ;;
    from) from=$rest ;;
    to) to=$rest ;;
    bench) bench=$rest ;;
    case)
        case "$name $bench" in *"${MUTANT:-}"*) ;; *) continue ;; esac
        if [ -z "$run" ]; then
            cp "rtl/$file" "$TMP/edited"
            (export FROM="$from" TO="$to" NEW="$TMP/new" && edit "$TMP/edited") >>"$TMP/edits" ||
                echo "mutant $name cannot be made" >>"$TMP/edits"
            continue
        fi
        jobs=$((jobs + 1))
        printf '%s\n' "$name" "$bench" "$file" "$from" "$to" "$rest" \
            >"$TMP/$(printf %03d $jobs).mutant"
        echo "$bench $rest" >>"$TMP/wanted"
        ;;
    esac
done <tests/hard/rtl_mutants.txt
sort -u "$TMP/wanted" | LC_ALL=C awk -v tmp="$TMP" '
    $1 != bench {
        bench = $1
        file = sprintf("%s/%03d.sound", tmp, ++n)
        printf "sound\n%s\n", bench >file
    }
    { printf "%s ", $2 >file }'

cp -r rtl "$TMP/rtl" # all jobs see one state
BENCH_BUILD=$BUILD sh tb/run_bench.sh --tools
printf '%s\n' "$TMP"/*.sound "$TMP"/*.mutant |
    xargs -P "${JOBS:-2}" -I JOB sh "$self" --job JOB

# ---- what became of them ----
touch "$TMP/edits"
edits() { ! grep . "$TMP/edits"; }
[ -n "${ALL:-}" ] || check "the edits of make hard-rtl can be made" edits
for file in "$TMP"/*.sound; do
    bench=$(sed -n 2p "$file")
    rc=$(cat "$file.rc" 2>/dev/null || echo 2)
    tap "$rc" "sound RTL passes in $bench, each case alone: $(sed -n 3p "$file")" "$file.log"
done
for file in "$TMP"/*.mutant; do
    what="$(sed -n 1p "$file"), $(sed -n 2p "$file")"
    number=$(sed -n 6p "$file")
    case $(cat "$file.rc" 2>/dev/null) in
    0) tap 0 "mutant ($what) killed by case $number" "$file.log" ;;
    1) tap 1 "mutant ($what) survives case $number" "$file.log" ;;
    *) tap 1 "mutant ($what) cannot be run" "$file.log" ;;
    esac
done
done_testing
