#!/bin/sh
# fuzz.sh - harnesses for some minutes each; what they find is kept, and the runs are counted
# SPDX-License-Identifier: Apache-2.0
#
# usage: BUILD=... SEED=n MINUTES=n [INPUTS=n] tests/fuzz/fuzz.sh afl|plain NAME...
# afl: AFL++, guided by coverage; plain: the driver of the tree, which is not. Then the inputs that
# AFL++ kept, or the driver's first changes, run under the sanitizers of gcc and clang. What AFL++
# has not run of INPUTS the driver runs, as changes of the inputs that AFL++ kept, with a seed for
# each million. A row of BUILD/fuzz/runs.tsv says what was done: day, harness, how, seed, minutes,
# runs, inputs that were kept, failures, digest of sources. Failing inputs are in BUILD/fuzz/found.
# Exit code 1 if there are any.
set -u
how=$1
shift
cd "$(dirname "$0")/../.." || exit 2
fuzz=$BUILD/fuzz found=$BUILD/fuzz/found
PART=1000000
shm=/dev/shm
[ -w $shm ] || shm=$fuzz
work=$(mktemp -d "$shm/sphaera-fuzz.XXXXXX") || exit 2
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
mkdir -p "$found" "$work/tmp" "$work/out"
sh tests/fuzz/corpus.sh "$BUILD/sphaera" "$work/corpus" || exit 2
[ "$how" = afl ] || echo "AFL++ is not installed (make fuzz-setup): changes are not guided" >&2
failed=0

# Of the model and of what runs it for a harness: sources that count for its row.
sources() {
    python3 -c 'import sys; from lab.jobs.store import digest; print(digest(sys.argv[1:])[:8])' \
        'cmodel/**/*.[ch]*' 'cmodel/**/*.def' "tests/fuzz/harness_$1.c" tests/fuzz/afl.c \
        tests/fuzz/common.c tests/fuzz/driver.c tests/fuzz/scene.c
}

# What afl-fuzz says of itself: a field of its statistics.
field() { sed -n "s/^$1 *: *//p" "$work/out/$2/default/fuzzer_stats"; }

alone() { # harness, input: within the driver's limit of a processor's time
    FUZZ_TMP=$work/tmp "$fuzz/plain/fuzz_$1" --root tests/fuzz --keep "$found" "$2" \
        >>"$work/log" 2>&1
}

# OpenImageIO leaks (harness_image.c): a leak is known by all calls above it, not by the last ones.
sanitized() { # harness, inputs: those that end the program are named in $work/log
    for by in gcc clang; do
        ASAN_OPTIONS=$([ "$1" != image ] || echo fast_unwind_on_malloc=0) FUZZ_TMP=$work/tmp \
            "$fuzz/$by/fuzz_$1" --root tests/fuzz --dict "tests/fuzz/words/$1.dict" \
            --keep "$found" --seed "$SEED" --runs 1000 "$2" >>"$work/log" 2>&1 &&
            ! grep -q '^not ok' "$work/log" || bad=$((bad + 1))
    done
}

# The driver over the inputs of a folder; sets runs.
plain() { # harness, folder, --seconds or --runs, how many
    FUZZ_TMP=$work/tmp "$fuzz/plain/fuzz_$1" --root tests/fuzz --dict "tests/fuzz/words/$1.dict" \
        --keep "$found" --seed "$seed" "$3" "$4" "$2" 2>&1 >"$work/log" |
        grep -a '^fuzz: ' >"$work/said"
    grep -q '^ok' "$work/log" || bad=1
    cat "$work/said" >>"$work/log"
    runs=$(sed -n 's/.* as they are, \([0-9]*\) changed.*/\1/p' "$work/log")
}

row() { # harness, how, minutes
    grep -a '^fuzz: \|ERROR\|runtime error' "$work/log" | head -n 9
    row=$(printf '%s\t' "$(date -u +%F)" "$1" "$2" "$seed" "$3" "${runs:-0}" "$kept" "$bad")
    echo "$row$digest" >>"$fuzz/runs.tsv" # at once: others may add theirs
    echo "$1: ${runs:-0} runs in $3 min by $2, $kept inputs kept, $bad failures"
    [ "$bad" -eq 0 ] || failed=1
}

for name; do
    bad=0 kept=0 seed=$SEED
    digest=$(sources "$name") || exit 2
    : >"$work/log"
    dict=tests/fuzz/words/$name.dict
    if [ "$how" = afl ]; then
        AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 \
            AFL_FAST_CAL=1 AFL_DISABLE_TRIM=1 FUZZ_TMP=$work/tmp \
            afl-fuzz -i "$work/corpus/$name" -o "$work/out/$name" -x "$dict" -s "$SEED" \
            -V "$(awk -v m="$MINUTES" 'BEGIN { printf "%d", 60 * m }')" -m 1024 -t 2000 \
            -- "$fuzz/afl/fuzz_$name" tests/fuzz >"$work/afl.log" 2>&1 ||
            { tail -n 20 "$work/afl.log" >&2; exit 2; }
        runs=$(field execs_done "$name")
        for input in "$work/out/$name/default/crashes/id"* "$work/out/$name/default/hangs/id"*; do
            [ -f "$input" ] || continue
            case $input in # on a busy machine what is quick takes long: once more
            */hangs/*) alone "$name" "$input" && continue ;;
            esac
            cp "$input" "$found/fuzz_$name-$(sha256sum <"$input" | cut -c 1-16)"
            bad=$((bad + 1))
        done
        kept=$(find "$work/out/$name/default/queue" -maxdepth 1 -type f | wc -l)
        sanitized "$name" "$work/out/$name/default/queue"
    else
        plain "$name" "$work/corpus/$name" --seconds $((MINUTES * 60))
        sanitized "$name" "$work/corpus/$name"
    fi
    row "$name" "$how" "$MINUTES"
    [ "$how" = afl ] || continue
    left=$((${INPUTS:-0} - ${runs:-0})) kept=0
    while [ "$left" -gt 0 ] && [ "$bad" -eq 0 ]; do # a row for each million: time may end at once
        from=$(date +%s)
        plain "$name" "$work/out/$name/default/queue" --runs $((left < PART ? left : PART))
        row "$name" plain $((($(date +%s) - from + 30) / 60))
        left=$((left - PART)) seed=$((seed + 1))
    done
done
exit $failed
