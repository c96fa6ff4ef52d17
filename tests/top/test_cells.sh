#!/bin/sh
# test_cells.sh - frames by the cells that Yosys maps cores to equal the golden model's
# SPDX-License-Identifier: Apache-2.0
#
# For ECP5 the draft core without effects, and the standard core with all of `all`: lights,
# reflections, spheres that cut each other. Faults put into the netlist are noticed.
#   SEED=n   other latencies and stalls (1)
#   ALL=1    glass, highlights and images too, and cells of Xilinx (`make netlist-cells`)
set -u
. "$(dirname "$0")/../tap.sh"
. "$(dirname "$0")/../core_runs.sh"
cd "$(dirname "$0")/../.." || exit 1
command -v yosys >"$TMP/yosys" || {
    echo "ok 1 - # SKIP no yosys"
    echo "1..1"
    exit 0
}
start cells
machine none scenes/paper5.nff --size 16x12 --profile draft --lights 0 --depth 0
machine cut scenes/interpenetrating.nff --size 16x12 --depth 2 --traverse first --background exact
wanted "ecp5, draft, none" none SIM=ecp5 none
wanted "ecp5, draft, none; the clock stands still while active_o is low" none SIM=ecp5 none \
    --warm --gated
wanted "ecp5, standard, all: spheres that cut each other" all SIM=ecp5 cut --toggles "$TMP/toggles"
if [ -n "${ALL:-}" ]; then
    machine lights scenes/eight_lights.nff --size 16x12
    optics=all+texture+refract+specular+sum
    machine glass scenes/refraction/nested.nff --size 16x12
    machine hall scenes/texture/hall.nff --size 12x9 --spread off
    wanted "ecp5, standard, all: eight lights" all SIM=ecp5 lights
    for scene in glass hall; do
        wanted "ecp5, standard, with optics: $scene" $optics SIM=ecp5 $scene
    done
    wanted "xc7, draft, none" none SIM=xc7 none
    wanted "xc7, standard, all: spheres that cut each other" all SIM=xc7 cut
    wanted "xc7, standard, all: eight lights" all SIM=xc7 lights
fi
build_cores
run_all
judge

# ---- an idle core: what a counter that goes round costs, and no more ----
unset BUILT
STILL=80 # nets that change a clock
idle() { # what --toggles wrote
    awk -F'\t' 'NR == 1 { clocks = substr($0, index($0, " ")) } { sum += $5 }
        END { print sum / clocks, "nets of an idle core change a clock"
              exit !(NR > 100 && sum / clocks < '$STILL') }' "$1"
}
if [ -f "$TMP/toggles" ]; then
    check "nothing toggles for nothing" idle "$TMP/toggles"
    # the enable of a sum is taken out, which then adds what stands still for ever
    all=$(SIM=ecp5 EFFECTS=all sh sim/core.sh --folder --machine "$machines/cut.sph")/ecp5.json
    restless() {
        python3 tests/top/spoil_cell.py "$all" TRELLIS_FF CEMUX 1 "$TMP/spoilt.json" \
            'u_lambert\.s2_dot_q' &&
            "$BUILD/sim/tb_core_netlist" --engine "$TMP/spoilt.json" --core all \
                --machine "$machines/cut.sph" --toggles "$TMP/restless" >"$TMP/said" 2>&1
        ! idle "$TMP/restless"
    }
    check "units that do not wait are noticed" restless
fi

# ---- one cell changed ----
netlist=$(SIM=ecp5 EFFECTS=none sh sim/core.sh --folder --machine "$machines/none.sph")/ecp5.json
drawn() { # netlist
    "$BUILD/sim/tb_core_netlist" --engine "$1" --core none --machine "$machines/none.sph" \
        --latency 5 --watchdog 5000 --stop >"$TMP/said" 2>&1
    cat "$TMP/said"
    grep -q '^core .* 0 mismatches' "$TMP/said"
}
spoilt() { # type of cell, setting, value
    python3 tests/top/spoil_cell.py "$netlist" "$1" "$2" "$3" "$TMP/spoilt.json"
}
noticed() {
    spoilt "$1" "$2" - && ! drawn "$TMP/spoilt.json" && grep -q '^core .* mismatches' "$TMP/said"
}
refused_cell() {
    spoilt "$1" "$2" "$3" && ! drawn "$TMP/spoilt.json" && grep -q "$2 is $3, which has" "$TMP/said"
}
check "a LUT with another table is noticed" noticed LUT4 INIT
check "a sum with another table is noticed" noticed CCU2C INIT0
check "a setting without a model is refused" refused_cell TRELLIS_FF CLKMUX INV
done_testing
