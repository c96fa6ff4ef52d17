#!/bin/sh
# test_hard_rtl.sh - faults in the RTL are noticed by the vectors of one named hard case each
# SPDX-License-Identifier: Apache-2.0
#   MUTANT=pattern  those whose name or judge has the pattern in it; ALL=1 all (`make hard-rtl`)
cd "$(dirname "$0")/../.." && exec python3 -m lab faults run --by case
