#!/bin/sh
# test_host.sh - some of what a host may do to a core, at random, and clean frames behind it
# SPDX-License-Identifier: Apache-2.0
#
# A sample of `make host` in both simulators: tb/core/trials.h. In Icarus memories are not set and
# what goes with no valid is x; an x in what has a meaning fails.
#   SEED=n        other trials (1)
#   CORE=pattern  only the runs whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start host
small="--profile draft --size 3x2 --depth 1"
# shellcheck disable=SC2086  # a list of words on purpose
{
    machine paper5 scenes/paper5.nff $small
    machine balls tests/scenes/texture/balls.nff $small
    machine mixed tests/scenes/facets/mixed.nff $small
    machine optics tests/scenes/refraction/mixed.nff $small --depth 2
}
others() { for other; do printf ' --then %s' "$machines/$other.sph"; done; }
wanted "verilator everything" all+texture+refract+specular+sum+spread SIM=verilator balls --life \
    --trials 100 "$(others paper5 mixed optics)"
wanted "icarus paper5" auto SIM=icarus paper5 --life --trials 8

build_cores
run_all
judge

# What was met; a sample meets most kinds of events.
kinds() { # log
    n=$(grep -c '^met [1-9]' "$1")
    echo "# $n kinds of events"
    [ "$n" -ge 40 ]
}
[ -n "$CORE" ] || check "trials of many kinds" kinds "$TMP/1.log"
done_testing
