# tap.sh - checks of shell suites, one TAP line each; sourced
# SPDX-License-Identifier: Apache-2.0
#
# check NAME COMMAND...    ok if the command succeeds; its output follows a failure
# fails CODE NAME COMMAND...  ok if it exits with CODE; says what it printed to stderr in $TMP/err
# done_testing             prints the plan; call it last
checks=0
tap() { # 0 or 1, name, file to show on failure
    checks=$((checks + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $checks - $2"
    else
        echo "not ok $checks - $2"
        sed 's/^/# /' "$3"
    fi
}
check() {
    name=$1
    shift
    "$@" >"$TMP/out" 2>&1 && rc=0 || rc=1
    tap "$rc" "$name" "$TMP/out"
}
fails() {
    want=$1 name=$2
    shift 2
    "$@" >"$TMP/out" 2>"$TMP/err" && rc=0 || rc=$?
    echo "exit code $rc, not $want" >>"$TMP/out"
    cat "$TMP/err" >>"$TMP/out"
    [ "$rc" -eq "$want" ] && grep -q '^sphaera' "$TMP/err" && rc=0 || rc=1
    tap "$rc" "$name" "$TMP/out"
}
done_testing() { echo "1..$checks"; }
