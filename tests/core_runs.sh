# core_runs.sh - many runs of the core's harness, two at a time; sourced after tap.sh
# SPDX-License-Identifier: Apache-2.0
#
# start FOLDER    SEED, BUILD, CORE by default; empties FOLDER of $BUILD/test, for machines
# machine NAME SCENE [OPTION...]   builds one there; $every: options of all, standard and nodes of
#                                  four children unless a run asks for something else
# wanted NAME CORE SETTINGS MACHINE [OPTION...]   run of such a machine, if NAME has $CORE in it
# run NAME CORE SETTINGS FILE [OPTION...]   notes a run; latency 1 to 60 by SEED and NAME, 1 to 12
#                 in Icarus, where a small frame waits most of its clocks, a millisecond each
# build_cores     builds what the runs need, each core once
# run_all         runs them; leaves NUMBER.log and NUMBER.rc in $TMP, NUMBER counted from 1
# judge           one TAP line a run: ok if not one bit differs
# refused LIST MACHINE   whether such a core gives no pixel of the machine, and says so
runs=$TMP/runs
: >"$runs"
every="--accel bvh4"

start() {
    SEED=${SEED:-1} BUILD=${BUILD:-build} CORE=${CORE:-}
    export BUILD OPT=-O0 JOBS=1
    echo "# SEED=$SEED; one run again: SEED=$SEED CORE=NAME make test ONLY=test_$1"
    machines=$BUILD/test/$1
    rm -rf "$machines"
    mkdir -p "$machines"
}
machine() {
    file=$machines/$1.sph scene=$2
    shift 2
    # shellcheck disable=SC2086  # a list of words on purpose
    "$SPHAERA" build "$scene" -o "$file" --profile standard $every "$@" >"$TMP/build" 2>&1 ||
        check "$file" cat "$TMP/build"
}
wanted() {
    case $1 in *"$CORE"*) ;; *) return ;; esac
    title=$1 list=$2 with=$3 file=$machines/$4.sph
    shift 4
    run "$title" "$list" "$with" "$file" "$@"
}

# CORE: the list that is built, or auto. SETTINGS: SIM=..., ENGINES=... of sim/core.sh.
run() {
    seed=$(($(printf '%s' "$1 $SEED" | cksum | cut -d' ' -f1) % 100000))
    label=$1 settings="EFFECTS=$2 $3" run_machine=$4
    case $3 in *SIM=icarus*) longest=12 ;; *) longest=60 ;; esac
    shift 4
    echo "$label|env $settings sh sim/core.sh --machine $run_machine|--seed $seed" \
        "--latency $((seed % longest + 1)) --stall 30 $*" >>"$runs"
}
# Numbered commands from stdin, two at a time; leaves NUMBER.log and NUMBER.rc in $TMP.
two_at_a_time() {
    # shellcheck disable=SC2016  # expanded by the inner shell
    awk '{ print NR "|" $0 }' | tr '\n' '\0' | xargs -0 -P 2 -I COMMAND sh -c '
        number=${1%%|*}
        sh -c "${1#*|}" >"$TMP/$number.log" 2>&1
        echo $? >"$TMP/$number.rc"' sh COMMAND
}
# "PROFILE LIST" of a machine. The tool says it too, but takes long to start.
asked_for() {
    [ -e "$TMP/tools.log" ] || sh sim/core.sh --help >"$TMP/tools.log" 2>&1 # as sources are now
    "$BUILD/sim/tb_core_icarus" --machine "$1" --info | cut -d' ' -f1,2
}
# One machine of each profile and list builds the core: --info simulates nothing. Verilator's
# first: they take longest.
build_cores() {
    sh sim/core.sh --help >"$TMP/tools.log" 2>&1 # the tools, if sources changed
    while IFS='|' read -r name command options; do
        settings=${command%% sh sim/core.sh*}
        asked=$(asked_for "${command##* }") axes=$asked
        case $settings+$asked in # `all` walks the machine's own tree
        *EFFECTS=auto*) ;;
        *EFFECTS=all*+bih | *EFFECTS=all*" bih") asked="${asked% *} bih" ;;
        *EFFECTS=all*+boxes | *EFFECTS=all*" boxes") asked="${asked% *} boxes" ;;
        *) asked=${asked% *} ;;
        esac
        case $settings+$axes in *EFFECTS=all*turned*) asked="$asked turned" ;; esac
        case $settings in *SIM=icarus*) order=2 ;; *) order=1 ;; esac
        echo "$order $settings $asked|BUILT=tools $command --info"
    done <"$runs" | sort -t'|' -k1,1 -u | cut -d'|' -f2 | two_at_a_time
    rm -f "$TMP"/*.rc
}
run_all() {
    BUILT=1
    export BUILT
    cut -d'|' -f2- "$runs" | tr '|' ' ' | two_at_a_time
}
judge() {
    number=0
    while IFS='|' read -r name command options; do
        number=$((number + 1))
        echo "repeat: BUILD=$BUILD OPT=$OPT $command $options" >>"$TMP/$number.log"
        [ "$(cat "$TMP/$number.rc" 2>/dev/null)" = 0 ] &&
            grep -q '^core .* pixels, 0 mismatches[;,] ' "$TMP/$number.log" && rc=0 || rc=1
        said=$(sed -n 's/^core .*: \([0-9]* pixels, .*cycles\), .*/\1/p' "$TMP/$number.log")
        tap $rc "$name: $said" "$TMP/$number.log"
    done <"$runs"
}
refused() {
    env -u BUILT SIM=icarus EFFECTS="$1" sh sim/core.sh --machine "$machines/$2.sph" \
        >"$TMP/said" 2>&1
    [ $? -eq 3 ] && cat "$TMP/said" && grep -q '^refused: ' "$TMP/said"
}
