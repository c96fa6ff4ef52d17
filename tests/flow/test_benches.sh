#!/bin/sh
# test_benches.sh - every block of the RTL against its model, tb/benches.txt
# SPDX-License-Identifier: Apache-2.0
#
#   SEED=n       other vectors (1)
#   ALL=1        every profile and configuration; without it those that no other one stands for
#   BENCHES=...  those of tb/benches.txt by bench/profile (all)
# Each bench refuses a seed that is no number, by its name, and the first one all such words.
. "$(dirname "$0")/../numbers.sh"
cd "$(dirname "$0")/../.." || exit 1
BENCH_BUILD=${BUILD:-build} BENCH_JOBS=${JOBS:-2} BENCHES=${BENCHES:-/}
export BENCH_BUILD BENCH_JOBS
python3 -m lab benches "$BENCHES" "${SEED:-1}" && status=0 || status=1
python3 -m lab benches --show "$BENCHES" >"$TMP/benches"
while read -r profile _ bench _; do
    if refuses 2 "" "$BENCH_BUILD/tb/$bench-$profile/made/bench" >"$TMP/refused"; then
        echo "ok - $bench-$profile refuses a seed that is no number"
    else
        echo "not ok - $bench-$profile refuses a seed that is no number"
        sed 's/^/# /' "$TMP/refused"
        status=1
    fi
    no_numbers() { echo 4x; } # of the others one word does: all benches have one main()
done <"$TMP/benches"
exit $status
