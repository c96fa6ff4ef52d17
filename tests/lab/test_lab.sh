#!/bin/sh
# test_lab.sh - python3 -m lab: what its tables name is there, a wrong word is told
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
check "commands, steps of experiments, and their arguments" python3 -m lab.checks.command
check "files that commands make of others" python3 -m lab.checks.tasks "$TMP/tasks"
says() { # exit code, what is said, words
    want=$1 text=$2
    shift 2
    python3 -m lab "$@" >"$TMP/said" 2>&1
    rc=$?
    cat "$TMP/said"
    [ "$rc" = "$want" ] && grep -q -- "$text" "$TMP/said"
}
check "help of all" says 0 "^  moving " --help
check "without a word the same" says 1 "^  moving "
check "help of a command, with what its module says" says 0 "NAME.png and NAME.json" gallery --help
check "help of an experiment, with its steps" says 0 "moving:page docs/results/trees.md" \
    moving --help
check "no such command" says 1 "there is no command teas" teas
check "an argument too few" says 2 "required: PAGE" gallery "$TMP"
check "an argument too many" says 2 "unrecognized arguments: c" gallery a b c
check "no such option" says 2 "unrecognized arguments: --quick" pages --quick
check "no such step" says 2 "no step tea; there are measure, page" moving tea
check "a command's answer" says 0 "^--accel bih --max-prims 8$" tree-options bih8
done_testing
