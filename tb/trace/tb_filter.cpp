/* tb_filter.cpp - rt_filter against sph_filter(), and against the exact leaf test
 * SPDX-License-Identifier: Apache-2.0
 *
 * The cases of tests/hard come first. Half of the others are filter operands: ends, then spheres
 * whose radius is next to the distance of the ray; half are exact rays and spheres of W bits.
 * Whenever sph_leaf_test() hits an exact sphere, the filter on the sphere's child (smallest radius
 * that holds it, plus the margin) must pass.
 */
#include <algorithm>
#include <cmath>
#include <deque>
#include "Vrt_filter.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "builder/grid/bound.h"
#include "machine/layout.h"
#include "trace/filter.h"
#include "prim/sphere.h"
#include "core/ray.h"
#include "trace/setup.h"
}

#ifndef SQUARES
#define SQUARES 0
#endif

namespace {

constexpr int LATENCY = SQUARES ? 12 : 9, K = W - FW;
constexpr int64_t C_MIN = -((int64_t)1 << (W - 1)), C_MAX = -C_MIN - 1,
                  R_MAX = ((int64_t)1 << W) - 1;
constexpr int64_t D_MIN = -((int64_t)1 << (WD - 1)), D_MAX = -D_MIN - 1;
constexpr int64_t F_MIN = -((int64_t)1 << (FW - 1)), F_MAX = -F_MIN - 1;
const sph_profile profile = {PROFILE, W, WD, WD, 2, FW, 0};

struct Vector {
    sph_ray ray{};
    sph_child child{};
    int32_t depth_max = 0;
    bool exact = false, must_pass = false;
    sph_leaf leaf{};
    hard::Case hard;
};

int64_t clamp(int64_t x, int64_t low, int64_t high) {
    return std::min(std::max(x, low), high);
}

/* Distance of the filter's line from the child's centre as the filter sees it, filter units. */
double filter_distance(const Vector &v) {
    const struct sph_across &a = v.ray.across;
    int64_t oc[3], q = 0;
    for (int i = 0; i < 3; i++) {
        oc[i] = v.child.ctr[i] - v.ray.forg[i];
        q += oc[i] * a.q[i];
    }
    double sum = 0;
    for (int64_t x : {oc[a.axis_a] * a.p_a - oc[a.axis_b] * a.p_b, q}) {
        x >>= 17 - SPH_FILTER_FRACTION;
        double c = (double)(x < 0 ? ~x : x) / (1 << SPH_FILTER_FRACTION);
        sum += c * c;
    }
    return std::sqrt(sum);
}

class Source {
  public:
    hard::Source hard;
    long hits = 0;
    double margin = -1e9; /* most of SPH_FILTER_MARGIN that a hit has used */

    Source(bench::Random &r, uint64_t seed)
        : hard(
              seed, [](const sph_profile &p) { return p.w == W && p.wd == WD && p.fw == FW; },
              [](const hard::Case &c) { return c.is_ray; }),
          random(r) {}

    Vector next() {
        Vector v;
        if (!hard::alone() && count < 64 * 6)
            ends(v, count++);
        else if (from_tests(v))
            around(v, v.hard.ray.inside);
        else if (random.percent(50))
            operands(v);
        else
            exact(v);
        return v;
    }

  private:
    bench::Random &random;
    unsigned count = 0;

    bool from_tests(Vector &v) {
        if (!hard.next(v.hard)) return false;
        v.ray = v.hard.ray;
        v.leaf = v.hard.leaf;
        v.exact = true;
        return true;
    }

    /* All of org and ctr at an end, u along each axis: the longest cross products and depths. */
    void ends(Vector &v, unsigned n) {
        for (int i = 0; i < 3; i++) {
            v.ray.forg[i] = (int32_t)(n >> i & 1 ? F_MIN : F_MAX);
            v.child.ctr[i] = (int32_t)(n >> (3 + i) & 1 ? F_MIN : F_MAX);
        }
        v.ray.axis = (int)(n / 64) % 3;
        v.ray.negative = n / 64 >= 3;
        v.ray.unit.u[v.ray.axis] = v.ray.negative ? -65536 : 65536;
        v.ray.across = sph_across(v.ray.unit.u);
        v.child.rad = n & 1 ? 16383 : 0;
        v.depth_max = sph_depth_limit(&profile);
    }

    void operands(Vector &v) {
        int64_t d[3];
        uint64_t vv = 0;
        for (int i = 0; i < 3; i++) {
            v.ray.forg[i] = (int32_t)random.smixed(FW);
            v.child.ctr[i] = (int32_t)random.smixed(FW);
            d[i] = random.percent(60) ? v.child.ctr[i] - v.ray.forg[i] + random.between(-99, 99)
                                      : random.smixed(17);
            vv += (uint64_t)(d[i] * d[i]);
        }
        v.ray.unit = sph_unit(d, vv, 17);
        v.ray.across = sph_across(v.ray.unit.u);
        v.ray.axis = (int)random.below(3);
        v.ray.negative = random.percent(50);
        v.child.rad = (int32_t)random.mixed(14);
        if (random.percent(60)) /* next to the distance: the compare at its edge */
            v.child.rad =
                (int32_t)clamp((int64_t)filter_distance(v) + random.between(0, 1), 0, 16383);
        int32_t oc = v.child.ctr[v.ray.axis] - v.ray.forg[v.ray.axis];
        int32_t depth = v.ray.negative ? -oc : oc, limit = sph_depth_limit(&profile);
        v.depth_max = random.percent(50) ? limit : (int32_t)random.mixed(FW + 1);
        if (random.percent(30)) /* the child ends at depth 0, or just before */
            v.child.rad = (int32_t)clamp(-depth + random.between(-1, 1), 0, 16383);
        if (random.percent(30)) /* and begins at depth_max, or just behind */
            v.depth_max = (int32_t)clamp(depth - v.child.rad + random.between(-1, 1), 0, limit);
    }

    int64_t coord(bool high) { /* at the upper end the origin's rounding saturates */
        return high                 ? C_MAX - (int64_t)random.below(((uint64_t)1 << K) / 2 + 1)
               : random.percent(30) ? clamp(random.percent(50) ? C_MIN : C_MAX, C_MIN, C_MAX)
                                    : random.between(C_MIN, C_MAX);
    }

    void exact(Vector &v) {
        sph_leaf &s = v.leaf;
        sph_ray &ray = v.ray;
        int64_t unit = (int64_t)1 << K;
        v.exact = true;
        ray.kind = random.percent(20) ? SPH_SHADOW : SPH_PRIMARY;
        ray.skip.id = 0xffffff;
        ray.inside = 1;
        s.id = 5;
        unsigned corner = (unsigned)random.below(16); /* axes at the upper end; 8..15: none */
        for (int i = 0; i < 3; i++) {
            ray.org[i] = coord(corner < 8 && (corner >> i & 1));
            s.ctr[i] = random.between(C_MIN, C_MAX);
            if (random.percent(70)) s.ctr[i] &= -unit; /* no slack from rounding the centre */
        }
        s.rad = random.percent(50) ? (int64_t)random.log_bits(W) : (int64_t)random.bits(W - 2);
        if (random.percent(70)) s.rad = clamp(s.rad & -unit, unit, R_MAX); /* nor the radius */
        double oc[3], len2 = 0;
        for (int i = 0; i < 3; i++) {
            oc[i] = (double)(s.ctr[i] - ray.org[i]);
            len2 += oc[i] * oc[i];
        }
        if (random.percent(10) || len2 <= (double)s.rad * (double)s.rad) { /* inside, or anything */
            for (int64_t &d : ray.dir)
                d = random.smixed(WD);
        } else { /* a graze: at 0.99 to 1 of the radius, in a random plane */
            double p[3], dot = 0, p2 = 0, scale = 0, dir[3], graze;
            for (double &x : p)
                x = (double)random.sbits(20);
            if (random.percent(
                    30)) /* towards or away from the corner: against the origin's error */
                for (int i = 0; i < 3; i++)
                    p[i] = -1 - 0.2 * (double)random.below(5);
            for (int i = 0; i < 3; i++)
                dot += p[i] * oc[i];
            for (int i = 0; i < 3; i++)
                p[i] -= oc[i] * dot / len2, p2 += p[i] * p[i];
            graze = 1 - std::pow(10, -2 - (double)random.below(6));
            double sine = graze * (double)s.rad / std::sqrt(len2),
                   cosine = std::sqrt(1 - sine * sine);
            for (int i = 0; i < 3; i++) {
                dir[i] =
                    oc[i] / std::sqrt(len2) * cosine + (p2 > 0 ? p[i] / std::sqrt(p2) : 0) * sine;
                scale = std::max(scale, std::fabs(dir[i]));
            }
            double most =
                random.percent(80) ? (double)D_MAX : (double)((int64_t)1 << random.below(WD - 1));
            for (int i = 0; i < 3; i++)
                ray.dir[i] = clamp(std::llround(dir[i] / scale * most), D_MIN, D_MAX);
        }
        if (random.percent(10)) { /* leaves its own sphere from inside, starts on the surface */
            for (int i = 0; i < 3; i++) {
                double at = std::sqrt(len2) > 0 ? oc[i] / std::sqrt(len2) : 0;
                ray.org[i] = clamp(s.ctr[i] - std::llround(at * (double)s.rad), C_MIN, C_MAX);
            }
            double sum = 0;
            for (int i = 0; i < 3; i++)
                sum += std::pow((double)(s.ctr[i] - ray.org[i]), 2);
            if (std::fabs(std::sqrt(sum) - (double)s.rad) < 1) ray.skip = {s.id, 1};
        }
        around(v, random.percent(50));
    }

    /* The child around the exact sphere; its own key, if wanted, as the best so far. */
    void around(Vector &v, bool own_key) {
        const sph_leaf &s = v.leaf;
        sph_ray &ray = v.ray;
        sph_ray_setup(&profile, &ray);
        sph_ball ball = {{(int32_t)s.ctr[0], (int32_t)s.ctr[1], (int32_t)s.ctr[2]}, (int32_t)s.rad};
        sph_ball held = sph_filter_leaf(&ball, &profile);
        for (int i = 0; i < 3; i++)
            v.child.ctr[i] = held.c[i];
        v.child.rad = held.r + SPH_FILTER_MARGIN;
        v.depth_max = ray.depth_max;
        if (v.child.rad > 16383) { /* no such child: the builder refuses it */
            v.child.rad = 16383;
            return;
        }
        sph_leaf_result r = sph_leaf_test(&ray, &s);
        if (!r.hit || (v.hard.given && ray.skip.id == s.id)) return; /* docs/design/traversal.md */
        hits++;
        v.must_pass = true;
        margin = std::max(margin, filter_distance(v) - held.r);
        if (ray.kind != SPH_SHADOW && own_key) {
            uint64_t roots = 0;
            v.depth_max = sph_ray_depth(&profile, &ray, sph_leaf_key(&r, &roots));
        }
    }
};

using Bench = bench::Bench<Vrt_filter>;

/* The axes of a ray come a clock behind it: those of the vector before are driven. */
void drive(Bench &b, const Vector &v, const struct sph_across &before) {
    Vrt_filter &t = b.dut;
    t.in_valid_i = 1;
    b.set(t.in_org_x_i, FW, v.ray.forg[0]);
    b.set(t.in_org_y_i, FW, v.ray.forg[1]);
    b.set(t.in_org_z_i, FW, v.ray.forg[2]);
    t.in_least_i = (unsigned char)(3 - v.ray.across.axis_a - v.ray.across.axis_b);
    b.set(t.s1_p_a_i, 18, before.p_a);
    b.set(t.s1_p_b_i, 18, before.p_b);
    b.set(t.s1_q_x_i, 18, before.q[0]);
    b.set(t.s1_q_y_i, 18, before.q[1]);
    b.set(t.s1_q_z_i, 18, before.q[2]);
    t.in_axis_i = (unsigned char)v.ray.axis;
    t.in_negative_i = v.ray.negative != 0;
    b.set(t.in_depth_max_i, FW + 1, v.depth_max);
    b.set(t.in_ctr_x_i, 14, v.child.ctr[0]);
    b.set(t.in_ctr_y_i, 14, v.child.ctr[1]);
    b.set(t.in_ctr_z_i, 14, v.child.ctr[2]);
    b.set(t.in_rad_i, 14, v.child.rad);
}

void show(Bench &b, const Vector &s) {
    s.hard.show();
    static const char *names[4][3] = {{"in_org_x_i", "in_org_y_i", "in_org_z_i"},
                                      {"s1_q_x_i", "s1_q_y_i", "s1_q_z_i"},
                                      {"in_ctr_x_i", "in_ctr_y_i", "in_ctr_z_i"},
                                      {"exact ctr x", "exact ctr y", "exact ctr z"}};
    static const char *rays[2][3] = {{"exact org x", "exact org y", "exact org z"},
                                     {"exact dir x", "exact dir y", "exact dir z"}};
    for (int i = 0; i < 3; i++)
        b.show(names[0][i], s.ray.forg[i], FW);
    for (int i = 0; i < 3; i++)
        b.show(names[1][i], s.ray.across.q[i], 18);
    b.show("s1_p_a_i", s.ray.across.p_a, 18);
    b.show("s1_p_b_i", s.ray.across.p_b, 18);
    b.show("in_least_i", 3 - s.ray.across.axis_a - s.ray.across.axis_b, 2);
    b.show("in_axis_i", s.ray.axis, 2);
    b.show("in_negative_i", s.ray.negative, 1);
    b.show("in_depth_max_i", s.depth_max, FW + 1);
    for (int i = 0; i < 3; i++)
        b.show(names[2][i], s.child.ctr[i], 14);
    b.show("in_rad_i", s.child.rad, 14);
    for (int i = 0; s.exact && i < 3; i++) {
        b.show(names[3][i], s.leaf.ctr[i], W);
        b.show(rays[0][i], s.ray.org[i], W);
        b.show(rays[1][i], s.ray.dir[i], WD);
    }
    if (s.exact) b.show("exact rad", s.leaf.rad, W);
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_filter> b("tb_filter", argc, argv, 300000);
    Source source(b.random, b.seed);
    source.hard.limit(b);
    std::deque<Vector> sent;
    Vrt_filter &t = b.dut;
    while (b.more()) {
        Vector v = source.next();
        drive(b, v, sent.empty() ? v.ray.across : sent.back().ray.across);
        sent.push_back(v);
        b.tick();
        if (sent.size() < LATENCY) continue;
        Vector s = sent.front();
        sent.pop_front();
        int32_t near;
        int pass = sph_filter(&s.ray, &s.child, s.depth_max, &near);
        b.expect("out_pass_o", t.out_pass_o, pass, 1);
        b.expect("out_near_o", b.sget(t.out_near_o, 16), near, 16);
        if (s.must_pass) b.expect("out_pass_o, the exact test hits", t.out_pass_o, 1, 1);
        if (b.bad()) {
            show(b, s);
        }
        b.done();
    }
    source.hard.report(b);
    printf("# %ld exact hits, used %.3f of the margin %d\n", source.hits, source.margin,
           SPH_FILTER_MARGIN);
    return b.finish();
}
