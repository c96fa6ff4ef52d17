#!/bin/sh
# litex_sim.sh - a frame in LiteX's simulator: VexRiscv with the driver, LiteDRAM, rt_top
# SPDX-License-Identifier: Apache-2.0
#
# usage: LITEX=PYTHON synth/litex_sim.sh FOLDER EFFECTS
#   FOLDER  has frame.sph, of profile draft, and frame.golden, the golden model's frame; gets
#           system, simulator, told.log
set -eu
cd "$(dirname "$0")/.."
out=$1
# shellcheck disable=SC2046  # lists of words on purpose
"$LITEX" -m lab litex-sim "$out" "$out/frame.sph" $(sim/cores.py profile draft) \
    $(sim/cores.py parameters "$2") >"$out/litex.log" 2>&1 || {
    tail -n 20 "$out/litex.log" >&2
    exit 1
}
env -u MAKEFLAGS -u MFLAGS sh -c "cd $out/gateware && sh build_sim.sh" >"$out/build.log" 2>&1 || {
    grep -iE 'error|No such' "$out/build.log" >&2
    exit 1
}
(cd "$out/gateware" && timeout 600 obj_dir/Vsim) </dev/null >"$out/told.log" 2>&1 || {
    echo "litex-sim: the simulation did not end" >&2
    exit 1
}
python3 -m lab litex-check "$out/told.log" "$out/frame.sph" "$out/frame.golden"
