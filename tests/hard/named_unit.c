/* named_unit.c - named cases 38 to 45: root, quotient, surface point and node on their own
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "builder/grid/bound.h"
#include "math/arith.h"
#include "named.h"
#include "surface.h"
#include "trace/filter.h"
#include "trace/setup.h"

static void check_root(struct named *n, sph_u128 x) {
    int inexact;
    uint64_t s = sph_isqrt(x, &inexact);
    if (n->list) hard_list_add(n->list, (struct hard_item){.what = HARD_ROOT, .x = x});
    require(n, (sph_u128)s * s <= x && x < (sph_u128)(s + 1) * (s + 1),
            "root of %lu * 2^64 + %lu is %lu", (uint64_t)(x >> 64), (uint64_t)x, s);
    require(n, inexact == ((sph_u128)s * s != x), "inexact of root %lu", s);
    n->vectors++;
}

void named_isqrt(struct named *n) {
    int bits = 2 * n->p->w + 2 * n->p->wd;
    for (int i = 0; i <= bits; i++)
        for (int j = 0; j <= i; j++)
            for (int off = -1; off <= 1; off++) {
                sph_u128 root = ((sph_u128)1 << (i / 2)) + ((sph_u128)1 << (j / 2)) - 1;
                check_root(n, root * root - (off < 0));
                check_root(n, root * root + (off > 0));
                check_root(n, ((sph_u128)1 << i) + ((sph_u128)1 << j) - 1);
            }
    struct sph_rng rng = {38};
    for (int i = 0; i < 300; i++) {
        struct hard_case c;
        gen_start(&c);
        gen_root(&rng, n->p, &c);
        expect(n, c, ORACLE, 0);
    }
}

static void check_quotient(struct named *n, uint64_t key, uint64_t a) {
    const struct sph_profile *p = n->p;
    if (!key || key >> (p->w + p->wd + 2)) return;
    struct sph_quotient q = sph_quotient(key, p->w + p->wd + 2, a, 2 * p->wd, p->pq);
    struct hard_item item = {.what = HARD_QUOTIENT_OF, .key = key, .a = a};
    if (n->list) hard_list_add(n->list, item);
    require(n, exact_is_quotient(p, key, a, &q), "%lu / %lu is %u * 2^-%d", key, a, q.mant, q.exp);
    n->vectors++;
}

void named_quotient(struct named *n) {
    uint64_t d = (uint64_t)n->most + 1, as[] = {1,
                                                2,
                                                3,
                                                d - 1,
                                                d,
                                                d * d,
                                                d * d - 1,
                                                3 * d * d,
                                                2 * d * d,
                                                d * d + 1,
                                                3 * (d - 1) * (d - 1)};
    for (size_t i = 0; i < sizeof as / sizeof *as; i++)
        for (uint64_t t = 1; t < 4 * d; t = t + 1 + t / 3)
            for (int off = -1; off <= 1; off++) {
                check_quotient(n, as[i] * t + (uint64_t)off, as[i]);
                check_quotient(n, as[i] / t + (uint64_t)off, as[i]);
                check_quotient(n, ((uint64_t)1 << (t % 50)) + (uint64_t)off, as[i]);
            }
}

/* The far side of a sphere at the end of the grid lies outside of it. */
void named_off_grid(struct named *n) {
    for (int sign = -1; sign <= 1; sign += 2)
        for (int64_t out = 1; out < n->half / 2; out *= 2) {
            int64_t r = n->half / 2 + out, x = sign * n->half / 2;
            struct hard_case c = vector(V3(x, 0, 0), V3(sign * n->most, 1, 0), V3(x, 0, 0), r);
            struct sph_surface s;
            uint64_t roots = 0;
            expect(n, c, FAR, 0);
            sph_ray_setup(n->p, &c.ray);
            struct sph_leaf_result l = sph_leaf_test(&c.ray, &c.sphere[0]);
            struct sph_hit hit = {sph_leaf_key(&l, &roots), HARD_ID, l.far != 0, 0};
            int limited = sph_surface_at(n->p, &c.ray, &hit, &c.sphere[0], &s);
            int at_end = s.point[0] == (sign < 0 ? -n->half : n->half - 1);
            int may_round = out <= 8; /* the quotient may stop short of the grid's end */
            require(n, (limited && at_end) || may_round, "a point %ld units off is not limited",
                    out);
        }
}

/* A hit whose point is the centre itself: the normal is -dir and the ray goes back. */
void named_normal0(struct named *n) {
    for (int64_t m = 16; m <= n->most / 2; m *= 2) {
        int64_t k = n->half / 4, back[3];
        struct hard_case c = vector(V3(0, 0, 0), V3(m, 2 * m, -m), V3(k, 2 * k, -k), 1);
        struct sph_surface s;
        sph_ray_setup(n->p, &c.ray);
        expect(n, c, NEAR, 0);
        struct sph_hit hit = {(uint64_t)(6 * m * k), HARD_ID, 0, 0};
        struct hard_item item = {.what = HARD_POINT_AT, .c = c, .key = hit.key};
        if (n->list) hard_list_add(n->list, item);
        int limited = sph_surface_at(n->p, &c.ray, &hit, &c.sphere[0], &s);
        sph_i128 minus[3] = {-m, -2 * m, m};
        exact_normalise(minus, n->p->wd, back);
        require(n, !limited && !memcmp(s.point, c.sphere[0].ctr, sizeof s.point), "not the centre");
        require(n, !memcmp(s.normal, back, sizeof back), "the normal is not -dir");
        sph_reflect(n->p, c.ray.dir, &s, back);
        require(n, back[0] < 0 && back[1] == 2 * back[0] && back[2] == -back[0],
                "the mirror ray does not go back");
    }
}

/* Directions at right angles to the normal go on. */
void named_grazed(struct named *n) {
    struct sph_rng rng = {42};
    for (int i = 0; i < 200; i++) {
        int64_t u[3], v[3], w[3], out[3], same[3];
        int64_t length = gen_frame(&rng, 1ll << (n->p->wd / 2 - 2), u, v, w);
        struct sph_surface s = {.nn = 0};
        struct hard_item item = {.what = HARD_MIRROR};
        sph_i128 big[3];
        for (int j = 0; j < 3; j++) {
            s.normal[j] = v[j];
            s.nn += (uint64_t)(v[j] * v[j]);
            big[j] = (sph_i128)u[j] * length * length;
            item.dir[j] = u[j];
            item.normal[j] = v[j];
        }
        if (n->list) hard_list_add(n->list, item);
        sph_reflect(n->p, u, &s, out);
        exact_normalise(big, n->p->wd, same);
        require(n, !memcmp(out, same, sizeof out), "a grazing ray is turned");
        n->vectors++;
    }
}

/* rad' * 2^k >= rad + |ctr' * 2^k - ctr|, and one less does not do. */
static void check_node(struct named *n, const struct sph_ball *ball) {
    struct sph_ball f = sph_filter_leaf(ball, n->p);
    int k = n->p->w - n->p->fw;
    int64_t off2 = 0, room = ((int64_t)f.r << k) - ball->r;
    for (int i = 0; i < 3; i++) {
        int64_t off = (int64_t)f.c[i] * (1 << k) - ball->c[i];
        off2 += off * off;
    }
    require(n, room >= 0 && room * room >= off2, "the node's sphere does not hold its child");
    room -= 1ll << k;
    require(n, room < 0 || room * room < off2, "the node's radius is one too large");
    n->vectors++;
}

/* The filter takes a ray that touches the node's sphere, from any side, and none further off. */
static void touch_node(struct named *n, int64_t rad) {
    int64_t unit = 1ll << (n->p->w - n->p->fw), off = rad + SPH_FILTER_MARGIN;
    for (int side = -1; side <= 1; side += 2) {
        struct hard_case c = vector(V3(-n->half / 2, 0, 0), V3(n->most, 0, 0),
                                    V3(0, side * off * unit, 0), rad * unit);
        struct sph_child child = {{0, (int32_t)(side * off), 0}, (int32_t)off};
        int32_t near;
        expect(n, c, MISS, 0);
        sph_ray_setup(n->p, &c.ray);
        require(n, sph_filter(&c.ray, &child, c.ray.depth_max, &near), "a node touched is left");
        child.ctr[1] += side;
        require(n, !sph_filter(&c.ray, &child, c.ray.depth_max, &near), "a node beside is taken");
    }
}

/* Across such a ray an axis is 8191/8192 long, so a distance of 7000 is cut to 6999. */
static void touch_cut(struct named *n) {
    int64_t unit = 1ll << (n->p->w - n->p->fw), off = 7000, rad = off - 1 - SPH_FILTER_MARGIN;
    if (off >= 1 << (n->p->fw - 1)) return;
    for (int side = -1; side <= 1; side += 2) {
        struct hard_case c = vector(V3(-n->half / 2, 0, 0), V3(1ll << (n->p->wd - 2), 0, 0),
                                    V3(0, side * off * unit, 0), rad * unit);
        struct sph_child child = {{0, (int32_t)(side * off), 0}, (int32_t)off - 1};
        int32_t near;
        expect(n, c, MISS, 0);
        sph_ray_setup(n->p, &c.ray);
        require(n, sph_filter(&c.ray, &child, c.ray.depth_max, &near), "a distance of rad is left");
        child.rad--;
        require(n, !sph_filter(&c.ray, &child, c.ray.depth_max, &near), "one above rad is taken");
    }
}

/* The filter takes a node that begins just where the hit lies, and none that begins behind it. */
static void touch_depth(struct named *n) {
    for (int side = -1; side <= 1; side += 2)
        for (int32_t rad = SPH_FILTER_MARGIN; rad < 1 << (n->p->fw - 3); rad = 3 * rad + 1) {
            struct hard_case c = vector(V3(-side * n->half / 2, 0, 0), V3(side * n->most, 0, 0),
                                        V3(side * n->half / 4, 0, 0), 1);
            struct sph_child child = {{side * rad, 0, 0}, rad};
            int32_t near, begin = 1 << (n->p->fw - 2); /* half / 2 in the filter's units */
            sph_ray_setup(n->p, &c.ray);
            require(n, sph_filter(&c.ray, &child, begin, &near),
                    "a node as deep as the hit is left");
            require(n, near == begin, "a node begins at %d in place of %d", near, begin);
            require(n, !sph_filter(&c.ray, &child, begin - 1, &near), "a node behind is taken");
            n->vectors++;
        }
}

void named_node_radius(struct named *n) {
    touch_cut(n);
    touch_depth(n);
    int64_t unit = 1ll << (n->p->w - n->p->fw);
    for (int64_t rad = 1; rad < 1ll << (n->p->fw - 2); rad = 3 * rad + 1)
        touch_node(n, rad);
    for (int64_t r = 1; r < 40; r++)
        for (int off = 0; off < 27; off++) {
            struct sph_ball ball = {{0, 0, 0}, (int32_t)(r * unit / 8)};
            if (!ball.r) continue;
            for (int i = 0, j = off; i < 3; i++, j /= 3)
                ball.c[i] = (int32_t)(unit * 5 + (j % 3) * unit / 2);
            check_node(n, &ball);
            ball.r++;
            check_node(n, &ball);
        }
}

void named_node_largest(struct named *n) {
    int64_t half = n->half, rads[] = {half - 1, half, half + half / 2};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 8; j++) {
            int64_t x = j & 1 ? -half : half - 1, y = j & 2 ? -half : half - 1;
            int64_t z = j & 4 ? -half : half - 1;
            struct sph_ball ball = {{0, 0, -1}, (int32_t)rads[i]};
            expect(n, vector(V3(x, y, z), V3(-x, -y, -z), V3(0, 0, -1), rads[i]), NEAR, 0);
            expect(n, vector(V3(0, 0, 0), V3(x, y, z), V3(0, 0, -1), rads[i]), FAR, 0);
            check_node(n, &ball);
        }
}

/* Origins at the upper end saturate in filter units; spheres that the ray touches from there. */
void named_node_corner(struct named *n) {
    struct sph_rng rng = {45};
    for (int i = 0; i < 1500; i++) {
        struct hard_case c;
        gen_start(&c);
        gen_filter(&rng, n->p, &c);
        for (int j = 0; j < 3; j++)
            if (gen_one_in(&rng, 2)) c.ray.org[j] = n->half - vec_pick(&rng, 1, 2);
        double to[3], side = (double)c.sphere[0].rad * 0.57;
        for (int j = 0; j < 3; j++)
            to[j] = (double)c.sphere[0].ctr[j] + (gen_one_in(&rng, 2) ? side : -side);
        gen_aim(&rng, n->p, to, n->p->wd - 2, &c);
        expect(n, c, ORACLE, 0);
    }
}
