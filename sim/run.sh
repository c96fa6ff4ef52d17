#!/bin/sh
# run.sh - one run of `make render`, `sim`, `price` or `synth`, in a folder of its own
# SPDX-License-Identifier: Apache-2.0
#
# usage: NAME=value ... sim/run.sh [--folder] render|sim|silicon|price|core NAME...
#   NAME...  variables that shape the run; among them SCENE as sim/scene.py takes it, SEED and
#            BUILD_OPTIONS, of `sphaera build`, and for sim those of sim/core.sh and its options
# Also reads PROFILE, SIZE, SAMPLES; BUILD, the build folder, with the tool in it; CSV, a file to
# which sim appends a row; REPEATED, the command that repeats the run.
#
# The folder BUILD/out/SCENE-PROFILE-SIZE-DIGEST has these variables in its file key, and what the
# goal leaves: scene.sph and build.json; of render model.png, model.frame, model.json; of sim
# pictures, frames, report.json, report.html and log; of price price.json, price.html and its plots.
# `core` prints profile and core that the
# machine asks for.
# Everything is made anew each time, under a lock; BUILD/out/last is the folder of the last run.
# With --folder the name of the folder is printed, and nothing made.
set -euf
cd "$(dirname "$0")/.."
only_name=
[ "$1" != --folder ] || only_name=$1
[ -z "$only_name" ] || shift
goal=$1
shift
tool=$BUILD/sphaera
scene=$(sim/scene.py "$SCENE")
say() { [ "${V:-0}" = 1 ] || printf '  %-4s %s\n' "$@"; }

key() {
    printf 'goal=%s\nscene=%s\n' "$goal" "$scene"
    for variable; do
        [ "$variable" = SCENE ] || eval "printf '%s=%s\n' $variable \"\$$variable\""
    done
}
name=${scene#scenes/}
case $name in /*) name=${name##*/} ;; esac
name=$(printf '%s' "${name%.nff}" | sed 's/[^/]*\.nff://' | tr -c 'A-Za-z0-9._-' _)
digest=$(key "$@" | sha256sum | cut -c 1-8)
case $PROFILE in all | auto) ;; *) PROFILE=$(sim/cores.py profile "$PROFILE" name) ;; esac
folder=$name-$PROFILE-${SIZE:-file}-$digest
run=$BUILD/out/$folder
[ -z "$only_name" ] || {
    echo "$run"
    exit
}

mkdir -p "$run"
exec 9>"$run/.lock"
flock 9
if [ -f "$run/key" ] && ! key "$@" | cmp -s - "$run/key"; then
    echo "$run: belongs to another run, see its file key" >&2
    exit 1
fi
find "$run" -mindepth 1 ! -name .lock -delete
. sim/beside.sh
beside "$run/key"
key "$@" >"$new"
named "$run/key"
beside "$BUILD/out/last"
ln -s "$folder" "$new"
named "$BUILD/out/last"

if [ ! -f "$scene" ] && [ ! -f "${scene%:*}" ]; then
    made=$run/${scene%:*}-${scene#*:}-$SEED.nff
    "$tool" gen "$scene" --seed "$SEED" -o "$made" >"$run/gen.log"
    scene=$made
fi
if [ "$goal" = price ]; then
    [ "$MORE" = 0 ] || set -- --more
    [ "$MORE" = 1 ] || set --
    # shellcheck disable=SC2086  # a list of words on purpose
    "$tool" price "$scene" $BUILD_OPTIONS "$@" --json "$run/price.json" >"$run/price.log"
    BUILD=$BUILD python3 -m lab price "$run" "$scene" || exit 1
    exit
fi
# shellcheck disable=SC2086  # a list of words on purpose
"$tool" build "$scene" $BUILD_OPTIONS --json "$run/build.json" -o "$run/scene.sph" >"$run/build.log"
case $goal in
core)
    "$tool" info "$run/scene.sph" | sed -n 's/^profile *\([^ ]*\): .*/\1/p; s/^core *//p'
    exit
    ;;
render)
    set --
    [ "$LITERAL" = 0 ] || set -- --literal
    "$tool" render "$run/scene.sph" "$@" --samples "$SAMPLES" --frame "$run/model.frame" \
        --json "$run/model.json" -o "$run/model.png" >"$run/model.log"
    cat "$run/build.log" "$run/model.log"
    echo "picture $run/model.png"
    exit
    ;;
esac

say SIM "$name $PROFILE $SIZE in $SIM"
set -- --machine "$run/scene.sph" --latency "$LATENCY" --stall "$STALL" --seed "$SEED" \
    --memory "$MEMORY" --core-mhz "$CORE_MHZ" \
    --watchdog "$WATCHDOG" --progress --frame "$run/rtl.frame" --json "$run/report.json" \
    --model-frame "$run/model.frame" --clocks "$run/rtl.clocks"
[ -z "$WINDOW" ] || set -- "$@" --window "$(echo "$WINDOW" | awk -F , -v n="$SAMPLES" \
    '{ print $1 * n "," $2 * n "," $3 * n "," $4 * n }')" # in pixels of the frame
[ -z "$PIXEL" ] || set -- "$@" --pixel "$PIXEL"
[ "$LITERAL" = 0 ] || set -- "$@" --literal
[ "$WARM" = 0 ] || set -- "$@" --warm
[ "$WAVES" = 0 ] || set -- "$@" --trace "$run/core.fst"
[ "$goal" != silicon ] || set -- "$@" --toggles "$run/toggles"
rc=0
sh sim/core.sh "$@" >"$run/log" || rc=$?
cat "$run/log"
if [ "$goal" = silicon ]; then
    [ "$rc" = 0 ] || exit "$rc"
    python3 -m lab silicon "$run" "$(sh sim/core.sh --folder --machine "$run/scene.sph")" || exit 1
    exit
fi
[ -f "$run/rtl.frame" ] || exit "$rc"
"$BUILD/sim/pictures" "$run/model.frame" "$run/rtl.frame" "$run" "$SAMPLES"
printf '%s\n' "${REPEATED:-}" >"$run/command"
# What other profiles would cost, for the report, of a scene that is built at once.
if [ -n "$(find "$run/scene.sph" -size -256k)" ]; then
    # shellcheck disable=SC2086  # a list of words on purpose
    "$tool" price "$scene" $BUILD_OPTIONS --profile auto --pixels 8192 --json "$run/price.json" \
        >"$run/price.log" 2>&1 || find "$run" -name price.json -delete
fi
# A mismatch: its pixel alone once more, with a waveform, which the report links.
repeat=$(sed -n 's/^repeat: //p' "$run/log")
if [ "$rc" = 1 ] && [ "$SIM" = verilator ] && [ -n "$repeat" ]; then
    say WAVE pixel.fst
    sh -c "${repeat%pixel.fst}'$run/pixel.fst'" >"$run/pixel.log" 2>&1 || : # it fails again
fi
case ${CSV:-} in '' | /*) ;; *) CSV=${FROM:-.}/$CSV ;; esac
BUILD=$BUILD python3 -m lab report "$run" ${CSV:+--csv "$CSV"} || exit 1
echo "pictures and report in $run/"
sed -n '$s/^core \(.*mismatches\);.*/sim \1/p' "$run/log"
exit "$rc"
