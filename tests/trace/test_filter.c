/* test_filter.c - the node filter and the pruning depth never lose a hit
 * SPDX-License-Identifier: Apache-2.0
 *
 * The child is the smallest sphere in filter units that holds the leaf exactly, plus a margin.
 * Whatever the exact leaf test accepts the filter must accept, at the depth of the hit's own key.
 */
#include "vectors.h"

#include <math.h>
#include <string.h>

#include "trace/filter.h"
#include "trace/setup.h"

enum { MARGINS = 3 };

/* The most that axes see of a step along the ray, 2^-17 of it: the bound of the page. */
#define AXES_SEE 2.851

struct tally {
    uint64_t hits, lost[MARGINS]; /* lost with a margin of 0, 1, 2 filter units */
    uint64_t misses, passed;      /* exact misses; those that the filter lets through */
};

/* The smallest child without margin: c' to nearest, r' * 2^k >= rad + |c' * 2^k - ctr|. */
static struct sph_child child_of(const struct sph_leaf *s, int k) {
    struct sph_child c = {{0, 0, 0}, 0};
    int64_t off2 = 0;
    for (int i = 0; i < 3; i++) {
        c.ctr[i] = (int32_t)sph_round(s->ctr[i], k);
        int64_t v = (int64_t)c.ctr[i] * (1 << k) - s->ctr[i];
        off2 += v * v;
    }
    int64_t rad = s->rad >> k;
    while ((rad << k) < s->rad || ((rad << k) - s->rad) * ((rad << k) - s->rad) < off2)
        rad++;
    c.rad = (int32_t)rad;
    return c;
}

/* One ray (set up here) and one sphere with every margin. */
static void filter_case(const struct sph_profile *p, struct sph_ray *ray, const struct sph_leaf *s,
                        struct tally *t) {
    struct sph_child bare = child_of(s, p->w - p->fw);
    if (bare.rad + SPH_FILTER_MARGIN >= 1 << SPH_CHILD_RAD_BITS) return;
    for (int i = 0; i < 3; i++) /* what the builder keeps inside the word */
        if (bare.ctr[i] >= 1 << (p->fw - 1)) return;
    sph_ray_setup(p, ray);
    struct sph_leaf_result r = sph_leaf_test(ray, s);
    uint64_t roots = 0;
    int32_t depth = ray->depth_max, near;
    if (r.hit && ray->kind != SPH_SHADOW) depth = sph_ray_depth(p, ray, sph_leaf_key(&r, &roots));
    t->hits += (uint64_t)r.hit;
    t->misses += (uint64_t)!r.hit;
    for (int margin = 0; margin < MARGINS; margin++) {
        struct sph_child child = bare;
        child.rad += margin;
        int pass = sph_filter(ray, &child, depth, &near);
        t->lost[margin] += (uint64_t)(r.hit && !pass);
        if (margin == SPH_FILTER_MARGIN) t->passed += (uint64_t)(!r.hit && pass);
        if (r.hit && !pass && margin == SPH_FILTER_MARGIN && t->lost[margin] <= 3)
            printf("# %s kind %d inside %d: lost org (%ld, %ld, %ld) dir (%ld, %ld, %ld) ctr (%ld, "
                   "%ld, %ld) rad %ld, near %d depth %d exit %d\n",
                   p->name, ray->kind, ray->skip.inside, ray->org[0], ray->org[1], ray->org[2],
                   ray->dir[0], ray->dir[1], ray->dir[2], s->ctr[0], s->ctr[1], s->ctr[2], s->rad,
                   near, depth, r.exit);
    }
}

static void report(const char *what, const struct sph_profile *p, const struct tally *t) {
    printf("# %s, %s: %lu hits, lost %lu / %lu / %lu with margin 0 / 1 / 2; %.2f%% of %lu misses "
           "pass\n",
           what, p->name, t->hits, t->lost[0], t->lost[1], t->lost[2],
           100 * (double)t->passed / (double)(t->misses + !t->misses), t->misses);
    assert_true(t->hits > 1000 / VEC_SHARE);
    assert_int_equal(t->lost[SPH_FILTER_MARGIN], 0);
}

static void random_spheres(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("random_spheres");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        struct tally t = {0};
        for (int i = 0; i < 400000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            struct sph_leaf s;
            double graze = i % 2 ? sph_rng_range(&rng, 0.2, 4) : sph_rng_range(&rng, 0.98, 1.03);
            vec_ray(&rng, p, &ray);
            if (!vec_grazed(&rng, p, &ray, graze, &s)) continue;
            filter_case(p, &ray, &s, &t);
            ray.kind = SPH_SHADOW; /* the light a little behind or before the entry */
            for (int j = 0; j < 3; j++) {
                int64_t light = s.ctr[j] + vec_pick(&rng, -s.rad, s.rad), half = 1ll << (p->w - 1);
                light = light < -half ? -half : light >= half ? half - 1 : light;
                ray.dir[j] = light - ray.org[j];
            }
            filter_case(p, &ray, &s, &t);
        }
        report("random", p, &t);
    }
}

/* Everything at its worst: the centre on a filter point, a radius that fills its filter units, the
 * ray at 0.9995 of it on the side from which rounding moves the origin, by half a diagonal. */
static void adversarial(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("adversarial");
    uint64_t lost[2] = {0, 0};
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        int k = p->w - p->fw;
        int64_t half = 1ll << (p->w - 1), unit = 1ll << k, most = (1ll << (p->wd - 1)) - 1;
        struct tally t = {0};
        for (int i = 0; i < 1100000 / VEC_SHARE; i++) {
            struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
            struct sph_leaf s = {.id = 7};
            double side[3], to[3], len2 = 0, dot = 0, size2 = 0, longest = 0;
            s.rad = unit * vec_pick(&rng, 1, i % 2 ? 40 : 1 << (p->fw - 3)) + vec_pick(&rng, -1, 0);
            int turn = sph_rng_next(&rng) & 1 ? 1 : -1;
            double away[3], off = 0;
            for (int j = 0; j < 3; j++) { /* the origin's rounding moves it along `side` */
                int up = (int)(sph_rng_next(&rng) & 1);
                ray.org[j] = vec_pick(&rng, -half / unit, half / unit - 1) * unit;
                ray.org[j] += unit > 1 ? unit / 2 - !up : 0;
                side[j] = i % 5 ? (up ? turn : -turn) : sph_rng_range(&rng, -1, 1);
                away[j] = (ray.org[j] < 0 ? 1 : -1) * sph_rng_range(&rng, 0, 2) * (double)half;
                off += side[j] * away[j] / 3;
            }
            for (int j = 0; j < 3; j++) { /* the centre lies on a filter point */
                double c = rint(((double)ray.org[j] + away[j] - off * side[j]) / (double)unit);
                int64_t edge = half / unit;
                c = fmin(fmax(c, (double)-edge), (double)(edge - 1));
                s.ctr[j] = (int64_t)c * unit;
                if (i % 7 == 0) s.ctr[j] += vec_pick(&rng, 0, unit - 1);
                to[j] = (double)(s.ctr[j] - ray.org[j]);
                len2 += to[j] * to[j];
                dot += side[j] * to[j];
            }
            for (int j = 0; j < 3; j++) {
                side[j] -= dot / (len2 + 1e-9) * to[j];
                size2 += side[j] * side[j];
            }
            for (int j = 0; j < 3; j++) {
                to[j] += side[j] / sqrt(size2 + 1e-9) * 0.9995 * (double)s.rad;
                longest = fmax(longest, fabs(to[j]));
            }
            for (int j = 0; j < 3; j++)
                ray.dir[j] = (int64_t)rint(to[j] / (longest + 1e-9) * (double)most);
            filter_case(p, &ray, &s, &t);
        }
        report("adversarial", p, &t);
        lost[0] += t.lost[0];
        lost[1] += t.lost[1];
    }
    printf("# %lu hits would be lost without margin, %lu with one unit\n", lost[0], lost[1]);
    assert_true(lost[0] > 0);
    assert_true(lost[1] > 0 || SANITIZED); /* a share of the cases need not meet any */
}

/* Rays that bounce inside a sphere start on rounded points, a little outside of it as well: the
 * filter must keep their own sphere, whose exit counts as a hit. */
static void own_sphere(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("own_sphere");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        struct tally t = {0};
        for (int i = 0; i < 60000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            struct sph_leaf s = {.id = 7};
            int64_t half = 1ll << (p->w - 1), dir[3];
            vec_ray(&rng, p, &ray);
            s.rad = vec_pick(&rng, 1, i % 2 ? half / 2 : 64);
            for (int j = 0; j < 3; j++) {
                s.ctr[j] = ray.org[j] /= 4;
                s.ctr[j] += vec_pick(&rng, -s.rad, s.rad) * 4 / 7;
                ray.dir[j] = vec_pick(&rng, -2 * half, 2 * half - 1);
            }
            sph_ray_setup(p, &ray);
            for (int bounce = 0; bounce < 6; bounce++) {
                struct sph_leaf_result r = sph_leaf_test(&ray, &s);
                uint64_t roots = 0;
                if (!r.hit || !r.far) break;
                struct sph_hit hit = {sph_leaf_key(&r, &roots), 7, r.far != 0, 0};
                struct sph_surface at;
                sph_surface_at(p, &ray, &hit, &s, &at);
                sph_reflect(p, ray.dir, &at, dir);
                for (int j = 0; j < 3; j++) {
                    ray.org[j] = at.point[j];
                    ray.dir[j] = dir[j];
                }
                ray.kind = SPH_REFLECTED;
                ray.skip = (struct sph_skip){7, 1};
                filter_case(p, &ray, &s, &t);
            }
        }
        report("own sphere", p, &t);
    }
}

/* depth * 2^k >= key * |d_axis| / a, exactly, or the limit. */
static void depth_bounds(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("depth_bounds");
    for (int n = 0; n < SPH_PROFILES; n++) {
        const struct sph_profile *p = &sph_profiles[n];
        uint64_t below = 0, count = 0;
        double excess = 0;
        for (int i = 0; i < 400000 / VEC_SHARE; i++) {
            struct sph_ray ray;
            vec_ray(&rng, p, &ray);
            sph_ray_setup(p, &ray);
            if (!ray.a) continue;
            uint64_t key = vec_unsigned(&rng, p->w + p->wd + 2);
            if (i % 2) key = (uint64_t)(sqrt((double)ray.a) * sph_rng_range(&rng, 0, 1 << p->w));
            if (!key) key = 1;
            int32_t depth = sph_ray_depth(p, &ray, key);
            int64_t d = ray.dir[ray.axis] < 0 ? -ray.dir[ray.axis] : ray.dir[ray.axis];
            if (depth == sph_depth_limit(p)) continue;
            sph_u128 bound = (sph_u128)(uint64_t)depth * ray.a << (p->w - p->fw);
            sph_u128 reach = (sph_u128)key * (uint64_t)d;
            if (bound < reach && !below++)
                printf("# %s: dir (%ld, %ld, %ld) key %lu: depth %d is too small\n", p->name,
                       ray.dir[0], ray.dir[1], ray.dir[2], key, depth);
            double units = (double)reach / (double)ray.a / (double)(1 << (p->w - p->fw));
            if (ray.a >> (2 * p->wd - 4)) excess = fmax(excess, depth - units * (1 + 0x1p-11));
            count++;
        }
        printf("# %s: depth bounds %lu keys, full-length directions at most %.1f units + "
               "2^-11 too deep\n",
               p->name, count, excess);
        assert_int_equal(below, 0);
        assert_true(count > 100000 / VEC_SHARE);
    }
}

/* What the filter's proof asks of axes across a ray (docs/design/traversal.md), exactly, in squares
 * of 2^-17 or 2^-34: p, q and no mixture of them is longer than 1. *along: how much of a step along
 * the ray they see, squared, 1 at most. */
static int axes_hold(const int64_t dir[3], int bits, double *longest, double *along) {
    uint64_t a = 0;
    double d = 0, seen = 0;
    for (int k = 0; k < 3; k++) {
        a += (uint64_t)(dir[k] * dir[k]);
        d += (double)dir[k] * (double)dir[k];
    }
    struct sph_unit unit = sph_unit(dir, a, bits);
    struct sph_across x = sph_across(unit.u);
    int64_t p[3] = {0}, pp = 0, qq = 0, pq = 0, one = 1ll << 34;
    p[x.axis_a] = x.p_a;
    p[x.axis_b] = -x.p_b;
    sph_i128 p_along = 0, q_along = 0;
    for (int k = 0; k < 3; k++) {
        pp += p[k] * p[k];
        qq += (int64_t)x.q[k] * x.q[k];
        pq += p[k] * x.q[k];
        p_along += (sph_i128)p[k] * dir[k];
        q_along += (sph_i128)x.q[k] * dir[k];
    }
    /* 1 less the matrix of squares has no negative eigenvalue */
    int holds = pp < one && qq < one && (sph_i128)(one - pp) * (one - qq) >= (sph_i128)pq * pq;
    double mean = (double)(pp + qq) / 2, half = (double)(pp - qq) / 2;
    *longest = mean + sqrt(half * half + (double)pq * (double)pq) - (double)one;
    seen = (double)p_along * (double)p_along + (double)q_along * (double)q_along;
    *along = sqrt(seen / d);
    return holds && *along <= AXES_SEE;
}

/* Directions of all kinds, then from the worst of them on by steps that make it worse. */
static void axes(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("axes");
    const int bits = 26;
    const int64_t half = 1ll << (bits - 1);
    double worst[2] = {-1e18, 0};
    uint64_t broken = 0;
    for (int i = 0; i < 400 / VEC_SHARE; i++) {
        int goal = i % 2; /* longer, or along the ray */
        int64_t best[3] = {half - 1, 0, 0}, dir[3];
        double value[2], most = -1e18;
        for (int step = 0; step < 3000; step++) {
            for (int k = 0; k < 3; k++) {
                int reach = (int)vec_pick(&rng, 1, step < 300 ? bits - 1 : 14);
                int64_t far = 1ll << reach;
                dir[k] = step < 300
                             ? vec_pick(&rng, -half, half - 1)
                             : best[k] + (vec_pick(&rng, 0, 2) ? vec_pick(&rng, -far, far) : 0);
                dir[k] = dir[k] < -half ? -half : dir[k] >= half ? half - 1 : dir[k];
            }
            if (!dir[0] && !dir[1] && !dir[2]) continue;
            broken += (uint64_t)!axes_hold(dir, bits, &value[0], &value[1]);
            for (int k = 0; k < 2; k++)
                worst[k] = fmax(worst[k], value[k]);
            if (value[goal] <= most) continue;
            most = value[goal];
            memcpy(best, dir, sizeof best);
        }
    }
    printf("# axes: longest %.2f units of 2^-17 from 1, of a step along the ray %.3f of 2^-17\n",
           worst[0] / 0x1p18, worst[1]);
    assert_int_equal(broken, 0);
    assert_true(worst[0] > -0x1p18 * 8 && worst[1] > 1.5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_spheres), cmocka_unit_test(adversarial),
        cmocka_unit_test(own_sphere),     cmocka_unit_test(depth_bounds),
        cmocka_unit_test(axes),
    };
    return cmocka_run_group_tests_name("filter", tests, NULL, NULL);
}
