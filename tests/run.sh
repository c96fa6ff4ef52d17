#!/bin/sh
# run.sh - runs suites that print TAP, counts their checks, ends with `N passed, M failed`
# SPDX-License-Identifier: Apache-2.0
#
# usage: tests/run.sh SUITE...        JOBS suites at once; logs in $BUILD/test/log
# A check fails with a line `not ok ...`; one with `# SKIP` counts as neither. A suite that stops
# early (fewer checks than its plan `1..N`), exits non-zero without a failed check, or checks
# nothing is one failed check more; so is a build that went wrong (UNBUILT set): what could be built
# is run all the same.
set -u

BUILD=${BUILD:-$(pwd)/build}
export BUILD CMOCKA_MESSAGE_OUTPUT=TAP
log=$BUILD/test/log
mkdir -p "$log"

# One suite: its log, its exit code, and a folder of its own in $TMP.
run_one() {
    name=$(basename "$1")
    TMP=$BUILD/test/tmp/$name
    export TMP
    start=$(date +%s)
    rm -rf "$TMP"
    mkdir -p "$TMP"
    case $1 in
    *.sh) sh "$1" ;;
    */*) "$1" ;;
    *) "./$1" ;;
    esac >"$log/$name.log" 2>&1 </dev/null
    echo $? >"$log/$name.rc"
    times >"$log/$name.cpu" # not in a subshell, which has no children
    cpu=$(sed -n '2s/[ms]/ /gp' "$log/$name.cpu" |
        awk '{ printf "%.0f", 60 * ($1 + $3) + $2 + $4 }')
    echo "$(($(date +%s) - start)) s, $cpu s of processor" >"$log/$name.time"
    rm -rf "$TMP"
}
if [ "${1:-}" = --one ]; then
    run_one "$2"
    exit 0
fi

# Prints "passed failed skipped note" of a log.
count() {
    awk -v rc="$2" '
        /^[ \t]*1\.\.[0-9]+/ { sub(/^[ \t]*1\.\./, ""); plan += $1 + 0 }
        /^[ \t]*(not )?ok .*# (SKIP|skip)/ { skipped++; next }
        /^[ \t]*ok( |$)/     { passed++ }
        /^[ \t]*not ok( |$)/ { failed++ }
        END {
            note = ""
            if (!(passed + failed + skipped)) note = "no check ran, exit code " rc
            else if (passed + failed + skipped < plan) note = "stopped early, exit code " rc
            else if (rc && !failed) note = "exit code " rc
            print passed + 0, failed + (note != ""), skipped + 0, note
        }' "$1"
}

for suite; do rm -f "$log/$(basename "$suite").rc"; done
[ $# -eq 0 ] || printf '%s\n' "$@" | xargs -P "${JOBS:-1}" -I SUITE sh "$0" --one SUITE

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
