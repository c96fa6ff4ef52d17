#!/bin/sh
# slurm_real.sh - a study on a Slurm of two nodes: one is killed, results are damaged, none is lost
# SPDX-License-Identifier: Apache-2.0
#
# What `make slurm-test` runs; it says so where there is no Slurm.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-$PWD/build} tool=${SPHAERA:-$BUILD/sphaera}
cluster() { what=$1 && shift && sh tests/jobs/cluster.sh "$what" "$TMP/here" "$@"; }
trap 'cluster stop 2>/dev/null' EXIT
study() { python3 -m lab.checks.slurm_study plan "$tool" "$BUILD" "$TMP/$1" "$TMP/$1.list" &&
    env -u MAKEFLAGS -u MFLAGS python3 -m lab jobs "$2" "$TMP/$1.list"; }
whole() { ls "$TMP/slurm" 2>/dev/null | grep -c 'json$'; }
until_true() { # seconds, command
    n=$(($1 * 5))
    shift
    until "$@"; do
        n=$((n - 1))
        [ $n -gt 0 ] || return 1
        sleep 0.2
    done
}
on_node2() { [ "$(squeue -h -w node2 -t R -o %i 2>/dev/null | wc -l)" -gt 0 ]; }
some() { [ "$(whole)" -ge "$1" ]; }

cluster start 2 2>"$TMP/err"
rc=$?
tap "$rc" "munged, slurmctld and two slurmd are up" "$TMP/err" # or what is to be done
[ $rc = 0 ] || { done_testing && exit 1; }
export SLURM_CONF="$TMP/here/slurm.conf"

study slurm slurm >"$TMP/said" 2>&1 &
engine=$!
check "results come" until_true 300 some 5
first=$(ls "$TMP/slurm"/*.json | head -n 1)
head -c 99 "$first" >"$first.half" && mv "$first.half" "$first"
check "node2 has a chunk" until_true 300 on_node2
cluster kill node2
echo "# node2 was killed with $(whole) results there" >&2
check "... while jobs were left" kill -0 $engine
wait $engine
tap $? "the study ends well on the other node" "$TMP/said"
cat "$TMP/said"
check "Slurm saw a node die" sh -c "sinfo -h -N -o '%N %t' | tee '$TMP/out' | grep -q 'node2 down'"
check "the damaged result was made anew" grep -q "round 2: [0-9]* jobs" "$TMP/said"
check "the same with make" study make make
check "results and page are those of make" python3 -m lab.checks.slurm_study same "$TMP/slurm" \
    "$TMP/make"
second=$(ls "$TMP/slurm"/*.json | tail -n 1)
sed -i 's/"pixels": 576/"pixels": 577/' "$second"
check "one that was damaged later is made anew, and no other" sh -c "
    python3 -m lab.checks.slurm_study plan '$tool' '$BUILD' '$TMP/slurm' '$TMP/again' 2>&1 |
        tee '$TMP/out' | grep -q ' jobs, 1 to run' &&
    python3 -m lab jobs slurm '$TMP/again' &&
    python3 -m lab.checks.slurm_study same '$TMP/slurm' '$TMP/make'"
check "make study takes the engine" sh -c "env -u MAKEFLAGS -u MFLAGS make study-short \
    KINDS=accuracy B='$BUILD' RESULTS='$TMP/short' ENGINE=slurm && ls '$TMP'/short/*.json"
check "make hard too: its table is that of this machine" sh -c "
    for engine in make slurm; do
        env -u MAKEFLAGS -u MFLAGS make hard N=3000 FAMILY=facets SEED=$$ B='$BUILD' \
            ENGINE=\$engine >'$TMP/hard' || exit 1
        cat '$TMP/hard' && grep '^|' '$TMP/hard' >'$TMP/hard'.\$engine
    done
    grep -q '^hard: 4 jobs, 4 to run' '$TMP/hard' && grep -q '^0 cases in' '$TMP/hard' &&
    diff '$TMP/hard.make' '$TMP/hard.slurm'"
check "make film too: its frames are those of this machine" sh -c "
    for engine in slurm make; do
        env -u MAKEFLAGS -u MFLAGS make film SCENE=moving/orbit SIZE=47x31 FRAMES=0..7 B='$BUILD' \
            MOVIE='$TMP/film.gif' ENGINE=\$engine >'$TMP/film' 2>&1 || exit 1
        cat '$TMP/film'
        folder=\$(dirname \$(ls -t '$BUILD'/film/*/7.png | head -n 1))
        mv \$folder '$TMP/film-of-'\$engine
    done
    for n in 0 1 2 3 4 5 6 7; do
        cmp '$TMP/film-of-make'/\$n.png '$TMP/film-of-slurm'/\$n.png || exit 1; done"
slants="$BUILD/textures/slant-75.json $BUILD/textures/slant-60.json"
targets() { # shellcheck disable=SC2086  # words
    python3 -m lab target-plan textures "$BUILD" "$TMP/targets" "$TMP/targets.list" \
        'scenes/texture/*' $slants && python3 -m lab jobs slurm "$TMP/targets.list"
}
half() { # a target that breaks off in its middle, and has no result
    rm -f "$TMP/targets"/*
    echo '{' >"$BUILD/textures/slant-75.json"
}
check "files of an experiment" targets
cp "$BUILD/textures/slant-75.json" "$TMP/slant"
state() { ls -l --time-style=full-iso "$BUILD"/textures/slant-*.json; }
state >"$TMP/before"
check "... which are then up to date" sh -c \
    "python3 -m lab textures --build '$BUILD' --file $(echo $slants | sed 's/ / --file /')"
state >"$TMP/after"
check "... and not made again" cmp "$TMP/before" "$TMP/after"
half
check "... and anew where half of one lies there" targets
check "... as it was" sh -c "sed '/seconds/d' '$BUILD/textures/slant-75.json' >'$TMP/a' &&
    sed '/seconds/d' '$TMP/slant' | diff - '$TMP/a'"
done_testing
