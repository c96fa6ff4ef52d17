/* tb_surface.cpp - rt_surface, with its dividers and rt_hit, against sph_surface_at(),
 * sph_surface_facet()
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every slot gets a ray, then a hit; the record that its token asks for comes after a random time
 * and in any order. A vector is a surface, or a bare one while points are off.
 */
#include "Vrt_surface.h"
#include "bench.h"

extern "C" {
#include "machine/layout.h"
#include "shade/surface.h"
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
#ifndef TEXTURE
#define TEXTURE 0
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

u128 pack(const int64_t v[3], int bits) {
    u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((u128)v[i], bits);
    return x;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_surface> b("tb_surface", argc, argv, 100000);
    Slot slots[SLOTS] = {};
    size_t corner = 0;
    int answer = 0, quotients = 0, hits = 0;
    unsigned ready = 100, pace = 100; /* percent of clocks with prim_ready_i, with a record */
    const uint32_t base = (uint32_t)b.random.below(LINES);
    int64_t eye[3] = {};
    bool points = true, facets = false, /* points_on_i, facets_on_i */
        drain = true;                   /* they and the eye change while nothing is inside */
    b.set(b.dut.prim_base_i, 26, base);
    b.dut.ray_valid_i = b.dut.in_valid_i = b.dut.prim_valid_i = b.dut.prim_ready_i = 0;
    b.reset();
    while (b.more()) {
        if (b.random.percent(1)) {
            ready = b.random.percent(50) ? 100 : (unsigned)b.random.between(2, 50);
            pace = b.random.percent(50) ? 100 : (unsigned)b.random.between(2, 50);
        }
        bool idle = true;
        for (const Slot &s : slots)
            idle &= s.state == Slot::IDLE;
        if (b.random.percent(1) && b.random.percent(10)) drain = true;
        if (drain && idle) {
            drain = false;
            points = POINTS && b.random.percent(70);
            b.dut.points_on_i = POINTS ? points : b.random.percent(50);
            facets = FACETS && b.random.percent(80);
            b.dut.facets_on_i = FACETS ? facets : b.random.percent(50);
            for (int64_t &x : eye)
                x = b.random.smixed(W);
            b.set(b.dut.eye_i, 3 * W, (bench::i128)pack(eye, W));
        }
        /* a ray */
        int at = (int)b.random.below(SLOTS);
        Slot *s = &slots[at];
        Vector v = make(b.random);
        b.dut.ray_valid_i = s->state == Slot::IDLE && !drain;
        if (b.dut.ray_valid_i && points && corner < CORNERS) v = corners[corner++];
        for (int i = 0; i < 3 && !BOUNCES; i++)
            v.org[i] = eye[i];
        v.far &= INSIDE | FACETS;
        v.facet = facets && corner == CORNERS && b.random.percent(50);
        for (int i = 0; i < 3 && v.facet; i++)
            v.ctr[i] = b.random.smixed(24);
        b.dut.ray_slot_i = (uint8_t)at;
        b.set(b.dut.ray_org_i, 3 * W, (bench::i128)pack(v.org, W));
        b.set(b.dut.ray_dir_i, 3 * WD, (bench::i128)pack(v.dir, WD));
        b.set(b.dut.ray_a_i, 2 * WD, (bench::i128)v.a);
        int fresh = b.dut.ray_valid_i ? at : -1;
        if (fresh >= 0) s->v = v;
        /* its hit */
        at = (int)b.random.below(SLOTS);
        s = &slots[at];
        b.dut.in_valid_i = s->state == Slot::RAY;
        b.dut.in_slot_i = (uint8_t)at;
        b.dut.in_far_i = (uint8_t)s->v.far;
        b.set(b.dut.in_id_i, 24, s->v.id);
        b.set(b.dut.in_key_i, W + WD + 2, (bench::i128)s->v.key);
        if (b.dut.in_valid_i) {
            s->state = Slot::WAITS;
            hits += points;
        }
        if (fresh >= 0) slots[fresh].state = Slot::RAY;
        /* its record, as the memory holds it; bits that no one reads are random */
        if (!b.dut.prim_valid_i) {
            answer = (int)b.random.below(SLOTS);
            s = &slots[answer];
            b.dut.prim_valid_i = s->state == Slot::ASKED && b.random.percent(pace);
            b.dut.prim_slot_i = (uint8_t)answer;
            for (int i = 0; i < 8; i++)
                b.dut.prim_data_i[i] = (uint32_t)b.random.next();
            u128 low = b.random.bits(128);
            for (int i = 0; i < 3; i++) {
                int used = s->v.facet ? 24 : W;
                u128 mask = (((u128)1 << used) - 1) << (24 * i);
                low = (low & ~mask) | bench::low((u128)s->v.ctr[i], used) << (24 * i);
            }
            u128 bit = (u128)1 << SPH_PRIM_FACET_LSB;
            if (facets) low = s->v.facet ? low | bit : low & ~bit;
            for (int i = 0; i < 4; i++)
                b.dut.prim_data_i[i] = (uint32_t)(low >> (32 * i));
        }
        b.dut.prim_ready_i = b.random.percent(ready);
        b.settle();
        quotients += b.dut.quotient_o;
        if (b.dut.prim_valid_o && b.dut.prim_ready_i) { /* a token asks for its record */
            Slot &e = slots[b.dut.prim_slot_o];
            if (e.state != Slot::WAITS) b.fail("a record that no hit asked for");
            b.expect("prim_line_o", b.get(b.dut.prim_line_o), (base + e.v.id) % LINES, 26);
            e.state = Slot::ASKED;
        }
        bool taken = b.dut.prim_valid_i && b.dut.prim_ready_o;
        b.expect("material_valid_o", b.dut.material_valid_o, taken, 1);
        if (taken) {
            static_assert(SPH_PRIM_RED_LSB == 128 && SPH_PRIM_KR_LSB == 152, "fifth word");
            u128 material = b.dut.prim_data_i[4] | (u128)(b.dut.prim_data_i[5] & 1) << 32;
            b.expect("material_slot_o", b.dut.material_slot_o, answer, SLOTW);
            b.expect("material_o", b.get(b.dut.material_o), (bench::i128)material, 33);
            static_assert(SPH_PRIM_TEX_LSB == 192 && SPH_PRIM_TEX_BITS == 26, "seventh word");
            b.expect("material_tex_o", b.dut.material_tex_o,
                     TEXTURE ? b.dut.prim_data_i[6] & 0x3ffffff : 0, 26);
            slots[answer].state = Slot::FETCHED;
        }

        b.tick();
        if (taken) b.dut.prim_valid_i = 0;
        b.expect("bare_valid_o", b.dut.bare_valid_o, taken && !points, 1);
        if (b.dut.bare_valid_o) {
            b.expect("bare_slot_o", b.dut.bare_slot_o, answer, SLOTW);
            b.expect("out_valid_o of a bare surface", b.dut.out_valid_o, 0, 1);
            slots[answer].state = Slot::IDLE;
            b.done();
            continue;
        }
        if (!b.dut.out_valid_o) {
            b.expect("saturated_o without out_valid_o", b.dut.saturated_o, 0, 1);
            if (b.bad()) b.done();
            continue;
        }
        at = b.dut.out_slot_o;
        Slot &e = slots[at];
        if (e.state != Slot::FETCHED) {
            b.fail("a surface without a record");
            continue;
        }
        struct sph_ray ray = {};
        struct sph_leaf sphere = {};
        struct sph_surface surface;
        struct sph_hit hit = {e.v.key, e.v.id, e.v.far};
        ray.a = e.v.a;
        for (int i = 0; i < 3; i++) {
            ray.org[i] = e.v.org[i];
            ray.dir[i] = e.v.dir[i];
            sphere.ctr[i] = e.v.ctr[i];
        }
        int saturated = e.v.facet ? sph_surface_facet(&profile, &ray, &hit, e.v.ctr, &surface)
                                  : sph_surface_at(&profile, &ray, &hit, &sphere, &surface);
        b.expect("out_point_o", b.get(b.dut.out_point_o), (bench::i128)pack(surface.point, W),
                 3 * W);
        b.expect("out_normal_o", b.get(b.dut.out_normal_o), (bench::i128)pack(surface.normal, WD),
                 3 * WD);
        const int64_t none[3] = {0, 0, 0};
        b.expect("out_guarded_o", b.get(b.dut.out_guarded_o),
                 (bench::i128)pack(TEXTURE ? surface.guarded : none, W + NG), 3 * (W + NG));
        b.expect("saturated_o", b.dut.saturated_o, saturated, 1);
        if (b.bad()) {
            b.show("slot", at, SLOTW);
            b.show("in_key_i", (bench::i128)e.v.key, W + WD + 2);
            b.show("ray_a_i", (bench::i128)e.v.a, 2 * WD);
            b.show("in_far_i", e.v.far, 1);
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
    if (quotients > hits || quotients + SLOTS < hits) b.fail("quotient_o is not one for each hit");
    return b.finish();
}
