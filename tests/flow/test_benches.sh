#!/bin/sh
# test_benches.sh - every block of the RTL against its model, tb/benches*.txt
# SPDX-License-Identifier: Apache-2.0
#
#   SEED=n  other vectors (1)
#   ALL=1   every profile and configuration; without it those that no other one stands for
cd "$(dirname "$0")/../.." || exit 1
BENCH_BUILD=${BUILD:-build} BENCH_JOBS=${JOBS:-2}
export BENCH_BUILD BENCH_JOBS
exec sh tb/run_bench.sh / "${SEED:-1}"
