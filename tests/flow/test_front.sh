#!/bin/sh
# test_front.sh - what a user types to make: wrong words are refused at once, and no run answers for
# another, whatever is typed twice, at the same time, or from elsewhere
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
has() { grep -q -- "$1" "$2"; } # pattern, file
plain_make() { env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory "$@"; }

# ---- what a user gives stands: no makefile sets a variable of make/variables.mk again ----
set_again() { # but the compilers and their options, to defaults that are no text
    for name in $(sed -n 's/^## \([A-Z_][A-Z_]*\) .*/\1/p' make/variables.mk |
        grep -vE '^(CC|CXX|CFLAGS|CXXFLAGS)$'); do
        grep -nE "^$name *:?=" Makefile make/[!v]*.mk make/view.mk make/verilated.mk
    done
}
check "variables are set in one place" [ -z "$(set_again)" ]

# ---- wrong words are refused at once: nothing is built, all are named, the right one too ----
refuse() { # words: $TMP/err has what make says of them
    timeout 60 env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make B="$TMP/none" "$@" \
        >"$TMP/text" 2>"$TMP/err"
    refused=$?
    [ ! -e "$TMP/none" ] || refused="not at once"
    rm -rf "$TMP/none"
}
says() { # pattern: the call was refused, with such a line
    cat "$TMP/err"
    [ "$refused" = 2 ] && grep -qE -- "$1" "$TMP/err"
}
refuse sim SCNE=paper5 scene=paper5
for word in "no variable SCNE; is SCENE meant" "no variable scene; is SCENE meant"; do
    check "... $word" says "$word"
done
check "... a line each, and make's" [ "$(wc -l <"$TMP/err")" = 3 ]
refuse sim SIM=questa ENGINES=9 STALL=100 LATENCY=-1 SIZE=axb DEPTH=11 JOBS=x PROFILE=draft N=0 \
    EFFECTS=shadw TREE=papre ACCEL=bhv4 BACKGROUND=rekt TRAVERSE=frist SEED=x WARM=yes TARGET=ecp \
    MAX_PRIMS=0 AT=70000 LEVELS=3 ROOT_STEP=26 QUOTIENT_STEP=14 SCENE=pape5 WINDOW=4,4,4,8 V=2 \
    PIXEL=4 SAMPLES=17 ERROR=0.1,x
for word in "SIM=questa: is none of verilator, icarus, cxxrtl, ecp5, xc7, silicon$" \
    "ENGINES=9: is not 1 to 8$" \
    "STALL=100: is not 0 to 99$" "LATENCY=-1: is not 1 to 100000$" "JOBS=x: is not 1 to 1024$" \
    "SIZE=axb: is no size such as 640x360" "DEPTH=11: is not 0 to 10$" \
    "EFFECTS=shadw: .*; is shadow meant" \
    "TREE=papre: is none of reinserted, .*, hw2; is paper meant" \
    "ACCEL=bhv4: .*; is bvh4 meant" "BACKGROUND=rekt: .*; is rect meant" \
    "SEED=x: is not 0 and more" "TRAVERSE=frist: .*; is first meant" "WARM=yes: is none of 0, 1$" \
    "TARGET=ecp: .*; is ecp5 meant" "MAX_PRIMS=0: is none of 1 to 16777215, infinity" \
    "AT=70000: is not 0 to 65535" "LEVELS=3: is not 0 to 2" "ROOT_STEP=26: is not 1 to 25" \
    "QUOTIENT_STEP=14: is not 1 to 13" "SCENE=pape5: .*; is paper5 meant.* There are effects" \
    "WINDOW=4,4,4,8: has no pixel" "PIXEL=4: is no pixel such as 21,9" "V=2: " \
    "SAMPLES=17: is not 1 to 16$" "ERROR=0.1,x: is no error such as 0.125 or 0.125,45"; do
    check "... $word" says "$word"
done
refuse sim SIZES=unit=1
check "... SIZES=unit=1" says 'there is no "unit"; is units meant. There are setups '
for word in "units=3: .*: units is 3, not in 1..2" "slots=96: .*: slots is 96, no power of two" \
    "engines=2: .*: engines has the variable ENGINES" "slots: .*: .slots. is no size=value"; do
    refuse sim SIZES="${word%%:*}"
    check "... SIZES=${word%%:*}" says "^SIZES=$word"
done
refuse sim ENGINES=two SIZE=16x9 WINDOW=0,0,17,9 PIXEL=3,9 PROFILE=standart SCENE=foo STALL= \
    ROOT_STEP=0
for word in "ENGINES=two: is not 1 to 8$" "WINDOW=0,0,17,9: is not inside SIZE=16x9" \
    "PIXEL=3,9: is not inside SIZE=16x9" \
    "PROFILE=standart: .*is standard meant" "SCENE=foo: is no file, and no scene" \
    "^ .*texture/hall" "STALL=: is empty" "ROOT_STEP=0: "; do
    check "... $word" says "$word"
done
refuse sim PIXEL=8,3 WINDOW=0,0,8,8 FOO=1
check "... a pixel outside of the window" says "^PIXEL=8,3: is not inside WINDOW=0,0,8,8"
check "... a word that is like none" says '^there is no variable FOO. .make help-all. prints them$'
refuse sim PROFILE=all
check "... PROFILE=all, which is for make synth" says "^PROFILE=all: "
refuse sim SCENE=sphreflake:3
check "... SCENE=sphreflake:3" says "is sphereflake:N meant"
for word in "LEAF_UNITS=4 SHADES=2 PIPES=4" "ENGINES=3 PIPES=3" "SIZES=setups=2" "SHADES=2" \
    "SHADES=2 PIPES=2 EFFECTS=all" "SIZES=hit_interval=9" "PROFILE=standard:wd=16"; do
    for goal in sim synth; do
        # shellcheck disable=SC2086  # words
        refuse $goal $word
        check "make $goal $word, which do not go together" says "^[A-Z].*=.*: .* (must be|needs) "
    done
done
refuse sim LEAF_UNITS=2
check "... what was given, and what follows from what" says \
    "^LEAF_UNITS=2 SHADES=0, which is 1 for PIPES=1.*: LEAF_UNITS must be at most SHADES"
refuse synth SHADES=2 PIPES=2
check "make synth of a core with everything" says "^SHADES=2 INTERPENETRATE=1: INTERPENETRATE needs"
SIM=questa refuse sim
check "... of the environment too" says "^SIM=questa: is none of verilator, icarus, cxxrtl, ecp5, "
for word in SIM=questa ENGINES=two EFFECTS=shadw "LEAF_UNITS=4 PIPES=4"; do
    # shellcheck disable=SC2086  # words
    env BUILD="$TMP/none" $word sh sim/core.sh --machine nothing.sph >"$TMP/text" 2>"$TMP/err"
    refused=$?
    check "sim/core.sh with $word" says "^${word%% *}[: ]"
    check "... builds nothing" [ ! -e "$TMP/none" ]
done
mkdir "$TMP/bin"
ln -s $(find /bin/ /usr/bin/ "$(dirname "$(command -v python3)")" -maxdepth 1 -type f -o -type l) \
    "$TMP/bin" 2>"$TMP/text"
rm -f "$TMP/bin/verilator" "$TMP/bin/iverilog" "$TMP/bin/yosys" "$TMP/bin/gnuplot"
while read -r goal word what; do
    PATH=$TMP/bin refuse $goal SIM=$word
    check "make $goal without $word" says "$what is not installed: make setup $goal$"
done <<'ROWS'
sim verilator ^SIM=verilator: this simulator
sim icarus ^SIM=icarus: this simulator
synth verilator ^yosys
price verilator ^gnuplot
ROWS
for word in "snyth" "clean snyth" "sim synths"; do
    # shellcheck disable=SC2086  # words
    refuse $word
    check "make $word" says "^there is no target s[a-z]*; is synth meant"
done
refuse tests
check "make tests, which is a folder" says "^there is no target tests; is test meant"
refuse test ONLY=test_raedme
check "ONLY of no suite" says "^ONLY=test_raedme: no suite .*; is test_readme.sh meant"
check "sim/cores.py without a list tells its use" sh -c \
    '! sim/cores.py parameters 2>&1 | grep -v "sim/cores.py [a-z]* [A-Z]\|ENGINES" &&
    ! sim/cores.py parameters 2>/dev/null'
refuse build/nosuch
check "make build/nosuch" says "No rule to make target 'build/nosuch'"
refuse clean build/nosuch
check "make clean build/nosuch" says "No rule to make target 'build/nosuch'"
accepted() { plain_make B="$TMP/none" sim-folder "$@"; }
check "the bounds are allowed" accepted PROFILE=standard:pq=12 SIZE=16383x1 WINDOW=0,0,16383,1 \
    DEPTH=10 JOBS=1024 ENGINES=8 STALL=99 LATENCY=100000 MAX_PRIMS=infinity SCENE=icosphere:5 \
    ROOT_STEP=33 QUOTIENT_STEP=12 SIZES=slots=1024,roots=0 EFFECTS=all+texture LEVELS= AT=65535 \
    "BUILD_MORE=--inside off"
check "auto is a profile of a run" accepted PROFILE=auto ERROR=.5,40
check "so is every profile, of synthesis" accepted PROFILE=all synth -n

# ---- the rules are those of the tool and of the harness ----
refuse sim DEPTH=x TREE=x ACCEL=x BACKGROUND=x TRAVERSE=x LEVELS=x AT=x MAX_PRIMS=x MAX_TREE_DEPTH=x
sed -n 's/, infinity//; s/^[A-Z_]*=x: is \(none of\|not\) \([^;]*\).*/\2/p' "$TMP/err" |
    tr ', ' '\n' | sort >"$TMP/rules"
for option in depth tree accel background traverse bg-levels at max-prims max-tree-depth; do
    "$SPHAERA" build scenes/paper5.nff -o "$TMP/x.sph" --accel bih "--$option" x 2>&1 |
        sed -n "s/.*'x' is \(none of\|no number from\) //p"
done | tr ', ' '\n' | sort >"$TMP/tool"
check "words and bounds are those of the tool" diff "$TMP/rules" "$TMP/tool"
for kind in $(sed -n 's/^    {"\([a-z0-9_]*\)", sph_make.*/\1/p' cmodel/scene/generate.c); do
    "$SPHAERA" gen "$kind:3" >"$TMP/text" 2>&1 && echo "$kind:N"
done >"$TMP/tool"
sim/scene.py nothing 2>&1 | tr ' ' '\n' | grep ':N$' >"$TMP/rules"
check "so are the kinds of scenes" sh -c "[ -s '$TMP/tool' ] && diff '$TMP/rules' '$TMP/tool'"
same_scene() { "$SPHAERA" gen "$1" | grep -v '^#' >"$TMP/x.nff" && shift && "$SPHAERA" gen "$@" |
    grep -v '^#' | cmp - "$TMP/x.nff"; }
check "N is the size of an icosphere" same_scene icosphere:3 icosphere --size 3

# ---- a run's folder is its whole key ----
other='SCENE=paper5 PROFILE=draft SIZE=8x8 TREE=paper ACCEL=bih MAX_PRIMS=2 MAX_TREE_DEPTH=3
    DEPTH=1 BACKGROUND=rect TRAVERSE=first LEVELS=1 AT=1 BUILD_MORE=--inside=off EFFECTS=all
    ENGINES=2 PIPES=2 LEAF_UNITS=1 EXACTS=1 SHADES=1 ROOT_STEP=2 QUOTIENT_STEP=1 SIZES=units=1
    SEED=2 LATENCY=3 STALL=4 SIM=icarus WINDOW=0,0,1,1 PIXEL=0,0 WARM=1 LITERAL=1 WAVES=1
    WATCHDOG=9 LIB=x CLOCK_GATES=0 SAMPLES=2 ERROR=0.5 MEMORY=sdram16 CORE_MHZ=50'
same='TARGET FLAT RESULTS KINDS PROVE ONLY ALL SUITE_LIMIT CORE EFFECT MUTANT N STATE OPT V B CC
    CFLAGS CXX CXXFLAGS PREFIX DESTDIR TOP LAYERS BUILD FRAMES BART BOARD CSV ENGINE FAMILY MOVIE
    FAULTS TRIALS MINUTES INPUTS HARNESS ROUTE SEEDS SEEDS_CORE JOBS TOP_DATA HD_SCENE MORE RTL
    BLOCK CELLS IP TOP_PARAMETERS YOSYS MACROS'
for word in '' $other; do
    plain_make sim-folder JOBS=2 $word
done >"$TMP/folders" 2>&1
check "each of them has another folder" [ "$(sort -u "$TMP/folders" | grep -c '^build/out/')" = 38 ]
for word in $other $same; do echo "${word%%=*}"; done | sort >"$TMP/mine"
sed -n 's/^## \([A-Z_][A-Z_]*\) .*/\1/p' make/variables.mk | sort >"$TMP/rules"
check "every variable is one of them, or shapes no run" diff "$TMP/mine" "$TMP/rules"

# ---- runs: no answer of another ----
elsewhere="$TMP/some where"
mkdir -p "$elsewhere/a" "$elsewhere/b"
from_elsewhere() (
    root=$PWD
    cd "$elsewhere" || exit 1
    plain_make -f "$root/Makefile" B="$BUILD" SIZE=32x18 "$@"
)
hash_of() { "$SPHAERA" render --size 32x18 "$1" | grep '^frame'; }
shows() { # file, words: such a run draws the picture of the file
    wanted=$(hash_of "$1")
    shift
    from_elsewhere render "$@" >"$TMP/text" 2>&1
    cat "$TMP/text"
    grep -qx "$wanted" "$TMP/text"
}
cp scenes/inside.nff "$elsewhere/a/x.nff"
cp scenes/paper5.nff "$elsewhere/b/x.nff"
cp scenes/texture/*.png scenes/texture/hall.nff "$elsewhere"
check "inside" shows scenes/inside.nff SCENE=inside
first=$(sed -n 's,^picture \(.*\)/model.png$,\1,p' "$TMP/text") # last may be of another call
check "effects/inside is another" shows scenes/effects/effects.nff:inside SCENE=effects/inside
check "... and the first is as it was" [ "$("$SPHAERA" render "$first/scene.sph" |
    grep '^frame')" = "$(hash_of scenes/inside.nff)" ]
check "a/x.nff, of the folder where make was called" shows "$elsewhere/a/x.nff" SCENE=a/x.nff
check "b/x.nff is another" shows "$elsewhere/b/x.nff" SCENE=b/x.nff
cp scenes/one_sphere.nff "$elsewhere/b/x.nff"
check "a scene that changed is built anew" shows "$elsewhere/b/x.nff" SCENE=b/x.nff
cp scenes/paper5.nff "$elsewhere/b/my scene's.nff"
check "a name with a space" shows "$elsewhere/b/my scene's.nff" SCENE="b/my scene's.nff"
check "an image" shows "$elsewhere/hall.nff" SCENE=hall.nff
before=$(grep '^frame' "$TMP/text")
cp "$elsewhere/face.png" "$elsewhere/tiles.png"
check "an image that changed" shows "$elsewhere/hall.nff" SCENE=hall.nff
check "... is seen" [ "$before" != "$(grep '^frame' "$TMP/text")" ]
from_elsewhere render SCENE=random:30 SEED=5 >"$TMP/text" 2>&1
"$SPHAERA" gen random:30 --seed 5 -o "$TMP/random.nff" >"$TMP/text2"
check "a seed of a generated scene" grep -x "$(hash_of "$TMP/random.nff")" "$TMP/text"
ours=$(sed -n 's,^picture \(.*\)/model.png$,\1,p' "$TMP/text")
echo damaged >"$ours/key"
refused=0
from_elsewhere render SCENE=random:30 SEED=5 >"$TMP/text" 2>"$TMP/err" || refused=$?
check "a folder of another key is left alone" says "belongs to another run"
rm -r "$ours"
check "a simulation from elsewhere" from_elsewhere sim SCENE="b/my scene's.nff" SIM=icarus SIZE=6x4
left() { sed -n 's,^pictures and report in \(.*\)/$,\1,p' "$TMP/out"; }
last=$(left)
check "... leaves a report in its folder" test -s "$last/report.json"
check "... and pictures" test -s "$last/side-by-side.png"
harness() { "$BUILD/sim/tb_core_icarus" --machine "$last/scene.sph" --info "$@"; }
check "a register that is overwritten asks for no other core" \
    [ "$(harness)" = "$(harness --reg 0=0)" ]
refused=0
harness --window 0,0,7,4 >"$TMP/text" 2>"$TMP/err" || refused=$?
check "a window outside the scene's own size is refused before a core is built" \
    says "the window is empty or not inside the frame"
check "four samples a pixel" from_elsewhere sim SCENE="b/my scene's.nff" SIM=icarus SIZE=6x4 \
    SAMPLES=2 WINDOW=1,1,5,3
last=$(left)
check "... of twice the window" grep -q "32 pixels, 0 mismatches" "$last/log"
check "... are the mean of the core's light" sh -c "cd '$last' &&
    oiiotool rtl.png model.png --absdiff --printstats | grep 'Stats Max: 0.0* 0.0* 0.0*' &&
    oiiotool --info rtl.png | grep '6 x  *4,'"

# ---- two calls at the same time: a compiler that takes its time never sees half a file ----
cat >"$TMP/slow" <<'END'
#!/bin/sh
for word; do
    case $previous in -o) to=$word ;; -MF) dependencies=$word ;; esac
    case $previous/$word in
    -o/* | -MT/*) ;;
    */*.o | */*.a) { [ -s "$word" ] && ! grep -q half "$word"; } || echo "$word" >>"$HALVES" ;;
    esac
    previous=$word
done
echo half >"$to"
case $to in *.o | */sphaera) echo "$to is seen before it is whole" >>"$HALVES" ;; esac
case $to in *sphaera*) sleep 1 ;; *) sleep 0.05 ;; esac
echo whole >"$to"
[ -z "$dependencies" ] || : >"$dependencies"
END
chmod +x "$TMP/slow"
cold() { # name: the tool in a folder that both calls share
    previous='' dependencies='' HALVES=$TMP/halves plain_make -j8 -s B="$TMP/cold" CC="$TMP/slow" \
        CXX="$TMP/slow" tool >"$TMP/cold.$1" 2>&1 || echo "call $1 failed" >>"$TMP/halves"
    [ "$(cat "$TMP/cold/sphaera")" = whole ] || echo "call $1: half a tool" >>"$TMP/halves"
}
: >"$TMP/halves"
cold first &
sleep 0.3
cold second
wait
check "two calls build one tool" sh -c "head -n 5 '$TMP/halves'; [ ! -s '$TMP/halves' ]"

# ---- one build folder by two names ----
mkdir "$TMP/tree"
tar c --exclude=./build --exclude=./.git --exclude=./docs . | tar x -C "$TMP/tree"
object=obj/$(find cmodel -name error.c | sed 's/c$/o/')
in_tree() (
    cd "$TMP/tree" || exit 1
    "$@"
)
rebuilt() { # file that is touched, command, object: by a relative name, and then an absolute one
    touched=$1 call=$2
    in_tree $call B=build "build/$3" >"$TMP/text" 2>&1
    in_tree touch -r "build/$3" "$TMP/before"
    sleep 0.01
    in_tree touch $touched
    in_tree $call B="$TMP/tree/build" "$TMP/tree/build/$3" >>"$TMP/text" 2>&1
    cat "$TMP/text"
    [ "$TMP/tree/build/$3" -nt "$TMP/before" ]
}
check "a header of the model is seen by either name" rebuilt \
    "$(find cmodel -name error.h)" "plain_make" "$object"
in_tree touch build/libsphaera.a
check "a core is built by one name" sh -c "cd '$TMP/tree' && make -n -f make/core.mk \
    B='$TMP/tree/build' tools >'$TMP/text' && ! grep '$TMP/tree/build' '$TMP/text'"

# ---- generated headers that stay the same keep their time ----
in_tree plain_make layout >"$TMP/text" 2>&1
touch "$TMP/now"
sleep 0.01
in_tree plain_make layout >"$TMP/text" 2>&1
check "make layout touches nothing" [ -z "$(find "$TMP/tree/cmodel" "$TMP/tree/rtl" "$TMP/tree/tb" \
    -newer "$TMP/now" -type f)" ]
done_testing
