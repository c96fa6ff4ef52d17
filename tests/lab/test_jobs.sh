#!/bin/sh
# test_jobs.sh - lists of jobs: chunks, rounds of the slurm engine without Slurm; make slurm-test
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
check "chunks; what is lost or damaged is made again; what cannot be made ends it" \
    python3 -m lab.checks.slurm "$TMP/squares"
says() { # pattern, command that fails
    pattern=$1
    shift
    ! "$@" >"$TMP/said" 2>&1 && cat "$TMP/said" && grep -q -- "$pattern" "$TMP/said"
}
check "an engine that is none" says 'ENGINE=slum: is none of make, slurm; is slurm meant' \
    env -u MAKEFLAGS -u MFLAGS make study ENGINE=slum
done_testing
