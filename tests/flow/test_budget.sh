#!/bin/sh
# test_budget.sh - cores for ecp5 stay within their budgets
# SPDX-License-Identifier: Apache-2.0
#
# Synthesises the standard core without any effect if a source changed, and shows that the check
# can fail: a budget that is one multiplier or one place short, or names what is not there, is
# noticed. Then: what a core is not built for is not in it, by the modules of the elaborated core.
#   ALL=1  the core with everything, one of profile reference, rt_boxes and blocks of rt_top (`make
#          budget`)
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
key=$(sim/cores.py key standard none ecp5)
run=$BUILD/synth/$key

if ! command -v yosys >"$TMP/yosys"; then
    echo "ok 1 - # SKIP no yosys"
    echo "1..1"
    exit 0
fi
held() { # profile, list, budget: synthesised; a line for each of the budget's modules
    check "synthesis of $1 with $2; no loop, no undriven net" \
        env -u MAKEFLAGS -u MFLAGS make -s -f make/area.mk results B="$BUILD" PROFILES="$1" \
        EFFECTS="$2"
    python3 -m lab budget "$BUILD/synth/$(sim/cores.py key "$1" "$2" ecp5)" "$3" |
        sed "s/ecp5/& $2:/" >>"$TMP/lines"
}
held standard none synth/budget_none.txt
[ -f "$run/stat.json" ] || {
    done_testing
    exit 1
}
if [ -n "${ALL:-}" ]; then
    held standard all synth/budget.txt
    held reference shadow+reflect2+lights3+inside synth/budget_reference.txt
    # shellcheck disable=SC2086  # options: none or some
    cat synth/budget_top.txt synth/budget_boxes.txt >"$TMP/modules"
    while read -r module most_mult most_places more; do
        case $module in rt_*) ;; *) continue ;; esac
        sh synth/module.sh "$module" $more | sed 's/^|[^|]*//; s/|//g' | {
            read -r mult lut _ _ dpr
            places=$((lut + 6 * dpr))
            fits="$module: $mult of $most_mult MULT18X18D, $places of $most_places LUT places"
            [ "${dpr:+$((mult <= most_mult && places <= most_places))}" = 1 ] &&
                echo "ok ecp5 - $fits" || echo "not ok ecp5 - $fits"
        } >>"$TMP/lines"
    done <"$TMP/modules"
fi
while read -r line; do
    case $line in ok*) rc=0 ;; *) rc=1 ;; esac
    echo "$line" >"$TMP/line"
    tap $rc "${line#*- }" "$TMP/line"
done <<END
$(cat "$TMP/lines")
END

budget() { python3 -m lab budget "$@"; }
over() { ! budget "$run" "$1" && [ "$2" = "$(budget "$run" "$1" | grep -c '^not ok')" ]; }
core=$(sed -n 's/.* none: rt_core: \([0-9]*\) of [0-9]* MULT18X18D, \([0-9]*\) of .*/\1 \2/p' \
    "$TMP/lines")
mult=${core% *} places=${core#* }
echo "rt_core $mult $places" >"$TMP/exact"
check "what the core takes is within a budget of just that" \
    python3 -m lab budget "$run" "$TMP/exact"
echo "rt_core $((mult - 1)) $places" >"$TMP/multiplier"
check "one multiplier too many is noticed" over "$TMP/multiplier" 1
echo "rt_core $mult $((places - 1))" >"$TMP/place"
check "one LUT place too many is noticed" over "$TMP/place" 1
echo "rt_nowhere 1 1" >"$TMP/nowhere"
check "a module that is gone is noticed" over "$TMP/nowhere" 1
check "no latch" sh -c "! grep '^Latch inferred' '$run/log'"
check "no memory but the block and distributed ones fell apart" sh -c \
    "! grep 'using FF mapping for memory' '$run/log'"
check "every rt_slot_ram is block RAM, every rt_slot_file distributed" python3 -c "
from lab.synth import results
m = results.read('$run')['modules']
ram, words = m['rt_slot_ram']['own'], m['rt_slot_file']['own']
print(ram, words)
assert ram['ff'] == 0 and ram['dpr'] == 0 and ram['bram'] >= m['rt_slot_ram']['instances']
assert words['ff'] == 0 and words['bram'] == 0 and words['dpr'] >= m['rt_slot_file']['instances']"

# ---- list of a core, modules that are in the whole core and must not be in this one ----
{
    sh synth/modules.sh all+texture
    sh synth/modules.sh all+texture+refract+specular+sum
} | sort -u >"$TMP/all"
absent() { # list, modules
    sh synth/modules.sh "$1" >"$TMP/here" || return 1
    printf '%s\n' $2 | sort >"$TMP/absent"
    echo "not in the whole core:" && ! comm -23 "$TMP/absent" "$TMP/all" | grep . || return 1
    echo "in the core $1:" && ! comm -12 "$TMP/absent" "$TMP/here" | grep .
}
lights='rt_lights rt_cosine rt_lambert rt_light_add'
mirrors='rt_mirrors rt_reflect rt_blend'
ways='rt_background rt_table rt_spans rt_cone'
point='rt_hit rt_normalise rt_quotient rt_quotient_pool'
texture='rt_texture rt_texture_path rt_texture_map rt_texture_image rt_texture_mix'
bend='rt_rays rt_refract'
shine='rt_specular_lights rt_specular rt_power_rom'
while IFS='|' read -r list modules; do
    check "core $list has no $modules" absent "$list" "$modules"
done <<END
all|$texture $bend $shine rt_shares rt_share
lights1+inside+refract|rt_blends rt_blend $shine
lights1+sum|rt_blends $mirrors $bend $shine
all-reflect|rt_blend
all-lights|$lights
all-inside|rt_interpenetrate
all-first|rt_interpenetrate
all-interpenetrate|rt_interpenetrate
all-facets|rt_facet rt_divide
all-spans|rt_spans
all-cones|rt_cone
lights1|$mirrors rt_interpenetrate $ways
reflect1|$lights rt_interpenetrate $ways
inside+first|$lights $mirrors rt_interpenetrate $point $ways
texture|$lights $mirrors rt_interpenetrate $ways
rect|$lights $mirrors rt_interpenetrate $point $ways
none|$lights $mirrors rt_interpenetrate $point $ways
END
noticed() { ! absent lights1 rt_lights && ! absent none rt_nowhere; }
check "a module that is there is noticed, and one that is gone for good" noticed
done_testing
