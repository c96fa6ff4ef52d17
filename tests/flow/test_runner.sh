#!/bin/sh
# test_runner.sh - tests/run.sh: a suite that hangs is ended with all that it started, and two calls
# for one build folder wait for each other
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
suites=$TMP/suites build=$TMP/b
mkdir "$suites"
# Seconds that nothing else sleeps: what still does was left.
left() { grep -lzx "$1" /proc/[0-9]*/cmdline 2>/dev/null; }
runs() { # variables, suites
    env -u TESTING -u SUITE_LIMIT -u ALL BUILD="$build" JOBS=4 "$@" >"$TMP/said" 2>&1
}

# ---- a limit ----
for how in plain grouped deaf; do
    case $how in
    plain) code='sleep 98761 & sleep 98761' ;;
    grouped) code='timeout 90000 sleep 98761 & timeout 90000 sleep 98761' ;; # groups of their own
    deaf) code='trap "" TERM; while :; do sleep 98761; done' ;;
    esac
    printf '%s\n' 'echo "ok 1 - before"' "$code" >"$suites/test_$how.sh"
done
echo 'echo "ok 1 - quick"; echo 1..1' >"$suites/test_quick.sh"
printf '%s\n' 'sleep 98762 &' 'echo "ok 1 - left"; echo 1..1' >"$suites/test_leaves.sh"
start=$(date +%s)
runs SUITE_LIMIT=1 sh tests/run.sh "$suites"/test_plain.sh "$suites/test_grouped.sh" \
    "$suites/test_quick.sh" "$suites/test_deaf.sh" "$suites/test_leaves.sh"
rc=$?
check "suites that hang fail" [ $rc -ne 0 ]
check "... soon" [ $(($(date +%s) - start)) -lt 30 ]
for how in plain grouped deaf; do
    check "... with name and limit: $how" grep \
        "FAILED test_$how.sh .* 1 failed; ended after SUITE_LIMIT=1 seconds" "$TMP/said"
done
check "others are run" grep "ok  *test_quick.sh  *1 passed" "$TMP/said"
check "all are counted" grep -x "5 passed, 3 failed" "$TMP/said"
check "nothing of them is left" [ -z "$(left 98761)" ]
check "nor of one that ended by itself" [ -z "$(left 98762)" ]
refused() {
    ! timeout 60 env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make "SUITE_LIMIT=$1" help \
        >"$TMP/said" 2>&1 && grep -- "^SUITE_LIMIT=$1: is not 1 and more" "$TMP/said"
}
for limit in 0 x -1; do
    check "SUITE_LIMIT=$limit is refused" refused "$limit"
done
(cd "$TMP" && sleep 98763) & # a process of that name is found at all
check "what is left would be seen" [ -n "$(sleep 0.2; left 98763)" ]
kill $!

# ---- a call that is ended ends its suites ----
echo 'sleep 98764' >"$suites/test_slow.sh"
BUILD=$build env -u TESTING setsid sh tests/run.sh "$suites/test_slow.sh" >"$TMP/said" 2>&1 &
for _ in 1 2 3 4 5 6 7 8 9 10; do
    [ -z "$(left 98764)" ] || break
    sleep 0.3
done
check "a suite is begun" [ -n "$(left 98764)" ]
kill -s TERM -- "-$!" # the group: make, this script and xargs are one when a user stops them
wait
sleep 0.3
check "a call that is ended leaves nothing" [ -z "$(left 98764)" ]

# ---- two calls ----
cat >"$suites/test_alone.sh" <<'END'
mkdir "$BUILD/alone" && echo "ok 1 - alone" || echo "not ok 1 - alone"
echo kept >"$TMP/mine"
sleep 1
[ "$(cat "$TMP/mine")" = kept ] && echo "ok 2 - its folder is its own" || echo "not ok 2 - folder"
rmdir "$BUILD/alone"
echo 1..2
END
twice() {
    runs sh tests/run.sh "$suites/test_alone.sh" &
    sleep 0.3
    env -u TESTING BUILD="$build" sh tests/run.sh "$suites/test_alone.sh" >"$TMP/second" 2>&1
    second=$?
    wait $! && [ $second = 0 ]
}
check "two calls for one folder pass" twice
check "... one after the other" grep "another make test runs in .*: waiting" "$TMP/second"
echo "BUILD=\$BUILD sh tests/run.sh $suites/test_quick.sh && echo 'ok 1 - inner'; echo 1..1" \
    >"$suites/test_inner.sh"
check "a suite may call it for its own folder" runs timeout 20 sh tests/run.sh \
    "$suites/test_inner.sh"
done_testing
