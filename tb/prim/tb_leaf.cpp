/* tb_leaf.cpp - rt_leaf against sph_leaf_test()
 * SPDX-License-Identifier: Apache-2.0
 *
 * The first vectors are the 2^9 patterns of least and greatest operands with the radii 0, 1 and
 * greatest; then the cases of tests/hard; then families like them in turn (`family`), by reason.
 * The switch of INSIDE changes while the pipeline is empty; what is not elaborated gets inputs all
 * the same.
 */
#include <cmath>
#include <deque>
#include "Vrt_leaf.h"
#include "bench.h"
#include "hard.h"
extern "C" {
#include "prim/sphere.h"
}

#ifndef INTERVAL
#define INTERVAL 2
#endif

namespace {

constexpr int larger(int a, int b) {
    return a > b ? a : b;
}
constexpr uint64_t multiply(int bits) {
    return bits <= 18 ? 1 : (uint64_t)(bits + 15) / 17 + 1;
}
constexpr uint64_t LATENCY =
    INTERVAL == 4 ? (W <= 16 && WD <= 17 ? 16 : 20)
                  : multiply(larger(W + 1, WD)) + multiply(larger(2 * W + 3, 2 * WD + 1)) + 8;

constexpr int64_t C_MIN = -((int64_t)1 << (W - 1)), C_MAX = -C_MIN - 1,
                  R_MAX = ((int64_t)1 << W) - 1;
constexpr int64_t D_MIN = -((int64_t)1 << (WD - 1)), D_MAX = -D_MIN - 1;

struct Vector {
    sph_ray ray{};
    sph_leaf leaf{};
    unsigned tag = 0;
    int family = 0;
    uint64_t taken = 0;  /* cycle */
    bool shadow = false; /* the port; a shadow ray only if they are elaborated */
    hard::Case hard;
};

int64_t clamp(int64_t x, int64_t low, int64_t high) {
    return x < low ? low : x > high ? high : x;
}

class Source {
  public:
    hard::Source hard;

    Source(bench::Random &r, uint64_t seed)
        : hard(
              seed, [](const sph_profile &p) { return p.w == W && p.wd == WD; },
              [](const hard::Case &c) { return c.is_ray; }),
          random(r) {}

    Vector next() {
        Vector v;
        v.leaf.id = (uint32_t)random.bits(random.percent(50) ? 2 : 24);
        v.ray.skip.id = random.percent(20) ? v.leaf.id : random.percent(50) ? 0xffffff : 1;
        v.ray.skip.inside = random.percent(50);
        v.ray.kind = random.percent(33) ? SPH_SHADOW : SPH_PRIMARY;
        v.tag = (unsigned)random.bits(TAG);
        if (!hard::alone() && count < 3 * 512 * 2)
            v.family = 0, extremes(v, count++);
        else if (from_tests(v))
            v.family = -1;
        else
            v.family = 1 + (int)random.below(14), fill(v);
        const int64_t *d = v.ray.dir;
        v.ray.a = (uint64_t)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        v.shadow = v.ray.kind == SPH_SHADOW;
        if (!SHADOW) v.ray.kind = SPH_PRIMARY;
        return v;
    }

  private:
    bench::Random &random;
    unsigned count = 0;

    int64_t coord() { return random.between(C_MIN, C_MAX); }
    int64_t sgn(int64_t x) { return random.percent(50) ? x : -x; }

    bool from_tests(Vector &v) {
        if (!hard.next(v.hard)) return false;
        v.ray = v.hard.ray;
        v.leaf = v.hard.leaf;
        return true;
    }

    /* 24, 25: all operands at an end: no wrap error, disc at its least and greatest. */
    void extremes(Vector &v, unsigned n) {
        static const int64_t rad[3] = {0, 1, R_MAX};
        for (int i = 0; i < 3; i++) {
            v.leaf.ctr[i] = n >> i & 1 ? C_MIN : C_MAX;
            v.ray.org[i] = n >> (3 + i) & 1 ? C_MIN : C_MAX;
            v.ray.dir[i] = n >> (6 + i) & 1 ? D_MIN : D_MAX;
        }
        v.leaf.rad = rad[(n >> 9) % 3];
        if (n >= 3 * 512) v.ray.kind = SPH_SHADOW, v.ray.skip.id = 0xffffff;
    }

    /* Integers e1, e2, e3 orthogonal and all of length s (quaternion frame), s small enough. */
    void frame(int64_t e[3][3], int64_t &s, int64_t most) {
        int64_t a, b, c, d, q = (int64_t)std::sqrt((double)most);
        do {
            a = random.between(-q, q), b = random.between(-q, q);
            c = random.between(-q, q), d = random.between(-q, q);
            s = a * a + b * b + c * c + d * d;
        } while (s == 0 || s > most);
        int64_t m[3][3] = {
            {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                e[i][j] = m[j][i];
    }

    /* Centre at org + oc, both inside the world; oc is cut if it is too long. */
    void place(Vector &v, const int64_t oc[3]) {
        for (int i = 0; i < 3; i++) {
            int64_t o = clamp(oc[i], C_MIN, C_MAX);
            int64_t first = o < 0 ? C_MIN - o : C_MIN, last = o < 0 ? C_MAX : C_MAX - o;
            v.ray.org[i] = random.between(first, last);
            v.leaf.ctr[i] = v.ray.org[i] + o;
        }
    }

    void any(Vector &v) {
        for (int i = 0; i < 3; i++) {
            v.leaf.ctr[i] = random.smixed(W);
            v.ray.org[i] = random.smixed(W);
            v.ray.dir[i] = random.smixed(WD);
        }
        v.leaf.rad = (int64_t)random.mixed(W);
    }

    /* Direction from the origin to the centre, shortened or lengthened, off by up to `off`. */
    void aim(Vector &v, int64_t off) {
        int shift = (int)random.below(3);
        for (int i = 0; i < 3; i++) {
            int64_t oc = v.leaf.ctr[i] - v.ray.org[i];
            v.ray.dir[i] = clamp((oc >> shift) + random.between(-off, off), D_MIN, D_MAX);
        }
    }

    void fill(Vector &v) {
        int64_t e[3][3], s, oc[3], alpha, beta, *d = v.ray.dir;
        any(v);
        switch (v.family) {
        case 1:
            break; /* 13, 47: no structure */
        case 2:    /* aimed, every size of sphere */
            v.leaf.rad = (int64_t)random.log_bits(W);
            aim(v, 1 + v.leaf.rad);
            break;
        case 3: /* 1, 3, 5: tangent exactly (disc = 0, a miss) or one unit off in one operand */
        case 4: /* 9, 10, 11: the same frame with rad = |oc|: the origin on the surface, k = 0 */
            frame(e, s, W > 4 ? C_MAX / 2 : 1);
            alpha = random.between(0, C_MAX / s), beta = random.between(0, C_MAX / s);
            if (v.family == 4) beta = 0;
            for (int i = 0; i < 3; i++)
                oc[i] = alpha * e[0][i] + beta * e[1][i];
            place(v, oc);
            v.leaf.rad = (v.family == 4 ? alpha : beta) * s;
            if (v.leaf.rad > R_MAX) v.leaf.rad = R_MAX;
            if (v.family == 3 || random.percent(50)) {
                int axis = v.family == 3 ? 0 : (int)random.below(3), sign = random.percent(50);
                for (int i = 0; i < 3; i++)
                    d[i] = sign ? -e[axis][i] : e[axis][i];
            }
            switch (random.below(5)) {
            case 0:
                v.leaf.rad = clamp(v.leaf.rad + sgn(1), 0, R_MAX);
                break;
            case 1:
                d[random.below(3)] += sgn(1);
                break;
            case 2: {
                int64_t &c = v.leaf.ctr[random.below(3)];
                c = clamp(c + sgn(1), C_MIN, C_MAX);
                break;
            }
            default:
                break;
            }
            break;
        case 5: { /* 2: Pell pairs R^2 - 2y^2 = 1: disc = a, the smallest of hits */
            int64_t r = 3, y = 2, n = 0;
            while (3 * r + 4 * y < C_MAX && random.percent(80)) {
                int64_t r2 = 3 * r + 4 * y;
                y = 2 * r + 3 * y, r = r2;
            }
            n = random.between(0, C_MAX - clamp(y, 0, C_MAX));
            oc[0] = y + n, oc[1] = n - y, oc[2] = 0;
            place(v, oc);
            v.leaf.rad = clamp(r, 0, R_MAX);
            d[0] = d[1] = 1, d[2] = 0;
            break;
        }
        case 6: { /* 4: radius just below and above the distance of the centre from the ray */
            aim(v, random.between(0, D_MAX / 2));
            double len2 = 0, cross2 = 0;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3, k = (i + 2) % 3;
                double c = (double)(v.leaf.ctr[j] - v.ray.org[j]) * (double)d[k] -
                           (double)(v.leaf.ctr[k] - v.ray.org[k]) * (double)d[j];
                cross2 += c * c, len2 += (double)d[i] * (double)d[i];
            }
            double distance = len2 > 0 ? std::sqrt(cross2 / len2) : 0;
            v.leaf.rad = clamp((int64_t)distance + random.between(0, 1), 0, R_MAX);
            break;
        }
        case 7: /* 6: tiny and far, corner to corner */
            for (int i = 0; i < 3; i++) {
                bool low = random.percent(50);
                v.ray.org[i] = low ? C_MIN + random.between(0, 1) : C_MAX - random.between(0, 1);
                v.leaf.ctr[i] = low ? C_MAX - random.between(0, 1) : C_MIN + random.between(0, 1);
            }
            v.leaf.rad = random.between(0, 2);
            aim(v, random.between(0, 2));
            break;
        case 8: { /* 7, 8: huge sphere, the origin one unit outside, on and one unit inside */
            int axis = (int)random.below(3);
            v.leaf.ctr[axis] = C_MIN;
            v.leaf.rad = R_MAX - 1 - random.between(0, 1);
            for (int i = 0; i < 3; i++)
                v.ray.org[i] = v.leaf.ctr[i] = i == axis ? C_MIN : coord();
            v.ray.org[axis] = clamp(C_MIN + v.leaf.rad + random.between(-1, 1), C_MIN, C_MAX);
            break;
        }
        case 9: { /* 12 to 15, 17: origin rounded onto the surface, its own id, any direction */
            double u[3], len = 0;
            v.leaf.rad = 1 + (int64_t)random.log_bits(W - 1);
            for (int i = 0; i < 3; i++)
                u[i] = (double)random.sbits(20), len += u[i] * u[i];
            for (int i = 0; i < 3; i++) {
                oc[i] = std::lround(u[i] / std::sqrt(len + 1) * (double)v.leaf.rad);
                oc[i] += random.percent(20) ? sgn(1) : 0;
            }
            place(v, oc);
            if (random.percent(75)) v.ray.skip.id = v.leaf.id;
            if (random.percent(40)) /* a graze: direction across oc */
                d[0] = clamp(oc[1], D_MIN, D_MAX), d[1] = clamp(-oc[0], D_MIN, D_MAX), d[2] = 0;
            else if (random.percent(50))
                aim(v, random.between(0, 3));
            break;
        }
        case 10: /* 18, 19, 20: directions along an axis, of length one, (+-1, 0, 2^k) */
            d[0] = d[1] = d[2] = 0;
            d[random.below(3)] = random.percent(50) ? sgn(1) : random.smixed(WD);
            if (random.percent(50)) d[random.below(3)] = sgn((int64_t)1 << random.below(WD - 1));
            if (random.percent(70)) {
                int64_t t = random.between(-3, 3);
                for (int i = 0; i < 3; i++)
                    oc[i] = clamp(d[i] * t, C_MIN, C_MAX);
                place(v, oc);
                v.leaf.rad = (int64_t)random.log_bits(W / 2);
            }
            break;
        case 11: /* 21, 22, 23, 37: nothing: dir = 0, rad = 0, centre = origin, and all of these */
            if (random.percent(50)) d[0] = d[1] = d[2] = 0;
            if (random.percent(50)) v.leaf.rad = 0;
            if (random.percent(50))
                for (int i = 0; i < 3; i++)
                    v.ray.org[i] = v.leaf.ctr[i];
            if (random.percent(50)) aim(v, 0);
            break;
        case 12: /* 26: k*a and b*b cancel: the sphere just touches the ray; the longest carries */
            for (int i = 0; i < 3; i++)
                oc[i] = random.between(C_MIN, C_MAX);
            place(v, oc);
            aim(v, 1);
            v.leaf.rad = random.between(0, 2);
            break;
        case 13: /* 35, 36: shadow ray whose light is on the surface (k_light = 0), in it, beside */
            frame(e, s, W > 4 ? C_MAX / 2 : 1);
            alpha = random.between(0, C_MAX / s);
            v.leaf.rad = clamp(alpha * s, 0, R_MAX);
            for (int i = 0; i < 3; i++)
                oc[i] = alpha * e[0][i];
            place(v, oc); /* light here for now */
            if (random.percent(50))
                v.leaf.rad = clamp(v.leaf.rad + random.between(-1, 1), 0, R_MAX);
            for (int i = 0; i < 3; i++) {
                int64_t light = v.ray.org[i];
                v.ray.org[i] = coord();
                d[i] = light - v.ray.org[i];
            }
            v.ray.kind = SPH_SHADOW;
            break;
        case 14: /* 16, 32: origin at or near the centre; 34: sphere behind the origin */
            if (random.percent(50))
                for (int i = 0; i < 3; i++)
                    v.ray.org[i] = clamp(v.leaf.ctr[i] + random.between(-2, 2), C_MIN, C_MAX);
            else {
                aim(v, 1 + v.leaf.rad / 4);
                for (int i = 0; i < 3; i++)
                    d[i] = clamp(-d[i], D_MIN, D_MAX);
            }
            break;
        default:
            break;
        }
        for (int i = 0; i < 3; i++)
            d[i] = clamp(d[i], D_MIN, D_MAX);
    }
};

using Bench = bench::Bench<Vrt_leaf>;

void drive(Bench &b, const Vector &v) {
    Vrt_leaf &t = b.dut;
    b.set(t.in_tag_i, TAG, v.tag);
    b.set(t.in_ctr_x_i, W, v.leaf.ctr[0]);
    b.set(t.in_ctr_y_i, W, v.leaf.ctr[1]);
    b.set(t.in_ctr_z_i, W, v.leaf.ctr[2]);
    b.set(t.in_rad_i, W, v.leaf.rad);
    b.set(t.in_id_i, 24, v.leaf.id);
    b.set(t.in_org_x_i, W, v.ray.org[0]);
    b.set(t.in_org_y_i, W, v.ray.org[1]);
    b.set(t.in_org_z_i, W, v.ray.org[2]);
    b.set(t.in_dir_x_i, WD, v.ray.dir[0]);
    b.set(t.in_dir_y_i, WD, v.ray.dir[1]);
    b.set(t.in_dir_z_i, WD, v.ray.dir[2]);
    b.set(t.in_a_i, 2 * WD, (bench::i128)v.ray.a);
    t.in_shadow_i = v.shadow;
    b.set(t.in_skip_id_i, 24, v.ray.skip.id);
    t.in_skip_inside_i = v.ray.skip.inside != 0;
}

void compare(Bench &b, const Vector &s, const sph_leaf_result &r) {
    Vrt_leaf &t = b.dut;
    int disc_bits = 2 * W + 2 * WD;
    b.expect("out_tag_o", (bench::i128)b.get(t.out_tag_o), s.tag, TAG);
    b.expect("out_id_o", (bench::i128)b.get(t.out_id_o), s.leaf.id, 24);
    b.expect("out_hit_o", t.out_hit_o, r.hit, 1);
    b.expect("out_far_o", t.out_far_o, r.far, 1);
    b.expect("out_exit_o", t.out_exit_o, r.exit, 1);
    b.expect("out_b_o", b.sget(t.out_b_o, W + WD + 2), r.b, W + WD + 2);
    b.expect("out_disc_o", (bench::i128)b.get(t.out_disc_o),
             (bench::i128)bench::low((bench::u128)r.disc, disc_bits), disc_bits);
    if (b.bad()) {
        static const char *names[3][3] = {{"in_ctr_x_i", "in_ctr_y_i", "in_ctr_z_i"},
                                          {"in_org_x_i", "in_org_y_i", "in_org_z_i"},
                                          {"in_dir_x_i", "in_dir_y_i", "in_dir_z_i"}};
        printf("# inputs, family %d\n", s.family);
        s.hard.show();
        for (int i = 0; i < 3; i++)
            b.show(names[0][i], s.leaf.ctr[i], W);
        b.show("in_rad_i", s.leaf.rad, W);
        for (int i = 0; i < 3; i++)
            b.show(names[1][i], s.ray.org[i], W);
        for (int i = 0; i < 3; i++)
            b.show(names[2][i], s.ray.dir[i], WD);
        b.show("in_a_i", (bench::i128)s.ray.a, 2 * WD);
        b.show("in_id_i", s.leaf.id, 24);
        b.show("in_skip_id_i", s.ray.skip.id, 24);
        b.show("in_skip_inside_i", s.ray.skip.inside, 1);
        b.show("in_shadow_i", s.shadow, 1);
        b.show("inside_on_i", t.inside_on_i, 1);
        b.show("model k", r.k, 2 * W + 3);
        b.show("model disc", r.disc, disc_bits + 2);
    }
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_leaf> b("tb_leaf", argc, argv, 300000);
    Source source(b.random, b.seed);
    source.hard.limit(b);
    std::deque<Vector> sent;
    Vector v = source.next();
    bool offered = false;
    unsigned gaps = 0;
    bool change = false, refused = false; /* a k >= 0 was refused because INSIDE is off */
    Vrt_leaf &t = b.dut;
    t.in_valid_i = 0;
    t.inside_on_i = 1;
    b.reset();
    uint64_t ready = b.cycle;
    while (b.more()) {
        if (b.cycle % 4096 == 0) {
            gaps = (unsigned)b.random.below(3) * 30; /* 0: back to back */
            change = true;
        }
        if (v.hard.given && !offered) change = v.hard.ray.inside != t.inside_on_i;
        if (change && !offered && sent.empty()) {
            t.inside_on_i = v.hard.given ? v.hard.ray.inside != 0 : b.random.percent(50);
            change = false;
        }
        if (!offered && !change) offered = !b.random.percent(gaps);
        v.ray.inside = INSIDE && t.inside_on_i;
        t.in_valid_i = offered;
        drive(b, v);
        b.settle();
        if (t.in_ready_o) ready = b.cycle;
        if (b.cycle - ready >= INTERVAL) b.fail("in_ready_o is low for too long");
        if (offered && t.in_ready_o) {
            v.taken = b.cycle;
            sent.push_back(v);
            v = source.next();
            offered = false;
        }
        b.tick();
        if (!t.out_valid_o) continue;
        if (sent.empty()) {
            b.fail("a result that nobody asked for");
            break;
        }
        Vector s = sent.front();
        sent.pop_front();
        sph_leaf_result r = sph_leaf_test(&s.ray, &s.leaf);
        refused = refused || (!s.ray.inside && r.k > 0);
        b.expect("latency", (bench::i128)(b.cycle - s.taken), LATENCY);
        compare(b, s, r);
        b.done();
    }
    source.hard.report(b);
    if (b.vectors > 50000 && !refused) b.fail("no origin inside a sphere with INSIDE off");
    return b.finish();
}
