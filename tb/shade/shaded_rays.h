/* shaded_rays.h - rt_setup and rt_trace as shaded_pixels.h stands in for them
 * SPDX-License-Identifier: Apache-2.0
 *
 * Who includes this has named the module `Top`.
 */
#ifndef TB_SHADED_RAYS_H
#define TB_SHADED_RAYS_H

#include "shade/shaded_scene.h"

namespace {

constexpr uint64_t BLEND = SUM || REFRACT ? 12 : 4; /* clocks a surface */
constexpr uint64_t SETUP = 12;                      /* clocks from a vector to its ray, at least */

struct Slot {
    bool used = false, ends = false;
    bool again = false;               /* the primary ray is repeated, nearest first */
    bool probe = false, last = false; /* of the surface that was blended last */
    int far = 0;                      /* the primary ray hit a sphere from inside */
    uint64_t missed = 0, before = 0;  /* cycle of a miss that is not blended yet; blended before */
    int x = 0, y = 0;
    struct sph_ray ray = {}, light = {}; /* the ray whose surfaces are shaded; to a light */
    int64_t org[3] = {};
    struct sph_skip skip = {};
    struct sph_pixel pixel = {};
};

enum Kind { RAY, NORMAL, LIGHT };

struct Vector { /* under way in rt_setup */
    Kind kind;
    int slot;
    int64_t v[3];
    bool primary;
    uint64_t due;
};

struct Traced { /* a ray that rt_trace has */
    int slot;
    bool shadow;
    uint64_t due;
};

class ShadedRays : public ShadedScene {
  protected:
    using ShadedScene::ShadedScene;

    void no_hit() {
        bench::put(dut.hit_i, RT_HIT_HIT, 0);
        bench::put(dut.hit_i, RT_HIT_MISS, 0);
        bench::put(dut.hit_i, RT_HIT_SHADOW, 0);
    }

    /* No vector and no ray is under way. */
    void forget() {
        for (int unit = 0; unit < SETUPS; unit++) {
            vectors[unit].clear();
            announced[unit] = 0, lit[unit] = false;
        }
        traced.clear();
    }

    /* What rt_interpenetrate keeps of a surface that is blended. Background waits for none but
     * those that are blended before it, one every BLEND clocks. */
    void blended() {
        if (!bench::get(dut.blend_o, RT_BLEND_VALID)) return;
        Slot &s = slots[bench::get(dut.blend_o, RT_BLEND_SLOT)];
        blends++;
        if (s.missed && cycle - s.missed > BLEND * (blends - s.before) + 12)
            fail("background waits for too long");
        s.missed = 0;
        s.probe = bench::get(dut.blend_o, RT_BLEND_PROBE) != 0;
        s.last = bench::get(dut.blend_o, RT_BLEND_LAST) != 0;
    }

    void send_primary(int at) {
        Vector v = {RAY, at, {}, true, cycle};
        sph_primary_dir(&world.m, slots[at].x, slots[at].y, v.v);
        vectors[parts::setups.of(at)].push_back(v);
    }

    template <class Port> void take_vector(const Port &port, int unit, Kind kind) {
        auto field = [&](int lsb, int bits) {
            return parts::shades.get(port, unit, RT_VECTOR_BITS, lsb, bits);
        };
        if (!field(RT_VECTOR_VALID)) return;
        int slot = parts::shades.slot(port, unit, RT_VECTOR_BITS, RT_VECTOR_SLOT);
        Vector v = {kind, slot, {}, false, cycle + SETUP};
        if (!slots[v.slot].used) return fail("a vector of a slot that is free");
        for (int i = 0; i < 3; i++)
            v.v[i] = (int64_t)bench::sign(field(RT_VECTOR_VEC) >> (WD * i), WD);
        vectors[parts::setups.of(v.slot)].push_back(v);
    }

    void setup(int unit) {
        if (announced[unit]) {
            emit(unit, (size_t)announced[unit] - 1);
            announced[unit] = 0;
            lit[unit] = true;
            return;
        }
        bool wait = lit[unit];
        lit[unit] = false;
        const std::vector<Vector> &waiting = vectors[unit];
        if (waiting.empty() || !random.percent(80)) return;
        size_t n = (size_t)random.below(waiting.size());
        const Vector &v = waiting[n];
        if (v.due > cycle || (wait && v.kind == LIGHT)) return;
        if (v.kind == LIGHT) {
            const int own = parts::setups.own();
            announced[unit] = 1 + (int)n;
            bench::put(dut.next_light_i, unit, 1, 1);
            bench::put(dut.next_slot_i, unit * own, own, v.slot);
            return;
        }
        emit(unit, n);
    }

    void trace() {
        no_hit();
        if (traced.empty() || (tides && cycle % 256 >= 32)) return;
        size_t n = (size_t)random.below(traced.size());
        const Traced t = traced[n];
        if (t.due > cycle) return;
        traced.erase(traced.begin() + (long)n);
        const Slot &s = slots[t.slot];
        uint32_t visits = 0, bad = 0;
        struct sph_hit hit = sph_traverse(&world.m, t.shadow ? &s.light : &s.ray, SPH_TRAVERSE_TREE,
                                          &ours, &visits, &bad);
        if (PROBES && !t.shadow && probed(t.slot, hit)) return;
        bench::put(dut.hit_i, RT_HIT_SLOT, t.slot);
        bench::put(dut.hit_i, RT_HIT_LIT, !hit.key);
        bench::put(dut.hit_i, RT_HIT_FIRST, s.ray.kind == SPH_PRIMARY);
        bench::put(dut.hit_i, RT_HIT_PROBE,
                   PROBES && s.ray.first && world.on(SPH_EFFECT_INTERPENETRATE));
        bench::put(dut.hit_i, RT_HIT_FAR, hit.far);
        bench::put(dut.hit_i, RT_HIT_ID, hit.id);
        bench::put(dut.hit_i, RT_HIT_KEY, (bench::i128)hit.key);
        if (t.shadow)
            bench::put(dut.hit_i, RT_HIT_SHADOW, 1);
        else if (hit.key)
            bench::put(dut.hit_i, RT_HIT_HIT, 1);
        else
            bench::put(dut.hit_i, RT_HIT_MISS, 1);
        slots[t.slot].missed = t.shadow || hit.key ? 0 : cycle;
        slots[t.slot].before = blends;
    }

    Slot slots[SLOTS];
    std::vector<Traced> traced;
    bool tides = false; /* rays that hit or miss come many at a time */

  private:
    std::vector<Vector> vectors[SETUPS];
    struct sph_counters ours = {};
    int announced[SETUPS] = {}; /* 1 + number in vectors: a light that comes in this clock */
    bool lit[SETUPS] = {};      /* a light came in the clock before */
    uint64_t blends = 0;        /* surfaces so far */

    /* Whether a mirror ray was a probe that ends its pixel, or has it begin again. */
    bool probed(int at, const struct sph_hit &hit) {
        Slot &s = slots[at];
        if (s.ray.kind == SPH_PRIMARY) s.far = hit.far;
        if (s.ray.kind == SPH_PRIMARY || !s.probe) return false;
        s.probe = false;
        bool inside = hit.key && hit.fars > s.far;
        if (inside) {
            s.again = true;
            send_primary(at);
        } else {
            s.ends = s.last;
        }
        return inside || s.last;
    }

    struct sph_ray make(const Vector &v, int kind) {
        const Slot &s = slots[v.slot];
        struct sph_ray r = {};
        r.kind = kind;
        r.inside = world.on(SPH_EFFECT_INSIDE);
        r.first = kind == SPH_PRIMARY && !s.again && world.on(SPH_EFFECT_FIRST);
        r.skip = {SPH_ID_NONE, 0};
        if (kind != SPH_PRIMARY) r.skip = s.skip;
        for (int i = 0; i < 3; i++) {
            r.org[i] = kind == SPH_PRIMARY ? world.m.regs[SPH_REG_EYE_X + i] : s.org[i];
            r.dir[i] = v.v[i];
        }
        sph_ray_setup(&world.p, &r);
        return r;
    }

    void emit(int unit, size_t n) {
        const Vector v = vectors[unit][n];
        vectors[unit].erase(vectors[unit].begin() + (long)n);
        Slot &s = slots[v.slot];
        struct sph_ray r = make(v, v.kind == LIGHT ? SPH_SHADOW
                                   : v.primary     ? SPH_PRIMARY
                                                   : SPH_REFLECTED);
        parts::put_ray(dut.ray_i, v.slot, r);
        parts::put_in_ray(dut.ray_i, v.slot, RT_RAY_NORMAL, v.kind == NORMAL);
        parts::put_in_ray(dut.ray_i, v.slot, RT_RAY_LIGHT, v.kind == LIGHT);
        parts::put_in_ray(dut.ray_i, v.slot, RT_RAY_VALID,
                          v.kind == RAY || (v.kind == LIGHT && SHADOW));
        if (v.kind == LIGHT) s.light = r;
        if (v.kind != RAY) return;
        s.ray = r;
        traced.push_back({v.slot, false, cycle + 10 + random.below(100)});
    }
};

} // namespace

#endif
