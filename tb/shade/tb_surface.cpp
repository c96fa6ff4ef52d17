/* tb_surface.cpp - rt_surface, with its dividers and rt_hit, against sph_surface_at(),
 * sph_surface_facet()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot gets a ray, then a hit; the record that its token asks for comes after a random time
 * and in any order. A vector is a surface, or an unlit one while points are off.
 */
#include "Vrt_surface.h"
#include "bench.h"
#include "bundles.h"

extern "C" {
#include "machine/layout.h"
#include "prim/facet.h"
#include "prim/sphere.h"
}

#ifndef POINTS
#define POINTS 1
#endif
#ifndef BOUNCES
#define BOUNCES 1
#endif
#ifndef INSIDE
#define INSIDE 1
#endif

#ifndef FACETS
#define FACETS 0
#endif
#ifndef SPREAD
#define SPREAD 0
#endif
#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef SMOOTH
#define SMOOTH 0
#endif
#ifndef MATERIALS
#define MATERIALS 0
#endif

using bench::u128;

namespace {

const struct sph_profile profile = {PROFILE, W, WD, PQ, NG, 12, 0};
constexpr int64_t MAX = ((int64_t)1 << (W - 1)) - 1, MIN = -MAX - 1;     /* coordinate */
constexpr int64_t DMAX = ((int64_t)1 << (WD - 1)) - 1, DMIN = -DMAX - 1; /* direction */
constexpr uint64_t KMAX = ((uint64_t)1 << (W + WD + 2)) - 1;             /* key */
constexpr uint64_t AMAX = ~(uint64_t)0 >> (64 - 2 * WD);                 /* a */
constexpr uint32_t LINES = 1u << 26, IDS = 0xffffff;

struct Vector {
    uint64_t key, a;
    int64_t org[3], dir[3], ctr[3]; /* ctr: the normal of a facet */
    int far;
    uint32_t id;
    bool facet = false;
};

const Vector corners[] = {
    {1, 1, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, 0, 0},                  /* at the centre: normal -dir */
    {1, 1, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, 1, IDS},                /* the same from inside */
    {1, AMAX, {5, 6, 7}, {DMAX, DMIN, 1}, {5, 6, 7}, 1, 1},         /* smallest t: rounds to org */
    {KMAX, 1, {MAX, MIN, 0}, {DMAX, DMIN, 1}, {MIN, MAX, 0}, 1, 2}, /* largest t: saturates */
    {KMAX, AMAX, {0, 0, 0}, {1, -1, 2}, {3, 3, 3}, 0, 3},           /* largest key and a */
    {1, 1, {MAX, MIN, 0}, {1, -1, 0}, {0, 0, 0}, 0, 4},             /* one step out of the grid */
    {1, 1, {MAX, MIN, 0}, {-1, 1, 0}, {0, 0, 0}, 0, 5},             /* one step into it */
    {1, 2, {MAX, MIN, 0}, {1, -1, 1}, {0, 0, 0}, 0, 6},             /* half a step */
    {1, 8, {0, 0, 0}, {1, -1, 3}, {9, 9, 9}, 0, 7},                 /* half a guard step */
    {3, 4, {MAX, 0, -1}, {1, -1, 1}, {MIN, 0, 0}, 0, 8},       /* normal that rounds up: limited */
    {1, 1, {MIN, MIN, MIN}, {0, 0, 0}, {MAX, MAX, MAX}, 1, 9}, /* longest normal */
};
constexpr size_t CORNERS = sizeof corners / sizeof *corners;

Vector make(bench::Random &random) {
    Vector v{};
    v.far = random.percent(30);
    v.id = (uint32_t)random.mixed(24);
    do {
        v.a = 0;
        for (int i = 0; i < 3; i++) {
            v.org[i] = random.smixed(W);
            v.dir[i] = random.smixed(WD);
            v.ctr[i] = random.smixed(W);
            v.a += (uint64_t)(v.dir[i] * v.dir[i]);
        }
    } while (!v.a);
    int bits = sph_bit_length(v.a) + 1 - (int)random.below(W); /* t of 2^-W to 2, mostly */
    v.key = random.percent(20) ? (uint64_t)random.log_bits(W + WD + 2)
            : bits > 0         ? (uint64_t)random.bits(bits)
                               : 0;
    if (v.key > KMAX) v.key = KMAX;
    if (!v.key) v.key = 1;
    for (int i = 0; i < 3 && random.percent(90); i++) { /* the point lies near the centre */
        int64_t near =
            v.org[i] + (int64_t)((bench::i128)v.dir[i] * (bench::i128)v.key / (bench::i128)v.a);
        near += random.between(-1, 1) * random.between(0, 1000);
        v.ctr[i] = near > MAX ? MAX : near < MIN ? MIN : near;
    }
    return v;
}

struct Slot {
    enum { IDLE, RAY, WAITS, ASKED, FETCHED } state;
    Vector v;
};

int first_bit(int lsb, int) {
    return lsb;
} /* of a field of bundles.h */

u128 pack(const int64_t v[3], int bits) {
    u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((u128)v[i], bits);
    return x;
}

/* The unit, its slots, and the leaf cache that answers it. */
class Run {
  public:
    Run(int argc, char **argv) : b("tb_surface", argc, argv, 100000) {
        bench::put(t.ray_i, RT_RAY_VALID, 0);
        bench::put(t.hit_i, RT_HIT_HIT, 0);
        bench::put(t.record_i, RT_RECORD_VALID, 0);
        t.fetch_ready_i = 0;
        b.reset();
    }

    bool clock() { /* false at the end */
        if (!b.more()) return false;
        if (b.random.percent(1)) {
            ready = b.random.percent(50) ? 100 : (unsigned)b.random.between(2, 50);
            pace = b.random.percent(50) ? 100 : (unsigned)b.random.between(2, 50);
        }
        registers();
        int fresh = give_ray();
        give_hit();
        if (fresh >= 0) slots[fresh].state = Slot::RAY;
        give_record();
        t.fetch_ready_i = b.random.percent(ready);
        b.settle();
        quotients += t.quotient_o;
        take_fetch();
        bool taken = bench::get(t.record_i, RT_RECORD_VALID);
        b.expect("VALID of material_o", bench::get(t.material_o, RT_MATERIAL_VALID), taken, 1);
        if (taken) check_material();
        b.tick();
        b.expect("unlit_valid_o", t.unlit_valid_o, taken && !points, 1);
        check_surface();
        return true;
    }

    int finish() {
        if (quotients > hits || quotients + SLOTS < hits)
            b.fail("quotient_o is not one for each hit");
        return b.finish();
    }

  private:
    bench::Bench<Vrt_surface> b;
    Vrt_surface &t = b.dut;
    Slot slots[SLOTS] = {};
    uint32_t data[8] = {}; /* of record_i */
    size_t corner = 0;
    int answer = 0, quotients = 0, hits = 0;
    unsigned ready = 100, pace = 100; /* percent of clocks with fetch_ready_i, with a record */
    uint32_t base = 0;
    int64_t eye[3] = {};
    bool points = true, facets = false, smooths = false, spreads = false, /* points_on_i, effects */
        drain = true; /* they and the eye change while nothing is inside */

    void registers() {
        bool idle = true;
        for (const Slot &s : slots)
            idle &= s.state == Slot::IDLE;
        if (b.random.percent(1) && b.random.percent(10)) drain = true;
        if (!drain || !idle) return;
        drain = false;
        points = POINTS && b.random.percent(70);
        t.points_on_i = POINTS ? points : b.random.percent(50);
        facets = FACETS && b.random.percent(80);
        uint32_t on = (uint32_t)b.random.bits(SPH_EFFECT_BITS) & ~(1u << SPH_EFFECT_FACETS);
        on |= (uint32_t)(FACETS ? facets : b.random.percent(50)) << SPH_EFFECT_FACETS;
        smooths = on >> SPH_EFFECT_SMOOTH & 1;
        spreads = on >> SPH_EFFECT_SPREAD & 1;
        bench::put(t.regs_i, RT_REGS_EFFECTS, on);
        base = (uint32_t)b.random.below(LINES);
        bench::put(t.regs_i, RT_REGS_PRIM_BASE, base);
        for (int64_t &x : eye)
            x = b.random.smixed(W);
        bench::put(t.regs_i, RT_REGS_EYE, (bench::i128)pack(eye, W));
    }

    /* A ray; its slot, or -1: a shadow ray of the slot is no matter of this module. */
    int give_ray() {
        int at = (int)b.random.below(SLOTS);
        Vector v = make(b.random);
        bool go = slots[at].state == Slot::IDLE && !drain;
        if (go && points && corner < CORNERS) v = corners[corner++];
        for (int i = 0; i < 3 && !BOUNCES; i++)
            v.org[i] = eye[i];
        v.far &= INSIDE | FACETS;
        v.facet = facets && corner == CORNERS && b.random.percent(50);
        for (int i = 0; i < 3 && v.facet; i++)
            v.ctr[i] = b.random.smixed(24);
        bool shadow = !go && b.random.percent(30);
        bench::put(t.ray_i, RT_RAY_VALID, go || shadow);
        bench::put(t.ray_i, RT_RAY_SHADOW, shadow);
        bench::put(t.ray_i, RT_RAY_SLOT, at);
        bench::put(t.ray_i, RT_RAY_ORG, (bench::i128)pack(v.org, W));
        bench::put(t.ray_i, RT_RAY_DIR, (bench::i128)pack(v.dir, WD));
        bench::put(t.ray_i, RT_RAY_A, (bench::i128)v.a);
        if (go) slots[at].v = v;
        return go ? at : -1;
    }

    void give_hit() {
        int at = (int)b.random.below(SLOTS);
        Slot *s = &slots[at];
        bool hit_now = s->state == Slot::RAY;
        bench::put(t.hit_i, RT_HIT_HIT, hit_now);
        bench::put(t.hit_i, RT_HIT_SLOT, at);
        bench::put(t.hit_i, RT_HIT_FAR, s->v.far);
        bench::put(t.hit_i, RT_HIT_ID, s->v.id);
        bench::put(t.hit_i, RT_HIT_KEY, (bench::i128)s->v.key);
        if (!hit_now) return;
        s->state = Slot::WAITS;
        hits += points;
    }

    /* A record as the memory holds it; bits that no one reads are random. */
    void give_record() {
        answer = (int)b.random.below(SLOTS);
        Slot *s = &slots[answer];
        for (uint32_t &word : data)
            word = (uint32_t)b.random.next();
        u128 low = b.random.bits(128);
        for (int i = 0; i < 3; i++) {
            int used = s->v.facet ? 24 : W;
            u128 mask = (((u128)1 << used) - 1) << (24 * i);
            low = (low & ~mask) | bench::low((u128)s->v.ctr[i], used) << (24 * i);
        }
        u128 kinds = (1u << SPH_PRIM_KIND_BITS) - 1; /* of a facet any but 0 */
        u128 kind = s->v.facet ? 1 + b.random.bits(32) % kinds : 0;
        if (facets) low = (low & ~(kinds << SPH_PRIM_KIND_LSB)) | kind << SPH_PRIM_KIND_LSB;
        for (int i = 0; i < 8; i++) {
            if (i < 4) data[i] = (uint32_t)(low >> (32 * i));
            bench::put(t.record_i, first_bit(RT_RECORD_DATA) + 32 * i, 32, data[i]);
        }
        bench::put(t.record_i, RT_RECORD_SLOT, answer);
        bench::put(t.record_i, RT_RECORD_VALID, s->state == Slot::ASKED && b.random.percent(pace));
    }

    /* A token asks for its record. */
    void take_fetch() {
        if (!bench::get(t.fetch_o, RT_FETCH_VALID) || !t.fetch_ready_i) return;
        Slot &e = slots[bench::get(t.fetch_o, RT_FETCH_SLOT)];
        if (e.state != Slot::WAITS) b.fail("a record that no hit asked for");
        b.expect("LINE", bench::get(t.fetch_o, RT_FETCH_LINE), (base + e.v.id) % LINES, 26);
        e.state = Slot::ASKED;
    }

    void check_material() {
        auto field = [&](const char *name, int lsb, int bits, int from, bool built) {
            b.expect(name, bench::get(t.material_o, lsb, bits),
                     built ? sph_field(data, from, bits) : 0, bits);
        };
        b.expect("SLOT", bench::get(t.material_o, RT_MATERIAL_SLOT), answer, SLOTW);
        field("RGB", RT_MATERIAL_RGB, SPH_PRIM_RED_LSB, true);
        field("KR", RT_MATERIAL_KR, SPH_PRIM_KR_LSB, true);
        field("TEX", RT_MATERIAL_TEX, SPH_PRIM_TEX_LSB, TEXTURE);
        field("SMOOTH", RT_MATERIAL_SMOOTH, SPH_PRIM_SMOOTH_LSB, SMOOTH && smooths);
        field("BEND", RT_MATERIAL_BEND, SPH_PRIM_BEND_LSB, SPREAD && spreads);
        field("KT", RT_MATERIAL_KT, SPH_PRIM_KT_LSB, MATERIALS);
        field("SUM", RT_MATERIAL_SUM, SPH_PRIM_SUM_LSB, MATERIALS);
        field("KA", RT_MATERIAL_KA, SPH_PRIM_KA_LSB, MATERIALS);
        field("KD", RT_MATERIAL_KD, SPH_PRIM_KD_LSB, MATERIALS);
        field("KS", RT_MATERIAL_KS, SPH_PRIM_KS_LSB, MATERIALS);
        field("POWER", RT_MATERIAL_POWER, SPH_PRIM_POWER_LSB, MATERIALS);
        field("INDEX", RT_MATERIAL_INDEX, SPH_PRIM_INDEX_LSB, MATERIALS);
        slots[answer].state = Slot::FETCHED;
    }

    /* A surface, unlit or whole, or none. */
    void check_surface() {
        if (t.unlit_valid_o) {
            b.expect("unlit_slot_o", t.unlit_slot_o, answer, SLOTW);
            b.expect("VALID of an unlit surface", bench::get(t.surface_o, RT_SURFACE_VALID), 0, 1);
            slots[answer].state = Slot::IDLE;
            b.done();
        } else if (!bench::get(t.surface_o, RT_SURFACE_VALID)) {
            b.expect("saturated_o without a surface", t.saturated_o, 0, 1);
            if (b.bad()) b.done();
        } else {
            int at = (int)bench::get(t.surface_o, RT_SURFACE_SLOT);
            if (slots[at].state != Slot::FETCHED)
                b.fail("a surface without a record");
            else
                compare(at);
        }
    }

    void compare(int at) {
        Slot &e = slots[at];
        struct sph_ray ray = {};
        struct sph_leaf sphere = {};
        struct sph_surface surface;
        struct sph_hit hit = {e.v.key, e.v.id, e.v.far != 0, 0};
        ray.a = e.v.a;
        for (int i = 0; i < 3; i++) {
            ray.org[i] = e.v.org[i];
            ray.dir[i] = e.v.dir[i];
            sphere.ctr[i] = e.v.ctr[i];
        }
        int saturated = e.v.facet ? sph_surface_facet(&profile, &ray, &hit, e.v.ctr, &surface)
                                  : sph_surface_at(&profile, &ray, &hit, &sphere, &surface);
        b.expect("POINT", bench::get(t.surface_o, RT_SURFACE_POINT),
                 (bench::i128)pack(surface.point, W), 3 * W);
        b.expect("NORMAL", bench::get(t.surface_o, RT_SURFACE_NORMAL),
                 (bench::i128)pack(surface.normal, WD), 3 * WD);
        const int64_t none[3] = {0, 0, 0};
        b.expect("GUARDED", bench::get(t.surface_o, RT_SURFACE_GUARDED),
                 (bench::i128)pack(TEXTURE || SMOOTH ? surface.guarded : none, W + NG),
                 3 * (W + NG));
        sph_surface_spawn(&profile, &surface, &ray);
        b.expect("LIFT", bench::get(t.surface_o, RT_SURFACE_LIFT),
                 (bench::i128)pack(FACETS ? ray.lift : none, NG + 2), 3 * (NG + 2));
        b.expect("FLAT", bench::get(t.surface_o, RT_SURFACE_FLAT), surface.flat, 1);
        b.expect("saturated_o", t.saturated_o, saturated, 1);
        if (b.bad()) {
            b.show("slot", at, SLOTW);
            b.show("KEY", (bench::i128)e.v.key, W + WD + 2);
            b.show("A", (bench::i128)e.v.a, 2 * WD);
            b.show("FAR", e.v.far, 1);
            b.show("facet", e.v.facet, 1);
        }
        for (int i = 0; i < 3 && b.bad(); i++) {
            b.show("org", e.v.org[i], W);
            b.show("dir", e.v.dir[i], WD);
            b.show("ctr", e.v.ctr[i], W);
        }
        e.state = Slot::IDLE;
        b.done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.clock())
        ;
    return run.finish();
}
