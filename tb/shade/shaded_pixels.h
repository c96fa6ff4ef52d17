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

#include "shade/shaded_rays.h"

extern "C" {
#include "engine/render_pixel.h"
}

namespace {

constexpr int EVENTS = 8; /* that are counted */

struct Fetch {
    int slot;
    uint32_t line;
};

class Shade : public ShadedRays {
  public:
    Shade(const char *name, int argc, char **argv, long pixels)
        : ShadedRays(name, argc, argv, pixels), memory(*this, world) {
        dut.flush_i = dut.read_i = 0;
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

    /* Nothing is under way: a reset, other colours and effects. */
    void phase() {
        if (random.percent(20))
            for (int i = 0; i < 20; i++)
                interrupt();
        change();
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
    world::Memory<Top, SHADES> memory;
    std::vector<Fetch> fetches[SHADES];
    struct sph_counters counters = {};
    uint32_t errors = 0, faults = 0;
    uint64_t seen[EVENTS] = {};
    int reading = -1;
    unsigned pace = 100;

    /* No ray, no hit, no record comes. */
    void nothing() {
        for (int unit = 0; unit < SHADES; unit++)
            put_record(unit, RT_RECORD_VALID, 0);
        parts::no_ray(dut.ray_i);
        no_hit();
    }

    /* Pixels are begun, and a reset ends them. */
    void interrupt() {
        for (uint64_t i = random.below(300); i; i--)
            clock(true);
        nothing();
        reset(1 + random.below(3));
        for (Slot &s : slots)
            s = Slot();
        forget();
        for (std::vector<Fetch> &asked : fetches)
            asked.clear();
        memory.forget();
        counters = {};
        std::fill(std::begin(seen), std::end(seen), 0);
        errors = faults = 0, reading = -1;
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
