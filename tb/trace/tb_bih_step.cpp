/* tb_bih_step.cpp - rt_bih_step against sph_bih_cut(), and against exact fractions
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come first, the plane as both. A vector is an axis of a ray, as
 * sph_bih_setup() makes it, and two planes. First all ends of origin, direction and planes, and
 * planes one unit around the origin; then random ones, most of them near, some at the longest
 * distance that is a bound. Beside the model's answer: no bound is on the wrong side of the exact
 * a*v/|dir|.
 */
#include <deque>
#include "Vrt_bih_step.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "machine/layout.h"
#include "trace/bih.h"
}

namespace {

constexpr size_t LATENCY = 5;
constexpr int64_t O_MAX = ((int64_t)1 << (W - 1)) - 1, D_MAX = ((int64_t)1 << (WD - 1)) - 1,
                  C_MAX = ((int64_t)1 << (W + 1)) - 1;
const sph_profile profile = {PROFILE, W, WD, 0, 0, 0, 0};

struct Vector {
    sph_ray ray{};
    sph_bih_ray bih{};
    int axis = 0;
    int64_t clip[2] = {0, 0}; /* left, right */
    bool corner = false;
    hard::Vector hard{};
};

const int64_t corners[] = {0, 1, -1, 2, -2, 3, 1 << 4, 1 << 8};

class Source {
  public:
    long left = 6 * 13 * 100;

    Source(bench::Random &r, const hard::Cases &cases)
        : random(r), first(cases.begin(), cases.end()) {
        if (hard::alone()) left = 0;
    }

    Vector next() {
        Vector v;
        if (at < first.size())
            named(v, first[at++]);
        else if (left > 0)
            ends(v, (unsigned)--left);
        else if (random.percent(95) || !longest(v))
            any(v);
        set_up(v);
        return v;
    }

    bool all() const { return at == first.size() && !left; }

  private:
    bench::Random &random;
    std::vector<hard::Vector> first;
    size_t at = 0;

    static void named(Vector &v, const hard::Vector &c) {
        v.hard = c;
        v.ray = c.c.ray;
        v.axis = c.c.clip.axis;
        v.clip[0] = v.clip[1] = c.c.clip.at;
    }

    static void set_up(Vector &v) {
        v.ray.kind = SPH_PRIMARY;
        v.ray.a = 0;
        for (int64_t d : v.ray.dir)
            v.ray.a += (uint64_t)(d * d);
        sph_bih_setup(&profile, &v.ray, &v.bih);
    }
    /* Planes at the longest distance whose bound is one, and a unit beside it; 0: none found. */
    bool longest(Vector &v) {
        for (int tries = 0; tries < 64; tries++) {
            any(v);
            set_up(v);
            const sph_bih_axis &x = v.bih.axis[v.axis];
            if (x.zero || x.shift < 0 || x.shift > 30) continue;
            const uint64_t g = x.mant + 2ull, ones = SPH_BIH_NO_BOUND;
            const int64_t up = (int64_t)(((ones << x.shift) + g - 1) / g);
            if ((uint64_t)up * g >> x.shift != ones) continue;
            const int64_t far = up << v.bih.v_shift, o = v.ray.org[v.axis];
            const int64_t at = x.negative ? o - far : o + far;
            if (at > C_MAX - 1 || at < -C_MAX) continue;
            v.clip[0] = v.clip[1] = at;
            v.clip[random.below(2)] += random.between(-1, 1);
            return true;
        }
        return false;
    }

    static int64_t end(unsigned n, int64_t most) {
        static const int64_t small[] = {0, 1, -1, 2, -2};
        return n < 5 ? small[n] : n & 1 ? most - (n >> 1 & 1) : -most - 1 + (n >> 1 & 1);
    }
    void ends(Vector &v, unsigned n) {
        v.corner = true;
        v.axis = (int)(n % 3);
        for (int64_t &d : v.ray.dir)
            d = n / 3 % 2 ? D_MAX : 0; /* the largest a and the smallest */
        v.ray.dir[v.axis] = end(n / 6 % 13 % 9, D_MAX);
        if (n / 6 % 13 >= 9) v.ray.dir[v.axis] = corners[n / 6 % 13 - 5];
        v.ray.org[v.axis] = end(n / 78 % 10 % 9, O_MAX);
        int64_t o = v.ray.org[v.axis];
        unsigned c = n / 780 % 10;
        v.clip[0] = c < 5 ? o + corners[c] : end(c - 1, C_MAX);
        v.clip[1] = n / 78 % 10 == 9 ? v.clip[0] : c < 5 ? o - corners[c] : end(13 - c, C_MAX);
        if (!v.ray.dir[0] && !v.ray.dir[1] && !v.ray.dir[2]) v.ray.dir[(v.axis + 1) % 3] = 1;
    }
    void any(Vector &v) {
        v.axis = (int)random.below(3);
        do
            for (int i = 0; i < 3; i++) {
                v.ray.dir[i] = random.percent(5)    ? 0
                               : random.percent(50) ? random.sbits(WD)
                                                    : random.log_sbits(WD);
                v.ray.org[i] = random.smixed(W);
            }
        while (!v.ray.dir[0] && !v.ray.dir[1] && !v.ray.dir[2]);
        int64_t o = v.ray.org[v.axis];
        for (int64_t &c : v.clip) {
            c = random.percent(30) ? random.smixed(W + 2) : o + random.log_sbits(W + 1);
            if (c > C_MAX) c = C_MAX;
            if (c < -C_MAX - 1) c = -C_MAX - 1;
        }
    }
};

/* Sign of a*v/|d| - t * 2^t_shift, d not 0. */
int compare(const Vector &v, int64_t distance, uint32_t t) {
    int64_t d = v.ray.dir[v.axis];
    bench::i128 exact = (bench::i128)v.ray.a * distance;
    bench::i128 bound = ((bench::i128)t << v.bih.t_shift) * (d < 0 ? -d : d);
    return exact < bound ? -1 : exact > bound;
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_bih_step> b("tb_bih_step", argc, argv, 100000);
    hard::Cases cases(b.seed, HARD_CLIPS,
                      [](const sph_profile &p) { return p.w == W && p.wd == WD; });
    cases.limit(b);
    Source source(b.random, cases);
    std::deque<Vector> sent;
    while (b.more()) {
        Vector v = source.next();
        const sph_bih_axis &x = v.bih.axis[v.axis];
        b.set(b.dut.in_org_i, W, v.ray.org[v.axis]);
        b.dut.in_back_i = x.negative != 0;
        b.dut.in_flat_i = x.zero != 0;
        b.dut.in_open_i = x.shift < 0;
        b.dut.in_shift_i = (uint8_t)(x.shift < 0 ? 0 : x.shift);
        b.set(b.dut.in_g_i, SPH_BIH_G, x.mant);
        b.set(b.dut.in_clip_l_i, W + 2, v.clip[0]);
        b.set(b.dut.in_clip_r_i, W + 2, v.clip[1]);
        sent.push_back(v);
        b.tick();
        if (sent.size() < LATENCY) continue;
        v = sent.front();
        sent.pop_front();
        const sph_bih_axis &y = v.bih.axis[v.axis];
        int back = y.negative;
        sph_interval near = {0, SPH_BIH_NO_BOUND}, far = near;
        int near_met = sph_bih_cut(&v.bih, &v.ray, v.axis, v.clip[back], !back, &near);
        int far_met = sph_bih_cut(&v.bih, &v.ray, v.axis, v.clip[!back], back, &far);
        b.expect("out_back_o", b.dut.out_back_o, back);
        b.expect("out_near_o", b.dut.out_near_o, near_met);
        b.expect("out_far_o", b.dut.out_far_o, far_met);
        if (near_met) b.expect("out_upper_o", b.dut.out_upper_o, near.hi, SPH_BIH_T);
        if (far_met) b.expect("out_lower_o", b.dut.out_lower_o, far.lo, SPH_BIH_T);
        int64_t o = v.ray.org[v.axis];
        int64_t vn = back ? o - v.clip[1] : v.clip[0] - o,
                vf = back ? o - v.clip[0] : v.clip[1] - o;
        if (near_met && !y.zero && near.hi != SPH_BIH_NO_BOUND)
            b.expect("upper below the plane", compare(v, vn, b.dut.out_upper_o) > 0, 0);
        if (far_met && !y.zero && vf > 0)
            b.expect("lower above the plane", compare(v, vf, b.dut.out_lower_o) < 0, 0);
        if (b.bad()) {
            v.hard.show();
            b.show("org", o, W);
            b.show("dir", v.ray.dir[v.axis], WD);
            b.show("a", (bench::i128)v.ray.a, 2 * WD);
            b.show("left", v.clip[0], W + 2);
            b.show("right", v.clip[1], W + 2);
            b.show("shift", y.shift, 8);
            b.show("mant", y.mant, SPH_BIH_G);
        }
        b.done();
    }
    if (b.all_vectors && !source.all()) b.fail("not all ends were driven");
    return b.finish();
}
