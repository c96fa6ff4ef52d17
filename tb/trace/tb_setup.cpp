/* tb_setup.cpp - rt_setup against sph_ray_setup()
 * SPDX-License-Identifier: Apache-2.0
 *
 * All four sources run at once. A slot has one job at a time, as the token rule wants it: a vector
 * from a source until its ray, normal or light has come out.
 */
#include <deque>
#include <vector>

#include "Vrt_setup.h"
#include "bench.h"
#include "bundles.h"

extern "C" {
#include "machine/layout.h"
#include "core/ray.h"
#include "trace/setup.h"
}

#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef FACETS
#define FACETS 0
#endif
#ifndef NG
#define NG 2
#endif
#ifndef ACROSS
#define ACROSS 1
#endif

namespace {

enum { PRIMARY, LIGHT, BOUNCE, NORMAL, SOURCES, IDLE = -1 };
const bool built[] = {true, LIGHTS != 0, BOUNCES != 0, LIGHTS || BOUNCES || TEXTURE};
constexpr bool SHADOWS = LIGHTS && SHADOW; /* else the core takes a vector to a light no further */
const char *const kinds[] = {"primary ray", "ray to a light", "reflected ray", "normal"};
constexpr int K = W - FW, NO_BOUND = 63;
constexpr uint64_t LONGEST = 4 * SLOTS + 60; /* clocks until all slots are idle again */
const struct sph_profile profile = {PROFILE, W, WD, 0, 0, FW, 0};

struct Vec {
    int64_t v[3];
};

struct Slot {
    int job = IDLE;
    bool has_normal = false; /* lights have a surface */
    Vec dir{}, point{}, normal{};
    uint32_t skip = 0; /* {inside, id} */
    Vec lift{};
};

constexpr int64_t MAX = ((int64_t)1 << (WD - 1)) - 1, MIN = -MAX - 1;
constexpr int64_t FAR = ((int64_t)1 << (W - 1)) - 1, HALF = K ? (int64_t)1 << (K - (K > 0)) : 1;
constexpr int64_t LIMIT = ((int64_t)2 << FW) - 1; /* of depths */

std::vector<Vec> corner_dirs() {
    std::vector<Vec> c = {
        {{0, 0, 0}},                            /* no direction: all is 0 but scale and bound */
        {{MAX, MAX, MAX}},   {{MIN, MIN, MIN}}, /* longest: a needs all its bits */
        {{MAX, MIN, 0}},     {{MIN, 0, MAX}},   /* |MIN| is one more */
        {{1, 1, 0}},         {{0, 1, 1}},       /* ties go to the lower axis */
        {{1, 0, 1}},         {{1, 1, 1}},       /* the same */
        {{-1, 1, 1}},        {{1, -1, -1}},     /* ties: the sign is of the lower axis */
        {{0, -1, 1}},        {{MAX, -MAX, 1 - MAX}}, /* the same, just not a tie of three */
        {{MAX - 1, MAX, 0}}, {{0, MAX - 1, MAX}},    /* a tie of the unit only, if it rounds so */
    };
    for (int axis = 0; axis < 3; axis++) {
        for (int64_t x : {(int64_t)1, (int64_t)-1, MAX, -MAX, MIN}) { /* along an axis */
            c.push_back({});
            c.back().v[axis] = x;
        }
        for (int64_t units : {LIMIT - 2, LIMIT - 1, LIMIT}) /* a light just at the depth limit */
            for (int64_t x : {(units << K) - 1, units << K, -(units << K)})
                if (x >= MIN && x <= MAX) {
                    c.push_back({});
                    c.back().v[axis] = x;
                }
        for (int i = 0; i < WD - 1; i++) { /* every shift of the unit, even and odd lengths */
            c.push_back({});
            c.back().v[axis] = (int64_t)1 << i;
            c.push_back(c.back());
            c.back().v[(axis + 1) % 3] = -((int64_t)1 << i);
        }
    }
    return c;
}

/* Filter origins: ends, limit above, just below and at half a unit, around 0. */
const int64_t corner_points[] = {FAR,      -FAR - 1, FAR - HALF, FAR - HALF + 1, HALF,
                                 HALF - 1, -HALF,    0,          -HALF - 1,      -1};

Vec random_point(bench::Random &random) {
    Vec p{};
    constexpr size_t n = sizeof corner_points / sizeof *corner_points;
    for (int64_t &x : p.v)
        x = random.percent(30) ? corner_points[random.below(n)] : random.smixed(W);
    return p;
}

Vec random_dir(bench::Random &random, const Vec *normal) {
    Vec d{};
    int bits = random.percent(50) ? WD : (int)random.between(2, WD);
    for (int64_t &x : d.v)
        x = random.percent(5) ? 0 : random.smixed(bits);
    if (normal && random.percent(30)) { /* straight at the light, nearly: cosine about 1 */
        d = *normal;
        int64_t &x = d.v[random.below(3)];
        x += random.between(-1, 1);
        x = x < MIN ? MIN : x > MAX ? MAX : x;
    } else if (random.percent(15)) { /* nearly a tie of two axes */
        int i = (int)random.below(3);
        d.v[i] = d.v[(i + 1) % 3] < 0 ? ~d.v[(i + 1) % 3] : d.v[(i + 1) % 3];
    }
    return d;
}

bench::i128 pack(const int64_t v[3], int bits) {
    bench::u128 x = 0;
    for (int i = 2; i >= 0; i--)
        x = x << bits | bench::low((bench::u128)v[i], bits);
    return (bench::i128)x;
}

class Setup : public bench::Bench<Vrt_setup> {
  public:
    Setup(int argc, char **argv) : Bench("tb_setup", argc, argv), corners(corner_dirs()) {}

    /* New registers and gaps; every slot is idle. */
    void phase() {
        eye = random_point(random);
        set(dut.eye_i, 3 * W, pack(eye.v, W));
        for (unsigned &p : rate)
            p = (const unsigned[]){0, 5, 30, 100}[random.below(4)];
        rate[random.below(SOURCES)] = 100;
        if (!rate[PRIMARY]) rate[PRIMARY] = 5; /* where no other source is built */
    }

    /* One clock. start: new jobs may begin. */
    void clock(bool start) {
        int s;
        for (int kind : {NORMAL, LIGHT, BOUNCE}) {
            bool valid =
                built[kind] && start && random.percent(rate[kind]) && (s = idle(kind)) >= 0;
            if (valid) begin(kind, s);
            Vec any = random_dir(random, nullptr);
            bench::i128 vec = pack(valid ? slots[s].dir.v : any.v, WD);
            bench::i128 slot = valid ? s : (bench::i128)random.below(SLOTS);
            auto &port = kind == NORMAL ? dut.normal_i : kind == LIGHT ? dut.light_i : dut.bounce_i;
            bench::put(port, RT_VECTOR_VALID, valid);
            bench::put(port, RT_VECTOR_SLOT, slot);
            bench::put(port, RT_VECTOR_VEC, vec);
            if (kind == NORMAL) write_point(valid, valid ? s : -1);
        }
        if (!bench::get(dut.primary_i, RT_VECTOR_VALID) && start && random.percent(rate[PRIMARY]) &&
            (s = idle(PRIMARY)) >= 0) {
            begin(PRIMARY, s);
            bench::put(dut.primary_i, RT_VECTOR_VALID, 1);
            bench::put(dut.primary_i, RT_VECTOR_SLOT, s);
            bench::put(dut.primary_i, RT_VECTOR_VEC, pack(slots[s].dir.v, WD));
        }
        write_skip();
        settle();
        bool accepted = bench::get(dut.primary_i, RT_VECTOR_VALID) && dut.primary_ready_o;
        bool light = dut.next_light_o;
        int light_slot = dut.next_slot_o;
        tick();
        if (accepted) bench::put(dut.primary_i, RT_VECTOR_VALID, 0);
        int slot = (int)bench::get(dut.ray_o, RT_RAY_SLOT);
        bool normal = bench::get(dut.ray_o, RT_RAY_NORMAL) != 0;
        bool now = bench::get(dut.ray_o, RT_RAY_LIGHT) != 0;
        if (now != light || (light && light_slot != slot))
            fail("next_light_o and next_slot_o do not tell of the next light");
        if (now && cycle == light_before + 1) fail("a light in the clock behind another");
        if (now) light_before = cycle;
        if (bench::get(dut.across_o, RT_ACROSS_VALID)) check_across();
        if (normal) check_normal(slot);
        if (bench::get(dut.ray_o, RT_RAY_VALID) || now) {
            if (normal) fail("a normal that is a ray too");
            check_ray(slot);
        }
    }

    bool all_idle() const {
        for (const Slot &s : slots)
            if (s.job != IDLE) return false;
        return true;
    }

    /* Every job is lost. */
    void restart() {
        bench::put(dut.normal_i, RT_VECTOR_VALID, 0);
        bench::put(dut.light_i, RT_VECTOR_VALID, 0);
        bench::put(dut.bounce_i, RT_VECTOR_VALID, 0);
        bench::put(dut.primary_i, RT_VECTOR_VALID, 0);
        bench::put(dut.org_i, RT_ORG_VALID, 0);
        bench::put(dut.skip_i, RT_SKIP_VALID, 0);
        reset();
        axes.clear();
        for (Slot &s : slots) {
            if (s.job == NORMAL) s.has_normal = false;
            s.job = IDLE;
        }
    }

    /* Every slot gets a point and a skip. */
    void fill() {
        restart();
        for (int i = 0; i < SLOTS; i++) {
            write_point(true, i);
            put_skip(true, i, (uint32_t)random.bits(25));
            tick();
        }
        bench::put(dut.org_i, RT_ORG_VALID, 0);
        bench::put(dut.skip_i, RT_SKIP_VALID, 0);
    }

  private:
    static constexpr uint64_t BEHIND = 12; /* clocks from a ray to its axes, at most */
    struct Axes {
        int slot;
        struct sph_across across;
        uint64_t since;
    };
    std::deque<Axes> axes; /* that are to come */
    Slot slots[SLOTS];
    std::vector<Vec> corners;
    size_t done_corners[SOURCES] = {};
    Vec eye{};
    unsigned rate[SOURCES] = {};          /* percent of clocks with a new job */
    uint64_t light_before = ~(uint64_t)1; /* clock of the last light */

    /* A slot for a job, or -1; the search starts anywhere. */
    int idle(int kind) {
        uint64_t first = random.below(SLOTS);
        for (uint64_t i = 0; i < SLOTS; i++) {
            const Slot &s = slots[(first + i) % SLOTS];
            if (s.job == IDLE && (kind != LIGHT || s.has_normal)) return (int)((first + i) % SLOTS);
        }
        return -1;
    }

    void begin(int kind, int number) {
        Slot &s = slots[number];
        s.job = kind;
        s.dir = done_corners[kind] < corners.size()
                    ? corners[done_corners[kind]++]
                    : random_dir(random, kind == LIGHT ? &s.normal : nullptr);
    }

    /* With a normal, as rt_surface does; otherwise into an idle slot. */
    void write_point(bool valid, int number) {
        if (!valid && random.percent(30) && (number = (int)random.below(SLOTS)) >= 0)
            valid = slots[number].job == IDLE;
        Vec any = random_point(random);
        bench::put(dut.org_i, RT_ORG_VALID, valid);
        bench::put(dut.org_i, RT_ORG_SLOT, valid ? number : (int)random.below(SLOTS));
        bench::put(dut.org_i, RT_ORG_POINT, pack(any.v, W));
        if (valid) slots[number].point = any;
        Vec lift{};
        for (int64_t &x : lift.v)
            x = random.sbits(NG + 2);
        bench::put(dut.org_i, RT_ORG_LIFT, pack(lift.v, NG + 2));
        if (valid) slots[number].lift = lift;
    }

    void write_skip() {
        int number = (int)random.below(SLOTS);
        put_skip(slots[number].job == IDLE && random.percent(50), number,
                 (uint32_t)random.mixed(25));
    }

    void put_skip(bool valid, int number, uint32_t skip) {
        bench::put(dut.skip_i, RT_SKIP_VALID, valid);
        bench::put(dut.skip_i, RT_SKIP_SLOT, number);
        bench::put(dut.skip_i, RT_SKIP_ID, skip & SPH_ID_NONE);
        bench::put(dut.skip_i, RT_SKIP_INSIDE, skip >> 24);
        if (valid) slots[number].skip = skip;
    }

    void end(Slot &s) {
        if (bad()) {
            printf("#   %s, slot %d\n", s.job == IDLE ? "no job" : kinds[s.job], (int)(&s - slots));
            for (int64_t x : s.dir.v)
                show("dir", x, WD);
            for (int64_t x : s.job == PRIMARY ? eye.v : s.point.v)
                show("org", x, W);
            for (int64_t x : s.normal.v)
                show("normal", x, WD);
        }
        s.job = IDLE;
        done();
    }

    struct sph_ray model(const Slot &s) const {
        struct sph_ray r = {};
        const Vec &org = s.job == PRIMARY ? eye : s.point;
        for (int i = 0; i < 3; i++) {
            r.org[i] = org.v[i];
            r.dir[i] = s.dir.v[i];
        }
        r.kind = s.job == PRIMARY ? SPH_PRIMARY : s.job == LIGHT ? SPH_SHADOW : SPH_REFLECTED;
        sph_ray_setup(&profile, &r);
        return r;
    }

    void check_ray(int number) {
        Slot &s = slots[number];
        bool primary = s.job == PRIMARY, light = s.job == LIGHT;
        if (s.job == IDLE || s.job == NORMAL) return fail("a ray that nothing asked for");
        struct sph_ray r = model(s);
        expect("VALID", field(RT_RAY_VALID), !light || SHADOWS, 1);
        expect("LIGHT", field(RT_RAY_LIGHT), light, 1);
        expect("PRIMARY", field(RT_RAY_PRIMARY), primary, 1);
        for (int i = 0; i < 3; i++)
            expect("UNIT", unit(i), r.unit.u[i], 18);
        expect("DIR", field(RT_RAY_DIR), pack(r.dir, WD), 3 * WD);
        expect("A", field(RT_RAY_A), r.a, 2 * WD);
        if (!light || SHADOWS) {
            uint32_t skip = primary ? SPH_ID_NONE : s.skip;
            expect("SHADOW", field(RT_RAY_SHADOW), light, 1);
            expect("ORG", field(RT_RAY_ORG), pack(r.org, W), 3 * W);
            if (FACETS && light)
                expect("lift_o", (bench::i128)get(dut.lift_o), pack(s.lift.v, NG + 2),
                       3 * (NG + 2));
            expect("SKIP", field(RT_RAY_SKIP), skip & SPH_ID_NONE, 24);
            expect("INSIDE", field(RT_RAY_INSIDE), skip >> 24, 1);
            expect("Y", field(RT_RAY_Y), TEXTURE ? r.unit.y : 0, 17);
            expect("H", field(RT_RAY_H), TEXTURE ? r.unit.h : 0, 6);
            check_filter(r);
        }
        if (ACROSS) axes.push_back({number, r.across, cycle});
        end(s);
    }

    /* In the order of rays, and soon enough. */
    void check_across() {
        auto field = [&](int lsb, int bits) {
            return (bench::i128)bench::get(dut.across_o, lsb, bits);
        };
        if (axes.empty()) return fail("axes that nothing asked for");
        const Axes a = axes.front();
        axes.pop_front();
        uint64_t behind = cycle - a.since;
        if (ACROSS == 1 ? behind != 8 : behind != BEHIND && behind != BEHIND - 1)
            fail("axes too early or too late");
        expect("LEAST", field(RT_ACROSS_LEAST), 3 - a.across.axis_a - a.across.axis_b, 2);
        expect("P_A", bench::sign(field(RT_ACROSS_P_A), 18), a.across.p_a, 18);
        expect("P_B", bench::sign(field(RT_ACROSS_P_B), 18), a.across.p_b, 18);
        for (int i = 0; i < 3; i++)
            expect("Q", bench::sign(field(RT_ACROSS_Q) >> (18 * i), 18), a.across.q[i], 18);
        expect("SLOT of axes", field(RT_ACROSS_SLOT), a.slot, 8);
        if (bad()) done();
    }

    void check_filter(const struct sph_ray &r) {
        for (int i = 0; i < 3; i++)
            expect("filter ORG",
                   bench::sign(bench::get(dut.filter_o, RT_FILTER_ORG) >> (FW * i), FW), r.forg[i],
                   FW);
        expect("AXIS", bench::get(dut.filter_o, RT_FILTER_AXIS), r.axis, 2);
        expect("NEGATIVE", bench::get(dut.filter_o, RT_FILTER_NEGATIVE), r.negative, 1);
        expect("SCALE", bench::get(dut.filter_o, RT_FILTER_SCALE), r.depth_scale, 17);
        expect("SHIFT", bench::get(dut.filter_o, RT_FILTER_SHIFT),
               r.depth_shift < 0 ? NO_BOUND : r.depth_shift, 6);
        expect("DEPTH", bench::get(dut.filter_o, RT_FILTER_DEPTH), r.depth_max, FW + 1);
    }

    void check_normal(int number) {
        Slot &s = slots[number];
        if (s.job != NORMAL) return fail("a normal that nothing asked for");
        const int64_t *n = s.dir.v;
        uint64_t nn = (uint64_t)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        expect("DIR of a normal", field(RT_RAY_DIR), pack(n, WD), 3 * WD);
        expect("A of a normal", field(RT_RAY_A), nn, 2 * WD);
        struct sph_unit u = sph_unit(n, nn, WD);
        for (int i = 0; i < 3; i++)
            expect("UNIT of a normal", unit(i), u.u[i], 18);
        s.normal = s.dir;
        s.has_normal = true;
        end(s);
    }

    bench::i128 field(int lsb, int bits) const {
        return (bench::i128)bench::get(dut.ray_o, lsb, bits);
    }
    bench::i128 unit(int axis) const {
        return bench::sign(bench::get(dut.ray_o, RT_RAY_UNIT) >> (18 * axis), 18);
    }
};

} // namespace

int main(int argc, char **argv) {
    Setup b(argc, argv);
    b.fill();
    while (b.more()) {
        b.phase();
        for (uint64_t i = b.random.between(50, 1000); i && b.more(); i--)
            b.clock(true);
        if (b.random.percent(5)) {
            b.restart();
            continue;
        }
        uint64_t since = b.cycle;
        while (!b.all_idle() && b.cycle - since < LONGEST)
            b.clock(false);
        if (!b.all_idle()) {
            b.fail("a vector got lost");
            break;
        }
    }
    return b.finish();
}
