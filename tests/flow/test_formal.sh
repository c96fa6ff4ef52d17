#!/bin/sh
# test_formal.sh - the quick proofs hold, and each fails on a fault put into what it proves
# SPDX-License-Identifier: Apache-2.0
# Proofs: formal/proofs.txt; faults: tests/faults. `make formal` does the long proofs too.
#   ALL=1   all faults, also of proofs by CBMC if it is installed
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1

BUILD=$TMP sh formal/prove.sh quick >"$TMP/quick" 2>&1
sed -n 's/^  PROVE //p' "$TMP/quick" >"$TMP/verdicts"
while IFS= read -r line; do
    [ "${line##*: }" = proved ] && rc=0 || rc=1
    tap $rc "$line" "$TMP/quick"
    grep -qE "^by +proof ${line%%:*}\$" tests/faults/*.txt ||
        tap 1 "${line%%:*} has a fault that it fails on" "$TMP/quick"
done <"$TMP/verdicts"
[ -s "$TMP/verdicts" ] || tap 1 "proofs are found" "$TMP/quick"
done_testing
python3 -m lab faults run --by proof
