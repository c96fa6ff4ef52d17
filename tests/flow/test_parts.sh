#!/bin/sh
# test_parts.sh - an effect more is one line of machine.def: headers, core, tool and help know it
# SPDX-License-Identifier: Apache-2.0
#
# In a copy of the tree a line of machine.def names the effect `dummy`; `make layout` does the rest.
# The copy's tool is compiled without optimisation; the core is elaborated, not simulated.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/tap.sh
export CCACHE_BASEDIR="$PWD"
copy=$TMP/copy
mkdir -p "$copy" && cp -r Makefile README.md CONTRIBUTING.md \
    cmodel docs formal lab make rtl sim synth tb tests "$copy" || exit 1
cd "$copy" || exit 1
def=cmodel/machine/machine.def
line="effect dummy most=3 bit=$(awk -f cmodel/machine/effects.awk -f - $def <<'END'
END { print bits }
END
) option=when needs=inside : does nothing"
find . -type f | sort | xargs cksum >"$TMP/before"
awk -v line="$line" '$1 == "part" && !done { print line; done = 1 } 1' $def >"$TMP/def"
cp "$TMP/def" $def
make layout >"$TMP/layout" 2>&1 || cat "$TMP/layout"

# ---- what differs: machine.def, which was edited, and what make layout wrote ----
find . -type f | sort | xargs cksum | diff "$TMP/before" - | sed -n 's/^> .* //p' >"$TMP/changed"
generated() {
    printf './%s\n' $def cmodel/machine/layout.h rtl/core/rt_core.v rtl/core/rt_layout.vh \
        tb/core/tb_core_icarus.v | sort | diff - "$TMP/changed"
}
check "one line of machine.def changes what is generated and nothing else" generated
check "layout.h has bit, entry and mask" \
    grep -c 'SPH_EFFECT_DUMMY \|X(DUMMY, dummy, "DUMMY"' cmodel/machine/layout.h
check "rt_core has its parameter" grep 'parameter DUMMY  *= 3,  *// 0..3: does nothing' \
    rtl/core/rt_core.v
check "make layout once more writes nothing" \
    sh -c 'touch "$1"; make layout; ! find . -newer "$1" -name "*.v" | grep .' - "$TMP/stamp"

# ---- names of cores ----
has() { sh sim/parameters.sh "$1" | grep -q "\\bDUMMY=$2\\b"; }
check "parameters: all" has all 3
check "parameters: none" has none 0
check "parameters: all-dummy" has all-dummy 0
check "parameters: a count" has inside+dummy2 2
check "parameters: all-inside leaves it out too" has all-inside 0
refuses() { ! sh sim/parameters.sh "$1" 2>"$TMP/why" && cat "$TMP/why" && grep -q "$2" "$TMP/why"; }
check "parameters: a count that is too large" refuses inside+dummy4 'dummy4 names nothing'
check "parameters: what it needs" refuses dummy1 'dummy1: dummy needs inside'
says() { grep -q -e "$1" "$2" || { cat "$2" && false; }; }
make help >"$TMP/help" 2>&1
check "make help names it" says dummyN "$TMP/help"

make pages >"$TMP/pages" 2>&1 || cat "$TMP/pages"
check "the page of the core has it" says \
    '| `dummy` | `DUMMY` | 0 .. 3 |.*does nothing' docs/use/core.md
check "... and its table of parameters" says '^| `DUMMY` | 3 |' docs/use/core.md

# ---- the core elaborates with it and without, silently ----
elaborate() { # list
    parameters=$(sh sim/parameters.sh "$1") || return 1
    # shellcheck disable=SC2046,SC2086  # words
    set -- $(printf ' -Ptb_core_icarus.%s' $parameters) \
        $(find rtl -name '*.vh' -exec dirname {} + | sort -u | sed 's/^/-I/') \
        $(find rtl -name '*.v') tb/core/tb_core_icarus.v
    iverilog -g2005 -Wall -t null -s tb_core_icarus "$@" >"$TMP/log" 2>&1 && [ ! -s "$TMP/log" ] ||
        { cat "$TMP/log" && false; }
}
check "Icarus elaborates a core with it" elaborate inside+dummy2
check "Icarus elaborates a core without" elaborate none

# ---- the tool, compiled anew ----
make tool -j"$JOBS" B=build CFLAGS="-std=c11 -D_GNU_SOURCE -O0 -Icmodel -fopenmp" \
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

# ---- a list that is wrong is told by file and line ----
wrong() { # line, message
    { cat "$TMP/def"; echo "$1"; } >$def
    ! sh sim/layout.sh "$TMP" 2>"$TMP/why" && cat "$TMP/why" &&
        grep -q "machine.def:.*$2" "$TMP/why"
}
check "a word twice" wrong 'part dummy asked=TREE=9 : twice' 'dummy stands twice'
check "a bit twice" wrong 'part more bit=0 : twice' 'bit 0 is taken'
check "a key that is none" wrong 'part more bits=0 : what' '"bits=0" is none of core, bit'
check "a word without a meaning" wrong 'part more asked=TREE=9' 'more: what it is does not stand'
check "needs what is not there" wrong 'part more asked=TREE=9 needs=thing : what' \
    'more: there is no thing'
done_testing
