#!/bin/sh
# check.sh - values of variables against make/variables.mk, before anything is made
# SPDX-License-Identifier: Apache-2.0
#
# usage: NAME=value ... sim/check.sh [--given NAMES] [--goals GOALS] NAME...
# Says on stderr what is wrong with the values of these names in the environment, and which of
# --given, names of a command line, make does not know; with the nearest right word and the list.
# If sim is among the goals, as it is without --goals, the simulator has to be there. Exit code 2 if
# anything is wrong.
set -u
given='' goals=sim
while :; do
    case ${1:-} in
    --given) given=$2 ;;
    --goals) goals=$2 ;;
    *) break ;;
    esac
    shift 2
done
cd "$(dirname "$0")/.." || exit 2
profile=${PROFILE:-all}
case $profile in all | auto) profile=draft ;; esac # what all have is what the narrowest has
widths=$(sh sim/profile.sh "$profile" 2>/dev/null)
awk -v names="$*" -v given="$given" -v goals="$goals" -v widths="$widths" \
    -f sim/nearest.awk -f sim/rules.awk -f sim/check.awk \
    cmodel/machine/machine.def make/variables.mk || exit 2

# Parameters of a core that goes together, as far as they are known without its machine.
effects=${EFFECTS:-auto}
[ "$effects" != auto ] || effects=none
case " $* " in
*" ENGINES "* | *" PIPES "* | *" LEAF_UNITS "* | *" SHADES "* | *" SIZES "* | *" EFFECTS "* | \
    *" PROFILE "*) sh sim/key.sh "$profile" "$effects" >/dev/null || exit 2 ;;
esac

case " $goals " in
*" setup "*) ;;
*" sim "*)
    case $SIM in
    icarus) program=iverilog ;;
    cxxrtl | ecp5 | xc7) program=yosys ;;
    *) program=$SIM ;;
    esac
    command -v "$program" >/dev/null || {
        echo "SIM=$SIM: this simulator is not installed: make setup" >&2
        exit 2
    }
    ;;
esac
