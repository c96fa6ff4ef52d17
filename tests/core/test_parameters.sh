#!/bin/sh
# test_parameters.sh - the core is elaborated at the ends of each parameter, and refused beyond them
# SPDX-License-Identifier: Apache-2.0
#
# Legal values are those of machine.def. What lies one beyond is refused by Verilator, Icarus and
# Yosys alike, with the name of a module that does not exist and says what is legal. Every parameter
# is wrong at once in one elaboration of each tool; alone it is tried in Icarus, which is fast.
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
folders=$(find rtl -name '*.v*' -exec dirname {} + | sort -u)
include=$(echo "$folders" | sed 's/^/-I/')
library="$include $(echo "$folders" | sed 's/^/-y /')"
core=$(find rtl -name rt_core.v)
verilator="$(sh sim/allocator.sh) verilator"
# Standard widths; one line a value: NAME low|high|odd|least|most VALUE MESSAGE
python3 - >"$TMP/values" <<'END'
from sim.definition import Definition
machine = Definition()
standard = machine.profiles["standard"]


def number_of(text):
    return sum(standard.get(word.lower()) or int(word) for word in str(text).split("+"))


def values(name, least, most, power=False):
    message = f"{name}_must_be_{'a_power_of_two_from_' * power}{least}_to_{most}"
    top = number_of(most)
    for case, value in (("low", int(least) - 1), ("high", 2 * top if power else top + 1),
                        *[("odd", top - 1)] * power, ("least", least), ("most", top)):
        print(name, case, value, message.replace("+", "_plus_"))


for name, ends in machine.bounds.items():
    values(name.upper(), *ends)
for e in machine.effects.values():
    values(e.core, 0, e.most)
for size in machine.sizes.values():
    values(size.name, size.least, size.most, size.power)
END
# rt_core with some values: whole, or alone, when all other modules are missing
# shellcheck disable=SC2046,SC2086  # lists of words on purpose
elaborate() { # icarus|verilator|yosys, alone|whole, NAME=VALUE...
    tool=$1 from=$library sources=$(find rtl -name '*.v' | tr '\n' ' ') how='-check -top rt_core'
    [ "$2" = whole ] || from=$include sources=$core \
        how='-top rt_core; select -write /dev/stdout t:*'
    shift 2
    case $tool in
    icarus) iverilog -g2005 -Wall -t null $from $(printf ' -Prt_core.%s' "$@") -s rt_core $core ;;
    verilator)
        $verilator --lint-only -Wall --error-limit 400 --language 1364-2005 $from \
            $(printf ' -G%s' "$@") --top-module rt_core $core
        ;;
    yosys)
        yosys -q -e '.*' -p "read_verilog $(echo $include) $sources
            chparam $(printf ' -set %s' "$@" | sed "s/=-1/ 32'hffffffff/g; s/=/ /g") rt_core
            hierarchy $how"
        ;;
    esac 2>&1
}
silent() { elaborate "$@" >"$TMP/said" && ! grep . "$TMP/said"; }
says() { # message, what elaborate takes: it stops, and says so
    message=$1
    shift
    ! elaborate "$@" >"$TMP/said" && grep -q "rt_core_$message\b" "$TMP/said" && return
    echo "not said: rt_core_$message"
    cat "$TMP/said"
    return 1
}

# ---- legal: each alone in Icarus, all together in every tool ----
alone() { # no check speaks; that other modules are missing is what `alone` means
    elaborate icarus alone "$@" >"$TMP/said"
    ! grep -E '_must_be_|_needs_|_excludes_' "$TMP/said"
}
each_alone() {
    while read -r parameter kind value _; do
        case $kind:$parameter=$value in # what goes with it
        least:W=*) with="FW=$value" ;;
        most:W=*) with="WD=25 PQ=28" ;;
        least:WD=*) with="W=8 FW=8" ;;
        most:WD=*) with="PQ=31" ;;
        least:PQ=*) with="W=14 WD=21 NG=0" ;;
        most:PR=*) with="W=21 WD=31 PQ=31" ;;
        least:FIRST=* | least:INSIDE=*) with="INTERPENETRATE=0" ;;
        most:SPECULAR=*) with="SUM=1" ;;
        most:COARSE=* | most:SPREAD=*) with="TEXTURE=1" ;;
        most:ACCEL=* | most:BOXES=*) with="FIRST=0 INTERPENETRATE=0" ;;
        most:LEAF_UNITS=*) with="PIPES=4 SHADES=4 INTERPENETRATE=0" ;;
        most:SHADES=*) with="PIPES=4 INTERPENETRATE=0" ;;
        most:SETUPS=*) with="PIPES=4 LEAF_UNITS=4 SHADES=4 INTERPENETRATE=0" ;;
        least:* | most:*) with= ;;
        *) continue ;;
        esac
        # shellcheck disable=SC2086  # words
        alone $with "$parameter=$value" || return 1
    done <"$TMP/values"
}
check "legal: each parameter's ends, alone" each_alone
# NAME=VALUE of one kind, but for some names
all_of() { awk -v kind="$1" -v but="^($2)$" '$2 == kind && $1 !~ but { print $1 "=" $3 }' \
    "$TMP/values"; }
# The ends of widths contradict each other; many engines are elaborated by the fastest tool alone.
widths='W|WD|PQ|NG|FW|PR'
# shellcheck disable=SC2046  # words
for tool in icarus verilator yosys; do
    check "legal: all least, $tool" silent $tool whole $(all_of least "$widths")
    few="$widths|ACCEL|BOXES|PIPES|LEAF_UNITS|SHADES|SETUPS"
    [ $tool = icarus ] || few="$few|ENGINES|SLOTS|ROOTS|QUOTIENTS|CONES"
    check "legal: all largest, $tool" silent $tool whole $(all_of most "$few")
done

# ---- one beyond: all together in every tool, each alone in Icarus; steps follow widths ----
# shellcheck disable=SC2046  # words
for tool in icarus verilator yosys; do
    for kind in low high odd; do
        all_say() { # each that lies beyond is named
            elaborate $tool alone $(all_of $kind '.*_STEP') >"$TMP/said"
            awk -v kind=$kind '$2 == kind && $1 !~ /_STEP$/ { print "rt_core_" $4 }' \
                "$TMP/values" >"$TMP/wanted"
            while read -r message; do
                grep -q "$message\b" "$TMP/said" || { echo "not said: $message" && return 1; }
            done <"$TMP/wanted"
        }
        check "one beyond, all $kind, $tool" all_say
    done
done
each_beyond() {
    while read -r parameter kind value message; do
        case $kind in low | high | odd) ;; *) continue ;; esac
        says "$message" icarus alone "$parameter=$value" || return 1
    done <"$TMP/values"
}
check "one beyond: each alone" each_beyond
while read -r message values; do
    # shellcheck disable=SC2086  # words
    check "what does not go together: $message" says "$message" icarus alone $values
done <<'END'
WD_must_be_above_W WD=16
FW_must_be_at_most_W W=12
3W_plus_2WD_must_be_at_most_126 W=24 WD=28 PQ=28
PQ_plus_WD_must_be_at_most_62 PQ=32 WD=31
PQ_plus_WD_must_be_at_least_W_plus_NG_plus_5 PQ=5
PR_must_be_0_or_4_to_W_plus_WD_minus_1 PR=3
PR_must_be_0_or_4_to_W_plus_WD_minus_1 PR=33
INTERPENETRATE_needs_INSIDE INSIDE=0
INTERPENETRATE_needs_FIRST FIRST=0
REFRACT_needs_INSIDE REFRACT=1 INTERPENETRATE=0 INSIDE=0
SPECULAR_needs_SUM SPECULAR=1
COARSE_needs_TEXTURE COARSE=1
ACCEL_excludes_FIRST ACCEL=1
SETUPS_must_be_at_most_LEAF_UNITS SETUPS=2
ENGINES_times_PIPES_must_be_at_most_8 ENGINES=3 PIPES=3
LEAF_UNITS_and_SHADES_must_be_powers_of_two PIPES=4 LEAF_UNITS=3 SHADES=4 INTERPENETRATE=0
LEAF_UNITS_must_be_at_most_SHADES PIPES=4 LEAF_UNITS=4 SHADES=2 INTERPENETRATE=0
SHADES_must_be_at_most_PIPES PIPES=1 SHADES=2 INTERPENETRATE=0
INTERPENETRATE_needs_SHADES_to_be_1 PIPES=2 SHADES=2
MEM_PENDING_must_be_0_or_16_and_more MEM_PENDING=8
END
check "legal: four pipes" silent icarus whole PIPES=4 LEAF_UNITS=4 SHADES=4 INTERPENETRATE=0

# ---- the whole core is refused, by every tool ----
for tool in icarus verilator yosys; do
    for case in ENGINES=0 ENGINES=9 PIPES=5 SLOTS=48 NODE_LINES=100 LIGHTS=12; do
        message=$(awk -v name="${case%=*}" '$1 == name { print $4; exit }' "$TMP/values")
        check "refused by $tool: $case" says "$message" $tool whole $case
    done
done
done_testing
