/* tb_cosine.cpp - rt_cosine against sph_lambert()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Slots get unit normals, then lights, announced a clock before. A vector is a cosine, and whether
 * its light wants a shadow ray or is decided.
 */
#include <deque>

#include "Vrt_cosine.h"
#include "bench.h"
#include "bundles.h"

extern "C" {
#include "machine/layout.h"
#include "shade/colour.h"
}

namespace {

constexpr uint64_t LATENCY = 5;

struct Light {
    uint64_t due;
    int slot;
    uint32_t cosine;
};

struct sph_unit random_unit(bench::Random &random, const struct sph_unit *near) {
    int64_t v[3];
    for (int i = 0; i < 3; i++) {
        v[i] = random.percent(20) ? 0 : random.smixed(18);
        if (near) v[i] = near->u[i] / 2 + random.between(-3, 3);
    }
    return sph_unit(v, (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), 18);
}

bench::i128 pack(const struct sph_unit &u) {
    bench::u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << 18 | bench::low((bench::u128)u.u[i], 18);
    return (bench::i128)x;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_cosine> b("tb_cosine", argc, argv);
    struct sph_unit normals[SLOTS] = {}, light = {};
    bool has[SLOTS] = {}, announced = false, on = true;
    int next = 0, idle = 0;
    std::deque<Light> lights;
    b.reset();
    while (b.more()) {
        /* the light that was announced; or a normal */
        int slot = announced ? next : (int)b.random.below(SLOTS);
        bool normal = !announced && b.random.percent(30);
        if (announced) {
            light = random_unit(b.random, b.random.percent(40) ? &normals[slot] : nullptr);
            lights.push_back({b.cycle + LATENCY, slot, sph_lambert(&normals[slot], &light)});
        }
        if (normal) {
            normals[slot] = light = random_unit(b.random, nullptr);
            has[slot] = true;
        }
        bench::noise(b.dut.ray_i, RT_RAY_BITS, b.random);
        bench::put(b.dut.ray_i, RT_RAY_NORMAL, normal);
        bench::put(b.dut.ray_i, RT_RAY_LIGHT, announced);
        bench::put(b.dut.ray_i, RT_RAY_SLOT, slot);
        bench::put(b.dut.ray_i, RT_RAY_UNIT, pack(light));
        /* at most every second clock, of a slot whose normal is written */
        int fresh = normal ? slot : -1;
        next = (int)b.random.below(SLOTS);
        announced = !announced && has[next] && next != fresh && b.random.percent(60);
        b.dut.next_light_i = announced;
        b.dut.next_slot_i = (decltype(b.dut.next_slot_i))next;
        if (lights.empty() && ++idle > 20) {
            on = b.random.percent(60);
            idle = 0;
        }
        b.dut.shadow_on_i = on;
        b.tick();
        bool due = !lights.empty() && lights.front().due == b.cycle;
        b.expect("out_valid_o", b.dut.out_valid_o, due, 1);
        b.expect("shadow_go_o or unshadowed_valid_o", b.dut.shadow_go_o + b.dut.unshadowed_valid_o,
                 due, 2);
        if (!due) {
            if (b.bad()) b.done();
            continue;
        }
        const Light e = lights.front();
        lights.pop_front();
        bool trace = SHADOW && on && e.cosine;
        b.expect("out_slot_o", b.dut.out_slot_o, e.slot, SLOTW);
        b.expect("out_cosine_o", b.dut.out_cosine_o, e.cosine, 16);
        b.expect("shadow_go_o", b.dut.shadow_go_o, trace, 1);
        if (!trace) b.expect("unshadowed_lit_o", b.dut.unshadowed_lit_o, e.cosine != 0, 1);
        b.done();
    }
    return b.finish();
}
