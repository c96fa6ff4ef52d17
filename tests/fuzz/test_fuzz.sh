#!/bin/sh
# test_fuzz.sh - every harness over its corpus and changes of it, readers sanitized by gcc and clang
# SPDX-License-Identifier: Apache-2.0
#
# SEED takes other changes. An input that fails is kept in build/fuzz/found. `make fuzz` is longer.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
fuzz=$BUILD/fuzz
mkdir -p "$fuzz/found" "$TMP/runs"
check "a corpus is made" sh tests/fuzz/corpus.sh "$SPHAERA" "$TMP/corpus"
run() { # harness, how, changes
    check "$1, $2" env FUZZ_TMP="$TMP/runs" "$fuzz/$2/fuzz_$1" \
        --root tests/fuzz --dict "tests/fuzz/words/$1.dict" --keep "$fuzz/found" \
        --seed "${SEED:-1}" --runs "$3" "$TMP/corpus/$1"
    sed 's/^/# /' "$TMP/out"
}
run nff gcc 400
run nff clang 200
run aff gcc 400
run aff clang 200
run pdb gcc 200
run pdb clang 100
if [ -x "$fuzz/gcc/fuzz_mesh" ]; then
    run mesh gcc 100
    run mesh clang 50
else
    echo "# meshes are skipped: built without assimp (make mesh-setup)"
fi
run machine gcc 800
run machine clang 400
run frame gcc 500
run frame clang 500
run options plain 3000
[ ! -x "$fuzz/plain/fuzz_image" ] || run image plain 60

# ---- what holds an input to be wrong does so ----
noticed() { # name, what is said, harness, file: it ends with an input that is kept
    env FUZZ_TMP="$TMP/runs" "$fuzz/plain/fuzz_$3" --root tests/fuzz --keep "$TMP/kept" "$4" \
        >"$TMP/out" 2>&1
    rc=$?
    [ "$rc" -ne 0 ] && grep -q "$2" "$TMP/out" && [ -n "$(ls "$TMP/kept")" ] && rc=0 || rc=1
    tap "$rc" "$1" "$TMP/out"
}
mkdir "$TMP/kept"
touch "$TMP/runs/left.1.tmp"
cp "$TMP"/corpus/machine/empty-bih "$TMP/machine"
noticed "a temporary file that is left" "left.1.tmp: is left" machine "$TMP/machine"
rm "$TMP/runs/left.1.tmp"
check "... and not when there is none" env FUZZ_TMP="$TMP/runs" "$fuzz/plain/fuzz_machine" \
    --root tests/fuzz --keep "$TMP/kept" "$TMP/machine"
done_testing
