#!/bin/sh
# test_mutants.sh - faults put into the RTL are noticed by the comparisons
# SPDX-License-Identifier: Apache-2.0
#
# Each mutant of tests/mutants/mutants.txt is one edit in a copy of the RTL, run in Icarus (which
# builds in a second) against the golden model, or in a block bench. Every frame is drawn by the
# sound RTL first, without a mismatch, with ALL in Icarus too; so is every bench, unless
# test_benches.sh runs it anyway.
# Of each folder of the RTL one mutant, in a bench if it has such. That the text of every mutant
# stands in its file once is looked at for all.
#   MUTANT=pattern  those whose name has the pattern in it
#   ALL=1           all (`make mutants`)
set -u
self=$0
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../edit.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build} ALL=${ALL:-}
export BUILD SPHAERA TMP ALL

# Frame of the core in draft widths: scene [build options] [-- harness options].
core() {
    scene=$1 options=
    shift
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        options="$options $1"
        shift
    done
    [ $# -eq 0 ] || shift
    # shellcheck disable=SC2086  # a list of words on purpose
    "$SPHAERA" build "$scene" --profile draft --size 25x19 $options -o "$here/scene.sph" || return 2
    set -- --machine "$here/scene.sph" --stop --watchdog 5000 --latency 5 --stall 20 --seed 7 "$@"
    if [ "$file$ALL" = - ]; then
        OPT=-O0 sh sim/core.sh "$@"
    else
        BUILD=$here/build RTL=$here/rtl SIM=icarus sh sim/core.sh "$@"
    fi
}
# The same with just what the scene asks for: with textures, too.
textured() {
    EFFECTS=auto
    export EFFECTS
    core "$@"
}
# The same on a core of three pipes, two shading units and one leaf unit.
piped() {
    PIPES=3 LEAF_UNITS=1
    export PIPES LEAF_UNITS
    textured "$@"
}
# A block bench, in a folder that looks like this one but for its rtl.
bench() {
    cp -al Makefile VERSION make cmodel driver formal scenes sim synth tb tests "$here/" &&
        sh "$here/tb/run_bench.sh" "$1" 1
}
# rt_top with the golden model in place of its core, under its driver.
top() {
    cp -al make cmodel driver sim tb tests "$here/" && cp -al "$BUILD/top" "$here/build/" &&
        (cd "$here" && eval "set -- DATA=${1:-64} LAYERS=${2:-0} $(cat "$TMP/shell")" &&
            set -- -s -f make/rt_top.mk B=build BENCH=tb_shell SEED=1 "$@" &&
            { make "$@" top >build/log 2>&1 || { cat build/log && return 2; }; } &&
            { timeout 600 make "$@" run || return 1; })
}
# Runs a job file; 0: noticed (sound RTL: passes), 1: not noticed, 2: could not be run.
job() {
    {
        IFS= read -r name
        IFS= read -r file
        IFS= read -r FROM
        IFS= read -r TO
        IFS= read -r by
    } <"$1"
    here=$1.dir NEW=$1.new
    export FROM TO NEW
    mkdir -p "$here/build/sim" "$here/build/test"
    cp -r "$TMP/rtl" "$here/rtl"
    [ "$file" = - ] || edit "$here/rtl/$file" || return 2
    # what is the same for all counts as built
    cp -al "$BUILD/sim/obj" "$BUILD/sim/tb_core_icarus" "$here/build/sim/"
    cp -al "$BUILD/libsphaera.a" "$BUILD/obj" "$BUILD/flags" "$BUILD/sources" "$here/build/"
    cp -al "$BUILD/test/obj" "$BUILD/test/libhard.a" "$here/build/test/"
    # shellcheck disable=SC2086  # a list of words on purpose
    $by >"$1.out" 2>&1
    rc=$?
    cat "$1.out"
    rm -rf "$here"
    [ "$file" != - ] || return $rc
    # a difference, not a build that broke
    [ $rc -eq 1 ] || [ $rc -eq 4 ] || return $((rc ? 2 : 1)) # 4: the core hangs
    grep -qE 'does not build|nothing matches' "$1.out" && return 2
    grep -qE ' [1-9][0-9]* mismatches|^not ok' "$1.out"
}
if [ "${1:-}" = --job ]; then
    job "$2" >"$2.log" 2>&1
    echo $? >"$2.rc"
    exit 0
fi

# ---- jobs: first the sound RTL in every comparison that some mutant is run in ----
jobs=0
add() { # name, file, from, to, by, rule
    jobs=$((jobs + 1))
    printf '%s\n' "$@" >"$TMP/$(printf %03d $jobs).job"
}
# Of each folder one: the first in a bench, else the first; of rt_top in all one.
awk '$1 == "mutant" { name = $2 } $1 == "file" { split($2, folder, "/") } $1 == "by" {
    place = $2 == "top" ? "top" : folder[1]
    if (!(place in chosen) || $2 == "bench" && how[place] != "bench") {
        chosen[place] = name
        how[place] = $2
    }
} END { for (place in chosen) print chosen[place] }' tests/mutants/mutants.txt >"$TMP/chosen"
wanted() {
    name= file= from= to= by= rule=
    while read -r key rest; do
        case $key in
        mutant) name=$rest ;;
        rule) rule=$rest ;;
        file) file=$rest ;;
        from) from=$rest ;;
        to) to=$rest ;;
        by)
            case ${ALL:+all}${MUTANT:-} in
            '') grep -qx "$name" "$TMP/chosen" && "$1" "$rest" ;;
            all*) "$1" "$rest" ;;
            *) case $name in *"$MUTANT"*) "$1" "$rest" ;; esac ;;
            esac
            ;;
        esac
    done <tests/mutants/mutants.txt
}
print_by() { echo "$1"; }
add_mutant() { add "$name" "$file" "$from" "$to" "$1" "$rule"; }
wanted print_by | sort -u >"$TMP/comparisons"
while IFS= read -r by; do
    case ${ALL:-}${MUTANT:-}$by in bench*) ;; *) add "sound RTL" - - - "$by" "passes $by" ;; esac
done <"$TMP/comparisons"
wanted add_mutant

# ---- every mutant fits: its text stands in its file once ----
fits() {
    FROM=$from TO=$to NEW=$TMP/new
    export FROM TO NEW
    cp "rtl/$file" "$TMP/fits" && edit "$TMP/fits"
}
count_fits() {
    fits >"$TMP/fits.out" 2>&1 || { echo "$name, rtl/$file:" && cat "$TMP/fits.out"; } \
        >>"$TMP/unfit"
}
given=${MUTANT:-}+${ALL:-}
ALL=1
wanted count_fits
MUTANT=${given%+*} ALL=${given#*+}
check "the text of every mutant stands in its file once" sh -c '! cat "$1" 2>&1' - "$TMP/unfit"

cp -r rtl "$TMP/rtl" # all jobs see one state
sh sim/core.sh --help >"$TMP/harness.log" 2>&1 || cat "$TMP/harness.log"
BENCH_BUILD=$BUILD sh tb/run_bench.sh --tools
if grep -q '^top' "$TMP/comparisons"; then
    env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory B="$BUILD" top-shell \
        >"$TMP/shell"
fi
find "$TMP" -name '*.job' | sort | xargs -P 2 -I JOB sh "$self" --job JOB

# ---- what became of them ----
for file in "$TMP"/*.job; do
    name=$(sed -n 1p "$file")
    rule=$(sed -n 6p "$file")
    rc=$(cat "$file.rc" 2>/dev/null || echo 2)
    by=$(sed -n 5p "$file")
    if [ "$name" = "sound RTL" ]; then
        tap "$((rc != 0))" "$rule" "$file.log"
        continue
    fi
    how=$(sed -n 's/^  stage  *//p; s/^counter \([^ ]*\).*/counter \1/p
        s/^\(error bit [a-z_]*\).*/\1/p; s/^.*\(no progress for .*\)/hang: \1/p
        s/^vvp ended .* time: .*u_core\.//p; s/^not ok/&/p' "$file.log" | head -n 1)
    case $rc in
    0) tap 0 "mutant $name ($rule) killed by $by: $how" "$file.log" ;;
    1) tap 1 "mutant $name ($rule) survives $by" "$file.log" ;;
    *) tap 1 "mutant $name cannot be run" "$file.log" ;;
    esac
done
done_testing
