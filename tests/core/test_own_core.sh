#!/bin/sh
# test_own_core.sh - a scene's own core is no slower than the core with everything
# SPDX-License-Identifier: Apache-2.0
#
# Every scene of scenes/, and those of scenes/effects/ whose own core test_effect_scenes.sh builds
# in Verilator too: the core with just what the scene asks for beside `all`, and what `all` lacks
# if the scene asks for that. The memory answers both alike. Pixels come back sooner where effects
# are left out, so slots fall into step in another way: that alone moves a frame by up to one
# percent.
#   ALL=1         every scene of scenes/effects/: fifty cores more
#   CORE=pattern  only scenes whose name has the pattern in it
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
start own_core
size=32x24

whole() { # own list: `all`, with what it lacks
    # shellcheck disable=SC2046  # a list of words on purpose
    printf '%s\n' $(echo "$1" | tr + ' ') | sed 's/[0-9]*$//' | sort >"$TMP/own"
    { sim/cores.py parameters --names all && echo none; } | sort | comm -23 "$TMP/own" - |
        sed '1s/^/+/' | paste -s -d + - | sed 's/^/all/'
}
for scene in scenes/*.nff $(sed -n 's|^scene |scenes/effects/effects.nff:|p' \
    scenes/effects/effects.nff); do
    name=${scene#scenes/} name=${name%.nff} options=
    case $name in *:*) name=effects/${name#*:} ;; esac
    case $name in *"$CORE"*) ;; *) continue ;; esac
    case $name in
    effects/*)
        # shellcheck disable=SC2046  # what is simulated, options
        set -- $(awk -v name="${name#*/}" '$1 == name { print $2, $3 }' scenes/effects/effects.txt)
        [ "$1" = full ] || [ -n "${ALL:-}" ] || continue
        [ "$2" = - ] || options=$(echo "$2" | tr , ' ')
        ;;
    esac
    title=$(echo "$name" | tr / _)
    # shellcheck disable=SC2086  # a list of words on purpose
    profile=draft
    [ "$name" != huge_tiny ] || profile=standard # draft cannot hold its far spheres
    machine "$title" "$scene" --profile $profile --size $size $options
    own=$(asked_for "$file" | cut -d' ' -f2)
    for list in "$own" "$(whole "$own")"; do
        run "$name: core $list" "$list" SIM=verilator "$file" --latency 20 --stall 0
        echo "$name" >>"$TMP/names"
    done
done
build_cores
run_all
judge

cycles() { sed -n 's/^core .* mismatches; cold caches: \([0-9]*\) cycles.*/\1/p' "$TMP/$1.log"; }
number=0
while read -r name; do
    number=$((number + 1))
    [ $((number % 2)) = 0 ] || continue
    own=$(cycles $((number - 1))) all=$(cycles $number)
    [ -n "$own" ] && [ -n "$all" ] && [ $((own * 1000)) -le $((all * 1010)) ] &&
        rc=0 || rc=1
    tap $rc "$name: $own cycles on its own core, $all on the whole one" "$TMP/$((number - 1)).log"
done <"$TMP/names"
done_testing
