#!/bin/sh
# test_formal.sh - the quick proofs hold, and each fails on a fault put into what it proves
# SPDX-License-Identifier: Apache-2.0
# Proofs: formal/proofs.txt; faults: formal/faults.txt. `make formal` does the long ones too.
# Of the faults of a proof the first one; that the text of each stands in its file once is looked at
# for all.
#   ALL=1   all faults, also of proofs by CBMC if it is installed
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../edit.sh"
cd "$(dirname "$0")/../.." || exit 1

CBMC=$(command -v cbmc || command -v "$BUILD/cbmc/usr/bin/cbmc")
export CBMC

# ---- the sources as they are ----
BUILD=$TMP sh formal/prove.sh quick >"$TMP/quick" 2>&1
sed -n 's/^  PROVE //p' "$TMP/quick" >"$TMP/verdicts"
while IFS= read -r line; do
    [ "${line##*: }" = proved ] && rc=0 || rc=1
    tap $rc "$line" "$TMP/quick"
done <"$TMP/verdicts"
[ -s "$TMP/verdicts" ] || tap 1 "proofs are found" "$TMP/quick"

# ---- with a fault: built, but not proved ----
mkdir "$TMP/tree"
cp -r rtl cmodel formal "$TMP/tree/"
caught() {
    NEW=$TMP/new
    export FROM TO NEW
    edit "$TMP/tree/$file" || return
    BUILD=$TMP sh "$TMP/tree/formal/prove.sh" "=$proof"
    rc=$?
    cp "$file" "$TMP/tree/$file"
    [ $rc -eq 1 ]
}
fits() {
    NEW=$TMP/new
    export FROM TO NEW
    cp "$file" "$TMP/fits" && edit "$TMP/fits"
}
: >"$TMP/faulty"
while read -r key rest; do
    case $key in
    fault) fault=$rest ;;
    proof) proof=$rest ;;
    file) file=$rest ;;
    from) FROM=$rest ;;
    to)
        TO=$rest
        case $proof in bits_*) of_cbmc=1 ;; *) of_cbmc= ;; esac
        if [ -n "$of_cbmc" ]; then
            [ -n "${ALL:-}" ] && [ -n "$CBMC" ]
        else
            [ -n "${ALL:-}" ] || ! grep -qx "$proof" "$TMP/faulty"
        fi || {
            fits >"$TMP/out" 2>&1 || tap 1 "the text of $fault stands in its file once" "$TMP/out"
            continue
        }
        caught >"$TMP/out" 2>&1
        rc=$?
        how=$(sed -n 's/^  PROVE [^:]*: //p' "$TMP/out" | head -n 1)
        tap $rc "$fault: $proof $how" "$TMP/out"
        echo "$proof" >>"$TMP/faulty"
        ;;
    esac
done <formal/faults.txt
for proof in $(sed 's/:.*//' "$TMP/verdicts"); do
    grep -qx "$proof" "$TMP/faulty" || tap 1 "$proof has a fault that it fails on" "$TMP/quick"
done
done_testing
