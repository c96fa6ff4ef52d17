#!/bin/sh
# run.sh - runs suites that print TAP, counts their checks, ends with `N passed, M failed`
# SPDX-License-Identifier: Apache-2.0
#
# usage: [BUILD=build] [JOBS=1] [SUITE_LIMIT=seconds] tests/run.sh SUITE...
#        JOBS suites at once; logs in BUILD/test/log
# A check fails with a line `not ok ...`; one with `# SKIP` counts as neither. A suite that stops
# early (fewer checks than its plan `1..N`), exits non-zero without a failed check, or checks
# nothing is one failed check more; so is one that takes longer than SUITE_LIMIT, which is ended
# with all that it started, and a build that went wrong (UNBUILT set): what could be built is run
# all the same. A second call for one build folder waits for the first.
# Suites see the sources, $BUILD, $SPHAERA and $TMP, a folder of their own, by absolute names
# without blanks, quotes and the like: where the sources have such a name, through a link.
set -u

# Ends what is left of a session: all processes that a suite started, whatever groups they are in.
end_session() { # its number, signal
    # a process may have any name, between parentheses; its session is the fourth word behind
    sed -n 's/^\([0-9]*\) .*) [A-Z] \([0-9]* \)\{2\}\([0-9]*\) .*/\1 \3/p' /proc/[0-9]*/stat \
        2>/dev/null | while read -r pid session; do
        [ "$session" != "$1" ] || kill -s "$2" "$pid" 2>/dev/null
    done
}
# One suite: its log, its exit code, and a folder of its own in $TMP.
run_one() {
    name=$(basename "$1")
    TMP=$BUILD/test/tmp/$name
    export TMP
    start=$(date +%s)
    rm -rf "$TMP"
    mkdir -p "$TMP"
    case $1 in
    *.sh) set -- sh "$1" ;;
    */*) ;;
    *) set -- "./$1" ;;
    esac
    # the first process of a session of its own
    setsid timeout -k 5 "$SUITE_LIMIT" "$@" >"$log/$name.log" 2>&1 </dev/null &
    suite=$!
    trap 'end_session $suite TERM; rm -rf "$TMP"; exit 130' INT TERM HUP
    wait $suite
    rc=$?
    times >"$log/$name.cpu" # not in a subshell, which has no children
    end_session $suite KILL
    seconds=$(($(date +%s) - start))
    [ $seconds -lt "$SUITE_LIMIT" ] || case $rc in 124 | 137) rc=late ;; esac
    echo $rc >"$log/$name.rc"
    cpu=$(sed -n '2s/[ms]/ /gp' "$log/$name.cpu" |
        awk '{ printf "%.0f", 60 * ($1 + $3) + $2 + $4 }')
    echo "$seconds s, $cpu s of processor" >"$log/$name.time"
    rm -rf "$TMP"
}
if [ "${1:-}" = --one ]; then
    log=$BUILD/test/log
    run_one "$2"
    exit 0
fi

script=$(realpath -- "$0")
case $PWD in
*[!A-Za-z0-9_./+,@-]*)
    linked=$(mktemp -d) || exit 2
    trap 'rm -rf "$linked"' EXIT
    trap 'exit 130' INT TERM HUP
    ln -s "$PWD" "$linked/tree"
    cd "$linked/tree" || exit 2
    ;;
esac
BUILD=${BUILD:-build}
case $BUILD in /*) ;; *) BUILD=$PWD/$BUILD ;; esac
mkdir -p "$BUILD/test/log"
SPHAERA=$BUILD/sphaera
# ALL=1 leaves nothing out.
SUITE_LIMIT=${SUITE_LIMIT:-$([ -n "${ALL:-}" ] && echo 28800 || echo 3600)}
export BUILD SPHAERA SUITE_LIMIT CMOCKA_MESSAGE_OUTPUT=TAP
log=$BUILD/test/log
# A suite may call this script for its own folder.
if [ "${TESTING:-}" != "$BUILD" ]; then
    exec 9>"$BUILD/test/.lock"
    flock -n 9 || {
        echo "another make test runs in $BUILD: waiting until it is done" >&2
        flock 9
    }
    export TESTING="$BUILD"
fi

# Prints "passed failed skipped note" of a log.
count() {
    awk -v rc="$2" -v limit="$SUITE_LIMIT" '
        /^[ \t]*1\.\.[0-9]+/ { sub(/^[ \t]*1\.\./, ""); plan += $1 + 0 }
        /^[ \t]*(not )?ok .*# (SKIP|skip)/ { skipped++; next }
        /^[ \t]*ok( |$)/     { passed++ }
        /^[ \t]*not ok( |$)/ { failed++ }
        END {
            note = ""
            if (rc == "late") note = "ended after SUITE_LIMIT=" limit " seconds"
            else if (!(passed + failed + skipped)) note = "no check ran, exit code " rc
            else if (passed + failed + skipped < plan) note = "stopped early, exit code " rc
            else if (rc && !failed) note = "exit code " rc
            print passed + 0, failed + (note != ""), skipped + 0, note
        }' "$1"
}

for suite; do rm -f "$log/$(basename "$suite").rc"; done
[ $# -eq 0 ] || printf '%s\n' "$@" |
    xargs -P "${JOBS:-1}" -I SUITE sh "$script" --one SUITE 9>&-

passed=0
failed=0
if [ -n "${UNBUILT:-}" ]; then
    failed=1
    echo "  FAILED building what the tests need: see above"
fi
for suite; do
    name=$(basename "$suite")
    rc=$(cat "$log/$name.rc" 2>/dev/null || echo 127)
    [ -f "$log/$name.log" ] || : >"$log/$name.log"
    read -r p f k note <<END
$(count "$log/$name.log" "$rc")
END
    passed=$((passed + p))
    failed=$((failed + f))
    about="$p passed"
    [ "$k" -eq 0 ] || about="$about, $k skipped"
    about="$about, $(cat "$log/$name.time" 2>/dev/null)"
    if [ "$f" -eq 0 ]; then
        printf '  %-6s %-32s %s\n' ok "$name" "$about"
    else
        printf '  %-6s %-32s %s, %d failed; %s\n' FAILED "$name" "$about" "$f" "$note"
        tail -n 60 "$log/$name.log" | sed 's/^/    | /'
        echo "    repeat: make test ONLY=$name    log: build/test/log/$name.log"
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
