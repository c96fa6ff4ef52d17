#!/bin/sh
# top.sh - frames of a moving scene on one rt_top, one behind the other, each compared
# SPDX-License-Identifier: Apache-2.0
#
# usage: SCENE=... FRAMES=A..B BUILD_OPTIONS=... LATENCY=n STALL=n SEED=n PROFILE=... CORE_MHZ=n
#        [LAYERS=0|1] [CHIP_BUILDS=TREE] [MOVIE=FILE] sim/top.sh
# Builds the machines of these frames into BUILD/out/top-DIGEST, and rt_top with a core that can do
# what any of them asks for. There are report.json, shown-0000.ppm and so on; MOVIE joins these.
# With LAYERS=1 rt_top has layers: rendering-0000.ppm, l1-0000.ppm and l2-0000.ppm are there too.
# With CHIP_BUILDS it builds the tree of each frame, of that kind, of the records that moved.
set -euf
cd "$(dirname "$0")/.."
tool=$BUILD/sphaera
scene=$(sim/scene.py "$SCENE")
run=$BUILD/out/top-$(printf '%s\n' "$scene" "$FRAMES" "$BUILD_OPTIONS" "$LATENCY" "$STALL" \
    "$SEED" "$PROFILE" "${LAYERS:=0}" "${CHIP_BUILDS:=}" | sha256sum | cut -c 1-8)
mkdir -p "$run"
exec 9>"$run/.lock"
flock 9
find "$run" -mindepth 1 ! -name .lock -delete
if [ ! -f "$scene" ] && [ ! -f "${scene%:*}" ]; then
    "$tool" gen "$scene" --seed "$SEED" -o "$run/scene.nff" >"$run/gen.log"
    scene=$run/scene.nff
fi
# shellcheck disable=SC2086  # a list of words on purpose
"$tool" build "$scene" $BUILD_OPTIONS --frames "$FRAMES" -o "$run/frame.sph" \
    --json "$run/build.json" >"$run/build.log"
set +f
set -- "$run"/frame-*.sph
profile=$("$tool" info "$1" | sed -n 's/^profile *\([^ ]*\): .*/\1/p')
core=$(for file; do "$tool" info "$file" | sed -n 's/^core *//p'; done | tr '+' '\n' |
    awk '{ word = $0; sub(/[0-9]+$/, "", word); count = substr($0, length(word) + 1) + 0
           if (!(word in most)) order[++n] = word
           if (count > most[word]) most[word] = count; most[word] += 0 }
        END { for (i = 1; i <= n; i++) if (order[i] != "none" || n == 1)
                  text = text (text ? "+" : "") order[i] (most[order[i]] ? most[order[i]] : "")
              print text }')
name=$profile-$core-64
[ "$LAYERS" = 0 ] || name=$name-layers
trees=0
if [ -n "$CHIP_BUILDS" ]; then
    spheres=$("$tool" info "$1" | sed -n 's/^ *[0-9]* N_PRIMS *\([0-9]*\) .*/\1/p')
    trees=16
    while [ "$trees" -lt "$spheres" ]; do trees=$((trees * 2)); done
    if [ "$trees" -gt 65536 ]; then
        echo "BUILD=hw: $spheres spheres, of 65536 at most" >&2
        exit 1
    fi
    name=$name-trees$trees
fi
flock "$BUILD/sim/.tools.lock" env -u MAKEFLAGS -u MFLAGS make -s --no-print-directory \
    -f make/rt_top.mk B="$BUILD" BENCH=tb_frames NAME="$name" PROFILE="$profile" CORE="$core" \
    DATA=64 LAYERS="$LAYERS" TREES="$trees" top >"$run/make.log" 2>&1 ||
    { cat "$run/make.log" >&2; exit 1; }
"$BUILD/sim/tb_frames-$name/tb_frames" "$LATENCY" "$STALL" "$SEED" \
    "${CHIP_BUILDS:-host}" "$run" "$@" \
    >"$run/checks" || { cat "$run/checks"; exit 1; }
[ -z "${MOVIE:-}" ] || "$tool" movie -o "$MOVIE" "$run"/shown-*.ppm >&2
python3 -m lab image-times "$run" "$CORE_MHZ"
cat "$run/checks"
python3 -m lab film-report "$run" "${REPEATED:-}"
echo "report in $run/"
