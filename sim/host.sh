#!/bin/sh
# host.sh - random lives of cores under a host, and what they met: `make host`
# SPDX-License-Identifier: Apache-2.0
#
# usage: BUILD=build SPHAERA=build/sphaera SEED=n TRIALS=n sh sim/host.sh [pattern]
# Each core below takes TRIALS trials (tb/core/trials.h), in Icarus a fiftieth of them; pattern
# selects some by name. Leaves $BUILD/host/NAME.log and $BUILD/host/events.md, a table of the events
# met. Fails if a core differs from the model, or if some event was never met.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build} SEED=${SEED:-1} TRIALS=${TRIALS:-1000}
only=${1:-}
out=$BUILD/host
mkdir -p "$out"
export BUILD OPT=-O1

build() { # name, scene, options
    file=$out/$1 from=$2
    shift 2
    "$SPHAERA" build "$from" --size 3x2 -o "$file.sph" "$@" >"$file.build" 2>&1 ||
        { cat "$file.build" && exit 1; }
}
draft="--profile draft"
# shellcheck disable=SC2086  # a list of words on purpose
{
    for scene in paper5 inside interpenetrating; do
        build $scene scenes/$scene.nff $draft --depth 1 --accel bvh4
        build $scene-boxes scenes/$scene.nff $draft --depth 1 --accel box4
    done
    build bih scenes/inside.nff $draft --depth 1 --accel bih
    build facets-bih tests/scenes/facets/mixed.nff $draft --depth 1 --accel bih
    build facets tests/scenes/facets/mixed.nff $draft --depth 1 --accel bvh4
    build balls tests/scenes/texture/balls.nff $draft --depth 1 --accel bvh4
    build optics tests/scenes/refraction/mixed.nff $draft --depth 2 --accel bvh4
    build spans scenes/paper5.nff $draft --depth 1 --accel bvh4 --background spans
    build cones scenes/paper5.nff $draft --depth 1 --accel bvh4 --background exact
    build standard scenes/paper5.nff --profile standard --depth 1 --accel bvh4
}
# name, effects, settings, trials, machines
lives() {
    echo "everything all+texture+refract+specular+sum+spread SIM=verilator $TRIALS" \
        "balls inside facets optics paper5"
    echo "all all SIM=verilator $TRIALS interpenetrating paper5 spans cones facets"
    echo "engines all ENGINES=2 $TRIALS inside paper5 interpenetrating spans"
    echo "bih all+bih SIM=verilator $TRIALS bih facets-bih"
    echo "boxes all+boxes SIM=verilator $TRIALS inside-boxes paper5-boxes"
    echo "standard auto SIM=verilator $TRIALS standard"
    echo "icarus all+texture+refract+specular+sum SIM=icarus $(((TRIALS + 49) / 50)) paper5 optics"
}
failed=0
lives >"$out/lives"
while read -r name effects settings trials machines; do
    case $name in *"$only"*) ;; *) continue ;; esac
    options=
    for machine in $machines; do options="$options --then $out/$machine.sph"; done
    # shellcheck disable=SC2086  # a list of words on purpose
    env EFFECTS="$effects" "$settings" sh sim/core.sh --machine ${options# --then } --life \
        --latency 10 --trials "$trials" --seed "$SEED" >"$out/$name.log" 2>&1 </dev/null || failed=1
    grep -v '^met' "$out/$name.log" | sed "s/^/$name: /"
done <"$out/lives"
awk -v only="$only" -v trials="$TRIALS" -v seed="$SEED" '
    FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\.log$/, "", name)
               columns[++n] = name }
    $1 == "met" { event = $0; sub(/^met [0-9]* /, "", event)
                  if (!(event in seen)) { seen[event] = 1; events[++e] = event }
                  met[event, name] = $2; sum[event] += $2 }
    END {
        printf "| SEED=%d, TRIALS=%d: met in", seed, trials
        for (i = 1; i <= n; i++) printf " | %s", columns[i]
        printf " |\n|---"
        for (i = 1; i <= n; i++) printf "|---"
        print "|"
        for (k = 1; k <= e; k++) {
            printf "| %s", events[k]
            for (i = 1; i <= n; i++) printf " | %d", met[events[k], columns[i]]
            print " |"
            if (!sum[events[k]]) { print "never met: " events[k] >"/dev/stderr"; bad = only == "" }
        }
        exit bad
    }' $(awk -v only="$only" -v out="$out" 'index($1, only) { print out "/" $1 ".log" }' \
    "$out/lives") >"$out/events.md" || failed=1
[ $failed = 0 ] && echo "host: every frame is the model's, every event was met"
exit $failed
