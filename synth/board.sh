#!/bin/sh
# board.sh - a bitstream for a ULX3S with LFE5U-85F, speed grade 6: Yosys, nextpnr-ecp5, ecppack
# SPDX-License-Identifier: Apache-2.0
#
# usage: synth/board.sh TOP VENV FOLDER [PARAMETER=VALUE...]
#   TOP     module of rtl/board
#   VENV    folder of `make board-setup`; tools of that name in the PATH are preferred; -: Yosys
#           alone, for the cells
#   FOLDER  gets TOP.json, TOP.config, TOP.bit, report.json, logs, sources.d
# Exit code 3: a tool is absent.
set -eu
cd "$(dirname "$0")/.."
. sim/beside.sh
top=$1 venv=$2 out=$3
shift 3
mkdir -p "$out"
tool() { # nextpnr-ecp5, ecppack
    command -v "$1" || {
        [ -x "$venv/bin/yowasp-$1" ] && echo "$(cd "$venv/bin" && pwd)/yowasp-$1"
    } || {
        echo "board: no bitstream, $1 is absent: make board-setup" >&2
        exit 3
    }
}
if [ "$venv" = - ]; then pnr=/- pack=/-; else pnr=$(tool nextpnr-ecp5) pack=$(tool ecppack); fi
YOWASP_CACHE_DIR=${YOWASP_CACHE_DIR:-$(cd "$out/.." && pwd)/cache}
export YOWASP_CACHE_DIR
set_all=
for p; do set_all="$set_all -set ${p%%=*} ${p#*=}"; done
folders=$(find rtl -name '*.v*' -exec dirname {} + | sort -u)
include='' library=''
for d in $folders; do include="$include -I$d" library="$library -libdir $d"; done
python3 -m lab commit >"$out/commit"
rm -f "$out/report.json"
nice yosys -q -l "$out/yosys.log" -p "verilog_defaults -add $include -DSYNTHESIS;
    read_verilog -lib +/ecp5/cells_bb.v +/ecp5/cells_sim.v; read_verilog rtl/board/$top.v;
    ${set_all:+chparam $set_all $top;} hierarchy -check -top $top $library;
    synth_ecp5 -top $top -json $out/$top.json; check -assert" >"$out/yosys.out" 2>&1 || {
    cat "$out/yosys.out" >&2
    exit 1
}
[ "$venv" != - ] || exit 0
cp synth/ulx3s.lpf "$out/"
# In the folder: the packaged tools see no other.
cd "$out"
start=$(date +%s)
nice -n 15 "$pnr" --85k --speed 6 --package CABGA381 --json "$top.json" --lpf ulx3s.lpf \
    --lpf-allow-unconstrained --textcfg "$top.config" --report report.json --seed 1 \
    --timing-allow-fail -q -l pnr.log >pnr.out 2>&1 || {
    tail -n 20 pnr.out >&2
    exit 1
}
echo $(($(date +%s) - start)) >seconds
beside "$top.bit"
"$pack" --compress --input "$top.config" --bit "$new" >pack.out 2>&1 || {
    cat pack.out >&2
    exit 1
}
named "$top.bit"
