#!/bin/sh
# test_effect_scenes.sh - a core with just what a scene asks for draws what the whole core draws
# SPDX-License-Identifier: Apache-2.0
#
# Every scene of scenes/effects/, listed with its options and what it asks for in effects.txt:
#   - build finds that list, and with everything forced on the model draws the same picture;
#   - cores elaborated for exactly that list, in Verilator (32x24) and in Icarus (4x3), and with
#     everything, in Verilator, equal the model bit for bit, with random latency and 30 % stalls;
#   - the two cores' frames are equal in every field, and in counters and error bits.
# Those that are listed as small or whole take smaller frames, and own cores in Icarus or none: a
# core of its own is the dearest part. The whole core is `all`, or with textures, refraction,
# highlights, sums, interpolated normals, clear materials and spread where the list has one; over a
# BIH there is no such core. Every way of background separation on one of scenes/views/ and in an
# oblique frustum (test_background.sh has more).
# Then machines that ask for more than a core was built with: each is refused, by name, without a
# pixel.
#   SEED=n          other latencies and stalls (1)
#   ALL=1           every pair of effects has a core of its own in Verilator too
#   EFFECT=pattern  only what has the pattern in its name
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
SEED=${SEED:-1}
BUILD=${BUILD:-build}
EFFECT=${EFFECT:-}
export BUILD OPT=-O0 JOBS=1
echo "# SEED=$SEED; one run again: SEED=$SEED EFFECT=NAME make test ONLY=test_effect_scenes"
here=$BUILD/test/effects
cases=$TMP/cases

# ---- what is drawn: NAME|SCENE|OPTIONS|LIST|RUNS|WHOLE ----
view_asks=shadow+reflect2+lights1+inside
whole_of() { # list: the core with everything that draws it, or nothing
    case $1 in
    *texture*bih | *sum*bih | *clear*bih) ;;
    *texture* | *sum* | *smooth* | *clear*)
        echo all+texture+refract+specular+sum+smooth+clear+spread
        ;;
    *) echo all ;;
    esac
}
{
    grep -v '^ *\(#\|$\)' scenes/effects/effects.txt | while read -r title kind options list; do
        [ "$options" != - ] || options=
        case $kind+${ALL:-} in
        pair+) kind=small ;;
        pair+*) kind=full ;;
        esac
        scene=${title%_bih}
        [ "$scene" != bih ] || scene=none
        echo "$title|scenes/effects/effects.nff:$scene|$(echo "$options" | tr , ' ')|$list|$kind|$(
            whole_of "$list")"
    done
    echo "first|scenes/effects/effects.nff:none|--traverse=first|first|full|all"
    for way in rect spans exact; do
        built=$way
        [ $way != exact ] || built=cones1
        echo "off_axis_$way|scenes/views/off_axis.nff|--background=$way|$view_asks+$built|full|all"
        built=${view_asks%+inside}+$built
        echo "oblique_$way|scenes/oblique.nff|--background=$way|$built|whole|all"
    done
} | grep -e "$EFFECT" >"$cases"

# Scene, size, machine, options: the command that builds it, over the tree that is listed.
build() {
    echo "$SPHAERA build $1 --effects all --profile draft --size $2 -o $3 $every $4"
}
rm -rf "$here"
mkdir -p "$here"
while IFS='|' read -r title scene options list kind whole; do
    large=32x24 little=4x3
    [ "$kind" = full ] || large=16x12
    more="$options --shadow=on --reflect=on --inside=on"
    case $options in *--traverse=first*) more="$more --interpenetrate=on" ;; esac
    echo "$(build "$scene" $large "$here/$title.sph" "$options") &&" \
        "$(build "$scene" $little "$here/$title-small.sph" "$options") &&" \
        "$(build "$scene" $large "$here/$title-forced.sph" "$more")"
done <"$cases" | two_at_a_time
asks_for() { # list, machine, log of build
    now=$(asked_for "$2")
    echo "asks for ${now#* }, listed is $1" | cat - "$3"
    [ "${now#* }" = "$1" ]
}
number=0
# simulator, core, machine's size, what is kept of the frames
draws() {
    run "$title: $1, core $2$3" "$2" "SIM=$1" "$machine$3.sph" \
        --frame "$machine$3-$1-$2.frame" --model-frame "$machine$3-$2.frame"
}
while IFS='|' read -r title scene options list kind whole; do
    number=$((number + 1))
    machine=$here/$title
    check "$title: asks for $list" asks_for "$list" "$machine.sph" "$TMP/$number.log"
    case $kind in
    full)
        draws verilator "$list" ""
        draws verilator "$whole" ""
        draws icarus "$list" -small
        ;;
    small) draws icarus "$list" -small ;;
    esac
    [ -n "$whole" ] || continue
    [ "$kind" = full ] || draws verilator "$whole" ""
    [ "$kind" != small ] || draws verilator "$whole" -small
    run "$title: verilator, core $whole, everything forced on" "$whole" SIM=verilator \
        "$machine-forced.sph" --model-frame "$machine-forced.frame"
done <"$cases"

# ---- more spheres of background separation than the whole core is built with ----
machine=$here/levels.sph
$(build scenes/views/centred.nff 8x6 "$machine" "--background=exact --bg-levels=1") >"$TMP/levels"
levels=$(asked_for "$machine" | cut -d' ' -f2)
run "levels: icarus, core $levels" "$levels" SIM=icarus "$machine"

# ---- a core without one effect draws what does not ask for it: the longest such list ----
all_but() { # name
    awk -F'|' -v but="$1" '$5 != "whole" && $6 == "all" && $4 !~ /bih/ {
        n = split($4, word, "+")
        for (i = 1; i <= n; i++) if (word[i] ~ "^" but "[0-9]*$") next
        if (n > most) { most = n; name = $1 }
    } END { print name }' "$cases"
}
for but in $(sim/cores.py parameters --names all); do
    title=$(all_but $but)
    [ -z "$title" ] || run "$title: icarus, core all-$but" all-$but SIM=icarus \
        "$here/$title-small.sph"
done

# ---- a reset of one clock in each clock of a frame: rays of one kind, one unit for them ----
machine=$here/cut.sph
$(build scenes/effects/effects.nff:none 6x4 "$machine" "") >"$TMP/cut"
run "none: verilator, cut off in each clock" none SIM=verilator "$machine" --life --latency 3

# ---- what is refused: core, what it lacks, registers EFFECTS MAX_DEPTH N_LIGHTS BG_MODE BG_COUNT
cat >"$TMP/refused" <<END
none|reflect1|2 1 0 0 0
none|reflect1|0 1 0 0 0
none|lights1|0 0 1 0 0
none|rect|0 0 0 1 0
none|spans|0 0 0 2 0
none|cones1|0 0 0 3 1
none|shadow, lights8 and rect|1 0 8 1 0
shadow+reflect2+lights1|reflect3|3 3 1 0 0
shadow+reflect2+lights1|reflect10|3 10 1 0 0
shadow+reflect2+lights1|lights2|3 2 2 0 0
shadow+reflect2+lights1|inside and spans|7 2 1 2 0
all|cones2|31 5 8 3 2
all|reflect6|31 6 8 3 1
all-shadow|shadow|31 5 8 1 0
all-reflect|reflect5|31 5 8 1 0
all-lights|lights8|31 5 8 1 0
all-inside|inside and interpenetrate|31 5 8 1 0
all-first|first and interpenetrate|31 5 8 1 0
all-interpenetrate|interpenetrate|31 5 8 1 0
all-facets|facets|39 5 8 1 0
all-rect|rect|31 5 8 1 0
all-spans|spans|31 5 8 2 0
all-cones|cones1|31 5 8 3 1
all|texture|95 5 8 3 1
all|refract, specular and sum|927 5 8 3 1
all|smooth|1055 5 8 3 1
all|clear|2079 5 8 3 1
all+texture|spread|8287 5 8 3 1
END
# each bit by itself, and the first that means nothing
python3 - >>"$TMP/refused" <<'END'
from sim.definition import Definition
machine = Definition()
for e in machine.effects.values():
    if e.bit is not None:
        print(f"none|{e.name}{'1' * (e.most > 1)}|{1 << e.bit} 0 0 0 0")
print(f"all||{1 << machine.bits} 0 0 0 0")
END
$(build scenes/one_sphere.nff 8x8 "$here/bare.sph" "") >"$TMP/bare" 2>&1 || cat "$TMP/bare"
refused() ( # simulator, core, words, registers
    # shellcheck disable=SC2086  # five numbers
    set -- "$1" "$2" "$3" $4
    command="env SIM=$1 EFFECTS=$2 sh sim/core.sh --machine $here/bare.sph"
    registers="--reg 0=$4 --reg 1=$5 --reg 2=$6 --reg 9=$7 --reg 98=$8"
    echo "$1|$2|$3|$command|$registers"
)
while IFS='|' read -r core words registers; do
    refused icarus "$core" "$words" "$registers"
    # one effect at a time: the small core and the whole one are enough
    case $core in all-*) ;; *) refused verilator "$core" "$words" "$registers" ;; esac
done <"$TMP/refused" | grep -e "$EFFECT" >"$TMP/refusals"

build_cores
cut -d'|' -f4 "$TMP/refusals" | sed 's/^/BUILT=tools /; s/$/ --info/' | sort -u | two_at_a_time
run_all
judge

# ---- exact and whole: the same in every field, forced on in every colour, id and key ----
while IFS='|' read -r title scene options list kind whole; do
    [ -n "$whole" ] || continue
    machine=$here/$title compare="$SPHAERA compare"
    case $kind in
    full)
        echo "$title: verilator, frames of cores $list and $whole are equal|$compare" \
            "$machine-verilator-$list.frame $machine-verilator-$whole.frame"
        ;;
    small)
        echo "$title: frames of cores $list in icarus and $whole in verilator are equal|$compare" \
            "$machine-small-icarus-$list.frame $machine-small-verilator-$whole.frame"
        ;;
    esac
    echo "$title: the model's frame with everything forced on is equal|$compare" \
        "--ignore-work $machine-$whole.frame $machine-forced.frame"
done <"$cases" >"$TMP/compares"
cut -d'|' -f2 "$TMP/compares" | two_at_a_time
number=0
while IFS='|' read -r title command; do
    number=$((number + 1))
    tap "$(cat "$TMP/$number.rc")" "$title" "$TMP/$number.log"
done <"$TMP/compares"

# ---- refused: by name, without a pixel, the error bit stays, and again when started again ----
while IFS='|' read -r sim core words command registers; do
    echo "$command $registers; [ \$? = 3 ] && $command $registers --warm --expect-errors 16"
done <"$TMP/refusals" | two_at_a_time
number=0
while IFS='|' read -r sim core words command registers; do
    number=$((number + 1))
    why="refused: the machine asks for $words, the core was built with $core"
    [ -n "$words" ] || why="refused: the core sets missing_effect and gives no pixel"
    [ "$(cat "$TMP/$number.rc")" = 0 ] &&
        [ "$(sort -u "$TMP/$number.log" | grep -c '^refused:')" = 1 ] &&
        grep -qFx "$why" "$TMP/$number.log" &&
        grep -q ': 64 pixels, 0 mismatches; cold caches: 0 cycles' "$TMP/$number.log" &&
            rc=0 || rc=1
    tap $rc "$sim, core $core refuses what asks for ${words:-an unknown effect}" "$TMP/$number.log"
done <"$TMP/refusals"
done_testing
