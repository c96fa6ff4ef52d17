#!/bin/sh
# test_reset.sh - one clock of reset makes modules quiet, and a reset that is gone is noticed
# SPDX-License-Identifier: Apache-2.0
# `make formal` tries each module, and so does ALL=1 here.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
quiet() { python3 -m lab reset "$TMP/build" "$@"; }
if [ -n "${ALL:-}" ]; then
    check "each module is quiet after one clock of reset" quiet
else
    check "modules are quiet after one clock of reset" \
        quiet rt_slots rt_cache rt_video rt_traversal_stack
fi
done_testing
python3 -m lab faults run --by reset
