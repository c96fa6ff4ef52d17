#!/bin/sh
# test_common_mode.sh - faults in model and RTL alike are noticed by what shares no code with them
# SPDX-License-Identifier: Apache-2.0
#   MUTANT=pattern  those whose name or judge has the pattern in it; ALL=1 all (`make common-mode`)
cd "$(dirname "$0")/../.." && exec python3 -m lab faults run --by agree
