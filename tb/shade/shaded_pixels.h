/* shaded_pixels.h - rt_shade or rt_shades, with all that is inside, against sph_render_pixel()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The bench stands in for the other groups with the model's functions: rt_setup makes rays of the
 * vectors that come, rt_trace finds what they hit, rt_leaf_unit gives records, rt_slots probes
 * surfaces that first hits found, and reads the colours of pixels that are complete. All of it
 * takes its time, so that slots overtake each other. In each phase colours and shares of light are
 * others; some begin with pixels that a reset ends. A vector is a pixel. Who includes this has
 * named the module `Top`; with one unit it may be rt_shade.
 */
#ifndef TB_SHADED_PIXELS_H
#define TB_SHADED_PIXELS_H

#include <set>

#include "engine/parts.h"
#include "engine/world.h"

extern "C" {
#include "engine/render_pixel.h"
#include "texture/lookup.h"
}

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef DEEP
#define DEEP 3
#endif
#ifndef LIGHTS
#define LIGHTS 8
#endif
#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef FACETS
#define FACETS 0
#endif
#ifndef REFRACT
#define REFRACT 0
#endif
#ifndef SUM
#define SUM 0
#endif
#ifndef INTERPENETRATE
#define INTERPENETRATE 1
#endif

namespace {

constexpr uint64_t BLEND = SUM || REFRACT ? 12 : 4; /* clocks a surface */
constexpr int EVENTS = 8;                           /* that are counted */
/* Surfaces are probed: by one unit, and first hits are of spheres. */
constexpr bool PROBES = INTERPENETRATE && SHADES == 1 && !FACETS;
constexpr uint64_t SETUP = 12; /* clocks from a vector to its ray, at least */

struct Slot {
    bool used = false, ends = false;
    bool again = false;               /* the primary ray is repeated, nearest first */
    bool probe = false, last = false; /* of the surface that was blended last */
    uint32_t first = SPH_ID_NONE;     /* what the primary ray hit */
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

struct Fetch {
    int slot;
    uint32_t line;
};

class Shade : public bench::Bench<Top> {
  public:
    Shade(const char *name, int argc, char **argv, long pixels)
        : Bench(name, argc, argv, pixels), world(0, DEEP), memory(*this, world),
          effects(world.m.regs[SPH_REG_EFFECTS]), depth(world.m.regs[SPH_REG_MAX_DEPTH]),
          lights(world.m.regs[SPH_REG_N_LIGHTS]) {
        if (TEXTURE) scatter();
        dut.flush_i = dut.read_i = 0;
        bench::put(dut.light_i, RT_LIGHT_VALID, 0);
        nothing();
        world.put_regs(dut.regs_i);
    }

    void clock(bool start) {
        if (start) begin_pixel();
        parts::no_ray(dut.ray_i);
        dut.next_light_i = 0;
        for (int unit = 0; unit < SETUPS; unit++)
            setup(unit);
        trace();
        for (int unit = 0; unit < SHADES; unit++) {
            records(unit);
            bench::put(dut.fetch_ready_i, unit, 1, random.percent(pace));
        }
        int read = reading < 0 ? to_read() : -1;
        dut.read_i = read >= 0;
        dut.read_slot_i = (uint8_t)(read >= 0 ? read : 0);
        memory.before();
        if (reading >= 0) check_pixel();
        reading = read;
        for (int unit = 0; unit < SHADES; unit++) {
            take(unit);
            count(unit);
        }
        if (dut.end_valid_o) {
            Slot &s = slots[dut.end_slot_o];
            if (!s.used || s.ends) return fail("a pixel that ends twice");
            s.ends = true;
        }
        if (SHADES == 1) blended();
        faults |= dut.fault_o;
        tick();
        for (int unit = 0; unit < SHADES; unit++)
            put_record(unit, RT_RECORD_VALID, 0);
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.used) return false;
        return true;
    }

    /* Nothing is under way: effects are switched on and off. */
    void phase() {
        if (random.percent(20))
            for (int i = 0; i < 20; i++)
                interrupt();
        paint();
        write_lights();
        static const int switched[] = {SPH_EFFECT_SHADOW,   SPH_EFFECT_REFLECT, SPH_EFFECT_REFRACT,
                                       SPH_EFFECT_SPECULAR, SPH_EFFECT_SUM,     SPH_EFFECT_TEXTURE};
        world.m.regs[SPH_REG_EFFECTS] = effects;
        for (int effect : switched)
            if (random.percent(effect == SPH_EFFECT_SHADOW ? 40 : 20))
                world.m.regs[SPH_REG_EFFECTS] &= ~(1 << effect);
        if (PROBES && random.percent(40))
            world.m.regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_INTERPENETRATE;
        world.m.regs[SPH_REG_N_LIGHTS] =
            random.percent(70) ? lights : (int32_t)random.below((uint64_t)lights + 1);
        if (random.percent(15)) bare();
        world.m.regs[SPH_REG_BG_COLOUR] = (int32_t)random.mixed(24);
        for (int i = 0; i < 3; i++)
            world.m.regs[SPH_REG_AMBIENT_R + i] = (int32_t)random.log_bits(16);
        world.m.regs[SPH_REG_MAX_DEPTH] = random.percent(60) ? depth : (int32_t)random.below(4);
        world.m.regs[SPH_REG_LEAST_WEIGHT] = random.percent(60) ? 0 : (int32_t)random.below(257);
        if (TEXTURE) world.m.regs[SPH_REG_TEX_FILTER] = (int32_t)random.below(SPH_FILTERS);
        world.put_regs(dut.regs_i);
        pace = random.percent(50) ? 100 : (unsigned)random.between(3, 60);
        tides = random.percent(20);
    }

    void compare() {
        for (int i = 0; i < 100; i++)
            clock(false);
        static const int both[] = {SPH_COUNT_RAYS_PRIMARY,   SPH_COUNT_RAYS_SHADOW,
                                   SPH_COUNT_RAYS_REFLECTED, SPH_COUNT_RAYS_REFRACTED,
                                   SPH_COUNT_QUOTIENTS,      SPH_COUNT_SATURATIONS,
                                   SPH_COUNT_POWERS,         SPH_COUNT_TEXELS};
        for (int i = 0; i < EVENTS; i++)
            expect("events", (bench::i128)seen[i], (bench::i128)counters.count[both[i]], 64);
        if (bad()) show("counter", 0, 8);
        expect("fault_o", faults, errors, 4);
        if (bad()) done();
    }

  private:
    world::World world;
    world::Memory<Top, SHADES> memory;
    const int32_t effects, depth, lights; /* as the scene wants them */
    Slot slots[SLOTS];
    std::vector<Vector> vectors[SETUPS];
    std::vector<Traced> traced;
    std::vector<Fetch> fetches[SHADES];
    struct sph_counters counters = {}, ours = {};
    uint32_t errors = 0, faults = 0;
    uint64_t seen[EVENTS] = {};
    int announced[SETUPS] = {}; /* 1 + number in vectors: a light that comes in this clock */
    bool lit[SETUPS] = {};      /* a light came in the clock before */
    int reading = -1;
    unsigned pace = 100;
    bool tides = false;  /* rays that hit or miss come many at a time */
    uint64_t blends = 0; /* surfaces so far */

    /* Images of textures lie anywhere in memory. */
    void scatter() {
        std::set<uint32_t> maps;
        world.repeat();
        for (int32_t i = 0; i < world.m.regs[SPH_REG_N_PRIMS]; i++) {
            uint32_t map = sph_field(prim(i), SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
            if (!map || !maps.insert(map).second) continue;
            uint32_t *record = sph_line(&world.m, map);
            uint32_t image = sph_field(record, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
            image += world::Repeated::ALIKE * (uint32_t)random.mixed(world::Repeated::PART_BITS);
            sph_field_set(record, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, image);
        }
    }

    uint32_t *prim(int32_t id) {
        return sph_line(&world.m, (uint32_t)(world.m.regs[SPH_REG_PRIM_BASE] + id));
    }

    /* Each primitive gets a colour and shares of light, each light a colour, mostly a bright one;
     * highlights are mostly wide. */
    void paint() {
        for (int32_t i = 0; i < world.m.regs[SPH_REG_N_PRIMS]; i++) {
            auto put = [&](int lsb, int bits, bench::u128 x) {
                sph_field_set(prim(i), lsb, bits, (uint32_t)x);
            };
            put(SPH_PRIM_RED_LSB, 24, random.bits(24));
            put(SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS, random.log_bits(SPH_PRIM_KA_BITS));
            put(SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS, random.log_bits(SPH_PRIM_KD_BITS));
            put(SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS, random.bits(SPH_PRIM_KS_BITS));
            put(SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS,
                random.log_bits(random.percent(50) ? 3 : SPH_PRIM_POWER_BITS));
        }
        for (int l = 0; l < lights; l++)
            for (int c = SPH_REG_LIGHT0_R; c <= SPH_REG_LIGHT0_B; c++) {
                int32_t &reg = world.m.regs[c + l * SPH_LIGHT_STRIDE];
                uint32_t colour = (uint32_t)random.bits(random.percent(70) ? 16 : 15);
                reg = (int32_t)(((uint32_t)reg & ~0xffffu) | colour);
            }
    }

    void write_lights() {
        for (int l = 0; l < lights; l++)
            for (int part = 0; part < 6; part++) {
                bench::put(dut.light_i, RT_LIGHT_VALID, 1);
                bench::put(dut.light_i, RT_LIGHT_NUMBER, l);
                bench::put(dut.light_i, RT_LIGHT_PART, part);
                bench::put(dut.light_i, RT_LIGHT_DATA,
                           world.m.regs[SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE + part]);
                tick();
            }
        bench::put(dut.light_i, RT_LIGHT_VALID, 0);
    }

    /* Nothing asks for a surface's point. */
    void bare() {
        world.m.regs[SPH_REG_N_LIGHTS] = 0;
        for (int effect : {SPH_EFFECT_REFLECT, SPH_EFFECT_INTERPENETRATE, SPH_EFFECT_FIRST,
                           SPH_EFFECT_REFRACT, SPH_EFFECT_TEXTURE})
            world.m.regs[SPH_REG_EFFECTS] &= ~(1 << effect);
    }

    /* No ray, no hit, no record comes. */
    void nothing() {
        for (int unit = 0; unit < SHADES; unit++)
            put_record(unit, RT_RECORD_VALID, 0);
        parts::no_ray(dut.ray_i);
        no_hit();
    }

    void no_hit() {
        bench::put(dut.hit_i, RT_HIT_HIT, 0);
        bench::put(dut.hit_i, RT_HIT_MISS, 0);
        bench::put(dut.hit_i, RT_HIT_SHADOW, 0);
    }

    /* Pixels are begun, and a reset ends them. */
    void interrupt() {
        for (uint64_t i = random.below(300); i; i--)
            clock(true);
        nothing();
        reset(1 + random.below(3));
        for (Slot &s : slots)
            s = Slot();
        for (int unit = 0; unit < SETUPS; unit++) {
            vectors[unit].clear();
            announced[unit] = 0, lit[unit] = false;
        }
        for (std::vector<Fetch> &asked : fetches)
            asked.clear();
        traced.clear();
        memory.forget();
        counters = {};
        std::fill(std::begin(seen), std::end(seen), 0);
        errors = faults = 0, reading = -1;
    }

    /* What rt_probe keeps of a surface that is blended. Background waits for none but those that
     * are blended before it, one every BLEND clocks. */
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

    /* Whether a mirror ray was a probe that ends its pixel, or has it begin again. */
    bool probed(int at, const struct sph_hit &hit) {
        Slot &s = slots[at];
        if (s.ray.kind == SPH_PRIMARY) s.first = hit.id;
        if (s.ray.kind == SPH_PRIMARY || !s.probe) return false;
        s.probe = false;
        bool inside = hit.key && hit.far && hit.id != s.first;
        if (inside) {
            s.again = true;
            send_primary(at);
        } else {
            s.ends = s.last;
        }
        return inside || s.last;
    }

    void send_primary(int at) {
        Vector v = {RAY, at, {}, true, cycle};
        sph_primary_dir(&world.m, slots[at].x, slots[at].y, v.v);
        vectors[parts::setups.of(at)].push_back(v);
    }

    bool record(int unit) const {
        return parts::shades.get(dut.record_i, unit, RT_RECORD_BITS, RT_RECORD_VALID) != 0;
    }
    void put_record(int unit, int lsb, int bits, bench::i128 value) {
        parts::shades.put(dut.record_i, unit, RT_RECORD_BITS, lsb, bits, value);
    }

    /* A pixel whose primary ray hits something takes a free slot. */
    void begin_pixel() {
        int at = (int)random.below(SLOTS);
        Slot &s = slots[at];
        if (s.used || !random.percent(pace)) return;
        struct sph_render_options o = {};
        struct sph_counters c = counters;
        s = Slot();
        s.x = (int)random.below(world::WIDTH);
        s.y = (int)random.below(world::HEIGHT);
        s.pixel = sph_render_pixel(&world.m, &o, s.x, s.y, &c, &errors, nullptr);
        if (s.pixel.id == SPH_ID_NONE) return; /* no matter of rt_shade */
        counters = c;
        s.used = true;
        send_primary(at);
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

    void records(int unit) {
        std::vector<Fetch> &asked = fetches[unit];
        if (record(unit) || asked.empty() || !random.percent(pace)) return;
        size_t n = (size_t)random.below(asked.size());
        const Fetch f = asked[n];
        asked.erase(asked.begin() + (long)n);
        put_record(unit, RT_RECORD_VALID, 1);
        parts::shades.put_slot(dut.record_i, unit, RT_RECORD_BITS, RT_RECORD_SLOT, f.slot);
        for (int i = 0; i < 8; i++)
            put_record(unit, world::first_bit(RT_RECORD_DATA) + 32 * i, 32, world.line(f.line)[i]);
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

    /* What a unit gives in this clock. */
    void take(int unit) {
        const parts::Units &u = parts::shades;
        take_vector(dut.normal_o, unit, NORMAL);
        take_vector(dut.vec_light_o, unit, LIGHT);
        take_vector(dut.bounce_o, unit, RAY);
        auto org = [&](int lsb, int bits) {
            return u.get(dut.org_o, unit, RT_ORG_BITS, lsb, bits);
        };
        if (org(RT_ORG_VALID)) {
            Slot &s = slots[u.slot(dut.org_o, unit, RT_ORG_BITS, RT_ORG_SLOT)];
            for (int i = 0; i < 3; i++)
                s.org[i] = (int64_t)bench::sign(org(RT_ORG_POINT) >> (W * i), W);
        }
        auto skip = [&](int lsb, int bits) {
            return u.get(dut.skip_o, unit, RT_SKIP_BITS, lsb, bits);
        };
        if (skip(RT_SKIP_VALID))
            slots[u.slot(dut.skip_o, unit, RT_SKIP_BITS, RT_SKIP_SLOT)].skip = {
                (uint32_t)skip(RT_SKIP_ID), (int)skip(RT_SKIP_INSIDE)};
        if (dut.shadow_go_o >> unit & 1) {
            int own = (int)bench::get(dut.shadow_slot_o, unit * u.own(), u.own());
            traced.push_back({unit << u.own() | own, true, cycle + 10 + random.below(100)});
        }
        auto fetch = [&](int lsb, int bits) {
            return u.get(dut.fetch_o, unit, RT_FETCH_BITS, lsb, bits);
        };
        if (fetch(RT_FETCH_VALID) && dut.fetch_ready_i >> unit & 1) {
            uint32_t line = (uint32_t)fetch(RT_FETCH_LINE);
            if (line >= world.m.lines) return fail("a record behind the end of memory");
            fetches[unit].push_back(
                {u.slot(dut.fetch_o, unit, RT_FETCH_BITS, RT_FETCH_SLOT), line});
        }
    }

    void count(int unit) {
        auto event = [&](int lsb, int bits) {
            return (uint64_t)bench::get(dut.event_o, RT_SHADE_EVENT_BITS * unit + lsb, bits);
        };
        seen[0] += event(RT_SHADE_EVENT_PRIMARY);
        seen[1] += event(RT_SHADE_EVENT_SHADOW);
        seen[2] += event(RT_SHADE_EVENT_REFLECTED);
        seen[3] += event(RT_SHADE_EVENT_REFRACTED);
        seen[4] += event(RT_SHADE_EVENT_QUOTIENT);
        seen[5] += event(RT_SHADE_EVENT_SATURATED);
        seen[6] += event(RT_SHADE_EVENT_POWER);
        seen[7] += event(RT_SHADE_EVENT_TEXEL);
    }

    int to_read() {
        int at = (int)random.below(SLOTS);
        return slots[at].used && slots[at].ends ? at : -1;
    }

    void check_pixel() {
        Slot &s = slots[reading];
        for (int i = 0; i < SPH_FRAMES; i++)
            expect("colour_o", (bench::i128)(get(dut.colour_o) >> (24 * i) & 0xffffff),
                   s.pixel.colour[i], 24);
        expect("texture_o", dut.texture_o, s.pixel.texture, 32);
        if (bad()) show("x", s.x, 14), show("y", s.y, 14), show("slot", reading, SLOTW);
        s.used = false;
        done();
    }
};

/* The bench: its exit status. */
int run(Shade &b) {
    b.reset();
    bench::phases(b, 500, 5000, 200000, "a pixel got lost");
    return b.finish();
}

} // namespace

#endif
