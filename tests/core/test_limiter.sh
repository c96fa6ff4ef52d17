#!/bin/sh
# test_limiter.sh - what a run says that limits it: every unit has a row, and the rows are true
# SPDX-License-Identifier: Apache-2.0
set -u
. "$(dirname "$0")/../tap.sh"
cd "$(dirname "$0")/../.." || exit 1
tool=$BUILD/sphaera

# ---- every module that can turn something away shows what it does, or who does it stands here ----
cat >"$TMP/shown" <<'END'
rt_blends       rt_blend, rt_colour
rt_cache        rt_traverse, rt_bih, rt_leaf_unit, rt_texture
rt_divide       rt_facet_key
rt_isqrt        rt_sphere_key, rt_refract
rt_longitude    rt_sphere_uv
rt_pool         whose units it hands out: rt_quotient_pool, rt_sphere_uv
rt_quotient     rt_quotient_pool
rt_setup        rt_unit, rt_unit_four, rt_across
rt_shares       rt_share
rt_sphere       rt_leaf, rt_sphere_key
rt_units        rt_unit, rt_unit_four
rt_vectors      rt_unit, rt_unit_four
rt_background   rt_pixel_scan
rt_spans        rt_pixel_scan
rt_pixel_scans        rt_pixel_scan, rt_mem_arbiter
rt_engine       it only wires, as do those below, or passes on what memory gives
rt_leaf_units       -
rt_pipes        -
rt_shade        -
rt_shades       -
rt_trace        -
rt_async_fifo   a queue
rt_fifo         a queue
rt_reg_slice         a register
END
for file in rtl/core/*.v rtl/engine/*.v rtl/math/*.v rtl/memory/*.v rtl/pixel/*.v rtl/prim/*.v \
    rtl/shade/*.v rtl/texture/*.v rtl/trace/*.v; do
    grep -q 'output.*_ready_o\b' "$file" && ! grep -q 'wire.* work_' "$file" && basename "$file" .v
done | sort >"$TMP/silent"
cut -d ' ' -f 1 "$TMP/shown" | sort >"$TMP/told"
check "every module that can turn something away has a row, or one that stands for it" \
    diff "$TMP/silent" "$TMP/told"

# ---- two frames of one core: Scenario 1 with 64 spheres, with its plane and without ----
"$tool" gen scenario1 -n 64 --radius 1 --plain -o "$TMP/plane.nff" >/dev/null
grep -v '^plane ' "$TMP/plane.nff" >"$TMP/none.nff"
run() { # name, scene, options of build -- of the harness
    run=$1 scene=$2
    shift 2
    "$tool" build "$scene" --profile standard --accel bih --max-prims 4 --depth 0 --shadow off \
        "$@" -o "$TMP/$run.sph" >"$TMP/said" 2>&1 || return
    # shellcheck disable=SC2086  # options
    EFFECTS=lights1+facets+bih sim/core.sh --machine "$TMP/$run.sph" --json "$TMP/$run.json" \
        $HOW >"$TMP/$run.said"
}
HOW="--warm --latency 20"
check "with the plane" run plane "$TMP/plane.nff" --size 40x68
check "without it" run none "$TMP/none.nff" --size 40x68
HOW="--latency 400"
"$tool" gen scenario1 -n 4096 --radius 1 --plain -o "$TMP/all.nff" >/dev/null
grep -v '^plane ' "$TMP/all.nff" >"$TMP/many.nff"
check "memory that answers late" run late "$TMP/many.nff" --size 12x12
HOW="--latency 20"
check "four pixels" run few "$TMP/plane.nff" --size 2x2

says() { # name, what of it, in Python: of a pass p, its rows u by name
    python3 - "$TMP/$1.json" "$2" <<'END'
import json, sys
run = json.load(open(sys.argv[1]))
p = run.get("warm", run["cold"])
u = {row["name"]: row for row in p["units"]}
cycles, count = p["counters"]["cycles"], p["counters"]
print(p["limit"]["said"])
print({name: (round(row["busy"], 3), row["binds"], row["taken"]) for name, row in u.items()})
sys.exit(0 if eval(f"({sys.argv[2]})") else 1)
END
}
rows="cosines|exact tests of facets|exact tests of spheres|keys of facets|leaf cache|lights added"
rows="$rows|memory port|next nodes|node cache|node visits|pixel port|pixel walk|pixels delivered"
rows="$rows|points and normals|quotients|rays done|rays set up for planes|records to tests"
rows="$rows|results of tests|roots|surfaces blended|unit vectors"
check "every unit of the core has a row" says plane "'|'.join(sorted(u)) == '$rows'"
for frame in plane none late few; do
    check "$frame: nobody works in more clocks than there are" says "$frame" \
        "all(row['busy'] <= 1 + 64/cycles for row in u.values())"
    check "$frame: each clock is bound once at most" says "$frame" \
        "sum(row['binds'] for row in u.values()) <= cycles + 256"
    check "$frame: rows have seen what the core's counters have" says "$frame" \
        "u['node visits']['taken'] == count['node_visits'] and
         u['roots']['taken'] == count['roots'] and
         u['keys of facets']['taken'] == count['divisions'] and
         u['quotients']['taken'] == count['quotients'] and
         u['exact tests of spheres']['taken'] == count['leaf_tests'] and
         u['exact tests of facets']['taken'] == count['facet_tests'] and
         u['memory port']['taken'] == p['memory']['lines'] and
         u['memory port']['clocks'] == 4*p['memory']['lines'] and
         u['rays set up for planes']['taken'] == count['rays_primary'] and
         u['pixels delivered']['taken'] == run['pixels'] - count['background']"
done
# A key takes two clocks, of a plane beyond the grid four; half of the pixels see no plane.
check "hit points bind where the plane is seen, its keys nowhere, and no unit alone" \
    says plane "not p['limit']['binds'] and p['limit']['unit'] == 'points and normals' and
        0.4 < u['points and normals']['binds']/cycles < 0.7 and
        u['keys of facets']['binds'] == 0 and
        2 < u['keys of facets']['clocks']/count['divisions'] < 4"
check "without the plane the set-up of rays for planes binds, three clocks each" says none \
    "p['limit']['binds'] and p['limit']['unit'] == 'rays set up for planes' and
     u['rays set up for planes']['clocks'] == 3*count['rays_primary']"
check "... as the run prints" grep -q \
    '^limit, warm caches: rays set up for planes: busy in [89]' "$TMP/none.said"
check "... of which the clocks of the frame are made" says none \
    "0.8*cycles < u['rays set up for planes']['clocks'] <= cycles"
check "no unit binds where memory is late" says late "not p['limit']['binds'] and
    sum(row['binds'] for row in u.values()) < cycles/2"
check "... as the run prints" grep -q '^limit, cold caches: no single unit: .*none in [5-9]' \
    "$TMP/late.said"
check "no unit binds where pixels are few" says few "not p['limit']['binds'] and
    not any(row['binds'] for row in u.values())"
done_testing
