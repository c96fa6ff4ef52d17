#!/bin/sh
# test_mutants.sh - faults in the RTL are noticed by frames of the core, benches, rt_top's driver
# SPDX-License-Identifier: Apache-2.0
#   MUTANT=pattern  those whose name or judge has the pattern in it; ALL=1 all (`make mutants`)
cd "$(dirname "$0")/../.." && exec python3 -m lab faults run --by core,bench,top,crossings
