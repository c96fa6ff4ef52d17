#!/bin/sh
# test_parts.sh - an effect more is one line of machine.def, a primitive more six files of the model
# SPDX-License-Identifier: Apache-2.0
#
# In a copy of the tree a line of machine.def names the effect `dummy`; `make layout` does the rest.
# Then the first six steps of docs/design/extending.md are done: the primitive `wedge` is a
# triangle under another name, so it draws what triangles draw. The copy's tool is compiled once,
# without optimisation; the core is elaborated, not simulated.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/tap.sh
export CCACHE_BASEDIR="$PWD"
copy=$TMP/copy
mkdir -p "$copy" && cp -r Makefile VERSION sphaera.core README.md CONTRIBUTING.md \
    cmodel docs driver formal lab make rtl scenes sim synth tb tests "$copy" || exit 1
cd "$copy" || exit 1
def=cmodel/machine/machine.def
line="effect dummy most=3 bit=$(python3 -c 'from sim.definition import Definition
print(Definition().bits)') option=when needs=inside : does nothing"
find . -type f ! -name '*.pyc' | sort | xargs cksum >"$TMP/before"
awk -v line="$line" '$1 == "part" && !done { print line; done = 1 } 1' $def >"$TMP/def"
cp "$TMP/def" $def
make layout >"$TMP/layout" 2>&1 || cat "$TMP/layout"

# ---- what differs: machine.def, which was edited, and what make layout wrote ----
find . -type f ! -name '*.pyc' | sort | xargs cksum | diff "$TMP/before" - |
    sed -n 's/^> .* //p' >"$TMP/changed"
generated() {
    printf './%s\n' $def cmodel/machine/layout.h rtl/core/rt_core_rules.vh rtl/core/rt_effects.vh \
        rtl/core/rt_effects_pass.vh rtl/core/rt_layout.vh docs/reference/rt_top.rdl | sort |
        diff - "$TMP/changed"
}
check "one line of machine.def changes what is generated and nothing else" generated
check "layout.h has bit, entry and mask" \
    grep -c 'SPH_EFFECT_DUMMY \|X(DUMMY, dummy, "DUMMY"' cmodel/machine/layout.h
check "rt_core has its parameter" grep 'parameter DUMMY  *= 3,  *// 0..3: does nothing' \
    rtl/core/rt_effects.vh
check "make layout once more writes nothing" \
    sh -c 'touch "$1"; make layout; ! find . -newer "$1" -name "*.vh" | grep .' - "$TMP/stamp"

# ---- names of cores ----
has() { sim/cores.py parameters "$1" | grep -q "\\bDUMMY=$2\\b"; }
check "parameters: all" has all 3
check "parameters: none" has none 0
check "parameters: all-dummy" has all-dummy 0
check "parameters: a count" has inside+dummy2 2
check "parameters: all-inside leaves it out too" has all-inside 0
refuses() { ! sim/cores.py parameters "$1" 2>"$TMP/why" && cat "$TMP/why" &&
    grep -q "$2" "$TMP/why"; }
check "parameters: a count that is too large" refuses inside+dummy4 'dummy4 names nothing'
check "parameters: what it needs" refuses dummy1 'dummy1: dummy needs inside'
says() { grep -q -e "$1" "$2" || { cat "$2" && false; }; }
make help-all >"$TMP/help" 2>&1
check "make help-all names it" says dummyN "$TMP/help"

python3 -m lab pages docs/reference/core.md >"$TMP/pages" 2>&1 || cat "$TMP/pages"
check "the page of the core has it" says \
    '^- `dummy`, `DUMMY` = 3 (0..3, bit [0-9]*): does nothing' docs/reference/core.md
check "... once" sh -c '[ "$(grep -c DUMMY docs/reference/core.md)" = 1 ]'

# ---- the core elaborates with it and without, silently ----
elaborate() { # list
    parameters=$(sim/cores.py parameters "$1") || return 1
    # shellcheck disable=SC2046,SC2086  # words
    set -- $(printf ' -Ptb_core_icarus.%s' $parameters) \
        $(find rtl -name '*.vh' -exec dirname {} + | sort -u | sed 's/^/-I/') \
        $(find rtl -name '*.v') -Itb/core tb/core/tb_core_icarus.v
    iverilog -g2005 -Wall -t null -s tb_core_icarus "$@" >"$TMP/log" 2>&1 && [ ! -s "$TMP/log" ] ||
        { cat "$TMP/log" && false; }
}
check "Icarus elaborates a core with it" elaborate inside+dummy2
check "Icarus elaborates a core without" elaborate none

# ---- a counter more: a line each in two definitions, and what drives its event ----
find . -type f | sort | xargs cksum >"$TMP/before"
next=$(awk '$1 == "counter" { n = $2 } END { print n + 1 }' $def)
sed -i "s/^counter $((next - 1)) .*/&\ncounter $next DUMMIES both pixels/" $def
printf 'field  DUMMY  1  counter DUMMIES if REFRACT\n' >>rtl/engine/bundles.def
sed -i 's/^    assign event_o\[`RT_SHADE_EVENT_SHADOW\].*/&\
    assign event_o[`RT_SHADE_EVENT_DUMMY] = end_valid_o;/' rtl/shade/rt_shade.v
make layout >"$TMP/layout" 2>&1 || cat "$TMP/layout"
find . -type f | sort | xargs cksum | diff "$TMP/before" - | sed -n 's/^> .* //p' >"$TMP/changed"
counted() {
    printf './%s\n' $def cmodel/machine/layout.h rtl/core/rt_layout.vh rtl/engine/bundles.def \
        rtl/engine/rt_bundles.vh rtl/shade/rt_shade.v rtl/shade/rt_shades.v rtl/engine/rt_engine.v \
        tb/bundles.h driver/sphaera_regs.h docs/reference/rt_top.rdl | sort |
        diff - "$TMP/changed"
}
check "three edits by hand add a counter, the rest is generated" counted
check "the core adds it up" grep 'REFRACT != 0.*RT_COUNT_DUMMIES' rtl/engine/rt_bundles.vh
check "Icarus elaborates a core that counts it" elaborate inside+refract
check "Icarus elaborates a core that does not" elaborate none

# ---- the page names at most ten files, and lines that are there ----
page=docs/design/extending.md
sed -n 's/^| [^|]* | `\([^`]*\)` | `\(.*\)` |$/\1|\2/p' $page >"$TMP/steps"
ten() { cut -d'|' -f1 "$TMP/steps" | sort -u >"$TMP/ten" && cat "$TMP/ten" &&
    [ "$(wc -l <"$TMP/ten")" -le 10 ] && [ "$(wc -l <"$TMP/steps")" -ge 9 ]; }
check "the page of a primitive names at most ten files" ten
there() { # file as the page has it, line
    case $1 in *tb_NAME* | *rt_NAME*) has=facet ;; *) has=triangle ;; esac
    has=$(echo "$1" | sed "s/NAME/$has/")
    grep -F -e "$2" "$has" || { echo "$has has no line with $2" && false; }
}
while IFS='|' read -r file text; do
    check "... of $file a line that is there" there "$file" "$text"
done <"$TMP/steps"
named() { ! git -C "$OLDPWD" grep -nE '[!=]= *SPH_(TRIANGLE|PLANE)\b' -- cmodel ':!cmodel/prim'; }
check "no other file of the model asks which kind a primitive is" named

# ---- a primitive more ----
sed -i 's/^kind   2      plane .*/&\nkind   3      wedge/' $def
sed -e '/^\/\* v \/ 2^shift/,/^static int validate/{/^static int validate/!d}' \
    -e 's/sph_prim_triangle/sph_prim_wedge/; s/sph_triangle_read/sph_wedge_read/' \
    cmodel/prim/triangle.c >cmodel/prim/wedge.c
sed 's/sph_prim_build_triangle/sph_prim_build_wedge/' cmodel/builder/prim/triangle.c \
    >cmodel/builder/prim/wedge.c
sed -e 's/SPH_TRIANGLE/SPH_WEDGE/; s/sph_prim_scene_triangle/sph_prim_scene_wedge/' \
    -e '/{"p", take_p,/{N;N;s/{"p", take_p.*/{"wedge", take_p, SPH_READ_POLYGON}, {0}};/}' \
    -e 's/"p %u/"wedge %u/' \
    cmodel/scene/prim_triangle.c >cmodel/scene/prim_wedge.c
sed -i 's/\[SPH_TRIANGLE\] = \({[^}]*}\),/[SPH_TRIANGLE] = \1, [SPH_WEDGE] = \1,/' \
    cmodel/reference/facet.c cmodel/naive/facet.c
python3 -m lab layout

# ---- the tool, compiled anew ----
make tool -j"$JOBS" B=build CFLAGS="-std=c11 -D_GNU_SOURCE -O0 -Icmodel" \
    CXXFLAGS="-std=c++17 -O0 -Icmodel" >"$TMP/make" 2>&1 || cat "$TMP/make"
tool=build/sphaera scene=$OLDPWD/scenes/one_sphere.nff
"$tool" build --help >"$TMP/help" 2>&1
check "build --help names it" says '--dummy=WHEN *does nothing: auto' "$TMP/help"
"$tool" build "$scene" --inside on --dummy on -o "$TMP/on.sph" --json "$TMP/on.json" \
    >"$TMP/on.log" 2>&1
check "build tells that it is on, as asked" \
    says 'effect *dummy *1 *as asked; not called for: nothing of a scene' "$TMP/on.log"
check "... and in its report" says '"dummy"' "$TMP/on.json"
"$tool" info "$TMP/on.sph" >"$TMP/info" 2>&1
check "info names the core" says '^core .*+inside.*+dummy1' "$TMP/info"
"$tool" build "$scene" -o "$TMP/auto.sph" >"$TMP/auto.log" 2>&1
check "without, it is off" says 'effect *dummy *off *nothing of a scene calls' "$TMP/auto.log"
"$tool" build "$scene" --dummy=maybe -o "$TMP/bad.sph" >"$TMP/bad.log" 2>&1
check "another word is refused" says 'maybe. is none of auto, off, on' "$TMP/bad.log"
"$tool" build "$scene" --inside off --dummy on -o "$TMP/bad.sph" >"$TMP/bad.log" 2>&1
check "a machine with it and without inside is refused" \
    says 'register EFFECTS is .*: DUMMY needs INSIDE' "$TMP/bad.log"

# ---- what the new primitive draws ----
"$tool" gen icosphere --size 1 2>/dev/null | grep -v '^plane' >"$TMP/p.nff"
sed 's/^p 3/wedge 3/' "$TMP/p.nff" >"$TMP/w.nff"
picture() { "$tool" render "$@" --size 48x27 -o "$TMP/x.png" 2>&1 | grep -e picture -e errors; }
same() { # two lists of arguments
    # shellcheck disable=SC2086  # words
    picture $1 >"$TMP/a" && picture $2 >"$TMP/b" && cat "$TMP/a" "$TMP/b" &&
        grep -q 'errors *none' "$TMP/a" && cmp "$TMP/a" "$TMP/b"
}
check "wedges draw what triangles draw" same "$TMP/p.nff" "$TMP/w.nff"
check "... in a tree of the paper's" same "$TMP/p.nff" "$TMP/w.nff --tree paper"
check "... in a BIH" same "$TMP/p.nff" "$TMP/w.nff --accel bih"
check "... and by brute force" same "$TMP/p.nff" "$TMP/w.nff --brute"
"$tool" build "$TMP/w.nff" -o "$TMP/w.sph" >"$TMP/w.log" 2>&1
check "build counts them" says 'scene .* 80 wedges' "$TMP/w.log"
"$tool" info "$TMP/w.sph" >"$TMP/info" 2>&1
check "info counts them" says '80 wedges below' "$TMP/info"
"$tool" accuracy "$TMP/w.nff" --size 48x27 >"$TMP/w.acc" 2>&1
check "the reference in double precision sees them" says 'psnr *[4-9][0-9]' "$TMP/w.acc"

# ---- a list that is wrong is told by file and line ----
wrong() { # line, message
    { cat "$TMP/def"; echo "$1"; } >$def
    ! python3 -m lab layout "$TMP" 2>"$TMP/why" && cat "$TMP/why" &&
        grep -q "machine.def:.*$2" "$TMP/why"
}
check "a word twice" wrong 'part dummy asked=TREE=9 : twice' 'dummy stands twice'
check "a bit twice" wrong 'part more bit=0 : twice' 'bit 0 is taken'
check "a key that is none" wrong 'part more bits=0 : what' '"bits=0" is none of core, bit'
check "a word without a meaning" wrong 'part more asked=TREE=9' 'more: what it is does not stand'
check "needs what is not there" wrong 'part more asked=TREE=9 needs=thing : what' \
    'more: there is no thing'
done_testing
