#!/bin/sh
# test_common_mode.sh - faults in model and RTL alike are noticed by what shares no code with them
# SPDX-License-Identifier: Apache-2.0
#
# Each twin of tests/mutants/common_mode.txt is an edit in a copy of the RTL and one in a copy of a
# file of the model. Both draw a frame in Icarus, and agree in every pixel and counter; then the
# naive model or the oracle of a named case must notice it. The sound model passes both.
#   MUTANT=pattern  those whose name has the pattern in it
#   ALL=1           all (`make common-mode`), else two
set -u
self=$0
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../edit.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=$(realpath "${BUILD:-build}")
export BUILD SPHAERA TMP
libs=$(pkg-config --libs jansson expat gmp mpfr)

compile() { # object of the edited model, sources...; result last
    gcc -std=c11 -D_GNU_SOURCE -O1 -w -Icmodel -Itests -Itests/hard "$@"
}
# The oracle, linked with an edited object, or with none.
oracle() { # folder, object or nothing
    here=$1
    shift
    case $by in
    naive)
        # shellcheck disable=SC2086  # a list of words on purpose
        compile tests/reference/naive_frame.c "$@" "$BUILD/libsphaera.a" $libs -lm \
            -o "$here/oracle" || return 2
        "$here/oracle" "$here/scene.sph"
        ;;
    hard*)
        # shellcheck disable=SC2086
        gcc "$BUILD"/test/obj/tests/hard/*.o "$BUILD/obj/cmodel/tool/progress.o" "$@" \
            "$BUILD/libsphaera.a" $libs -lm -o "$here/oracle" || return 2
        "$here/oracle" --named="${by#hard }"
        ;;
    esac
}
# 0: both sides agree and the oracle notices; else what went otherwise stands in the log.
job() {
    {
        IFS= read -r name
        IFS= read -r model
        IFS= read -r from
        IFS= read -r to
        IFS= read -r rtl
        IFS= read -r rtl_from
        IFS= read -r rtl_to
        IFS= read -r scene
        IFS= read -r by
    } <"$1"
    here=$1.dir NEW=$1.new
    export FROM TO NEW
    mkdir -p "$here/build/sim"
    cp -r rtl "$here/rtl"
    cp "cmodel/$model" "$here/twin.c"
    FROM=$from TO=$to
    edit "$here/twin.c" || return 2
    FROM=$rtl_from TO=$rtl_to
    edit "$here/rtl/$rtl" || return 2
    compile -c "-Icmodel/${model%/*}" "$here/twin.c" -o "$here/twin.o" || return 2
    compile -c tests/mutants/literal.c -o "$here/literal.o" || return 2
    # shellcheck disable=SC2086
    "$SPHAERA" build --profile draft --size 12x9 $scene -o "$here/scene.sph" || return 2
    oracle "$here" || { echo "the sound model does not pass $by" && return 2; }

    # ---- both sides, in Icarus: the harness linked with the model's twin ----
    cp -al "$BUILD/sim/obj" "$BUILD/sim/tb_core_icarus" "$here/build/sim/"
    cp -al "$BUILD/libsphaera.a" "$here/build/"
    core=$("$SPHAERA" info "$here/scene.sph" | sed -n 's/^core *//p')
    folder=$(BUILD=$here/build RTL=$here/rtl SIM=icarus EFFECTS=auto \
        sh sim/core.sh --machine "$here/scene.sph" --folder) || return 2
    others='verilated|simulate_(verilator|netlist|cxxrtl|host|stages)'
    # shellcheck disable=SC2046  # a list of words on purpose
    g++ $(find "$BUILD/sim/obj" -name '*.o' | grep -vE "$others") "$here/twin.o" \
        "$here/literal.o" "$BUILD/libsphaera.a" -Wl,--wrap=sph_render -ljansson -lm -lpthread \
        -o "$here/harness" || return 2
    set -- --machine "$here/scene.sph" --engine "$folder/tb_core.vvp" --core "$core" \
        --built "$(sh sim/parameters.sh "$core")" --watchdog 5000 --latency 5 --stall 20 --seed 7
    "$here/harness" "$@" || { echo "model and RTL do not agree" && return 2; }
    "$BUILD/sim/tb_core_icarus" "$@" --stop >"$here/sound" && echo "the scene does not show it"

    oracle "$here" "$here/twin.o" && { echo "$by notices nothing" && return 1; }
    rm -rf "$here"
}
if [ "${1:-}" = --job ]; then
    job "$2" >"$2.log" 2>&1
    echo $? >"$2.rc"
    exit 0
fi

jobs=0
while read -r key rest; do
    case $key in
    twin) name=$rest ;;
    model) model=$rest side=model ;;
    rtl) rtl=$rest side=rtl ;;
    from) [ $side = model ] && from=$rest || rtl_from=$rest ;;
    to) [ $side = model ] && to=$rest || rtl_to=$rest ;;
    scene) scene=$rest ;;
    by)
        jobs=$((jobs + 1))
        case $name in *"${MUTANT:-}"*) ;; *) continue ;; esac
        [ -n "${ALL:-}${MUTANT:-}" ] || [ $((jobs % 5)) -eq 4 ] || continue
        printf '%s\n' "$name" "$model" "$from" "$to" "$rtl" "$rtl_from" "$rtl_to" "$scene" \
            "$rest" >"$TMP/$(printf %02d $jobs).job"
        ;;
    esac
done <tests/mutants/common_mode.txt

sh sim/core.sh --help >"$TMP/harness.log" 2>&1 || cat "$TMP/harness.log"
find "$TMP" -name '*.job' | sort | xargs -P 2 -I JOB sh "$self" --job JOB
ten() { [ "$(grep -c '^twin ' tests/mutants/common_mode.txt)" -ge 10 ]; }
check "ten twins" ten
for file in "$TMP"/*.job; do
    rc=$(cat "$file.rc" 2>/dev/null || echo 2)
    tap "$rc" "twin $(sed -n 1p "$file"): model and RTL agree, $(sed -n 9p "$file") notices" \
        "$file.log"
done
done_testing
