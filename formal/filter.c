/* filter.c - proof for every input of small widths: the node filter never rejects a hit
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every ray origin of W bits, every child centre of FW bits, every direction of DIR bits: the
 * greatest child that the filter rejects, less its margin, is a sphere that the exact test misses;
 * and so is every smaller one, which lies in it. The model's own functions, sph_ray_setup(),
 * sph_filter() and sph_leaf_test(), in a profile of these widths.
 *
 * With UNIT below 16 the fraction of the unit vector has so many bits: UNIT = FW + 2 makes its
 * error weigh as much as at the full width, FW = 14. The formula of the filter then stands here;
 * at 16 bits it is compared with sph_filter().
 *
 * Exit: 0 all hold, 1 one does not.
 */
#include <stdio.h>
#include <stdlib.h>

#include "machine/layout.h"
#include "math/fx.h"
#include "trace/filter.h"
#include "prim/sphere.h"
#include "trace/setup.h"

#ifndef W
#define W 4
#define FW 3
#define DIR 4
#define UNIT 16
#endif
enum { K = W - FW, BITS = 9, PAIRS = 1 << (W + 3) };

static const struct sph_profile profile = {.name = "small", .w = W, .wd = BITS, .fw = FW};

/* One axis: centre less origin as they are, and in filter units as the filter sees them. */
struct pair {
    int32_t exact, seen;
};
static struct pair pairs[PAIRS];
static int n_pairs;

/* All pairs that some origin and some centre make. */
static void make_pairs(void) {
    for (int64_t o = -(1 << (W - 1)); o < 1 << (W - 1); o++) {
        struct sph_ray ray = {.org = {o, o, o}, .dir = {1, 0, 0}, .kind = SPH_PRIMARY};
        sph_ray_setup(&profile, &ray);
        for (int32_t c = -(1 << (FW - 1)); c < 1 << (FW - 1); c++) {
            struct pair p = {(int32_t)(c * (1 << K) - o), c - ray.forg[0]};
            int i = 0;
            while (i < n_pairs && (pairs[i].exact != p.exact || pairs[i].seen != p.seen))
                i++;
            if (i == n_pairs) pairs[n_pairs++] = p;
        }
    }
}

/* u with UNIT bits of fraction; at 16 bits what sph_unit() makes. */
static void unit_of(const struct sph_ray *ray, int64_t u[3]) {
    for (int i = 0; i < 3; i++)
        u[i] = sph_round(((int64_t)((uint64_t)ray->dir[i] << ray->unit.h)) * ray->unit.y,
                         BITS + 16 - UNIT);
}

/* sph_across() of UNIT bits: p and q of UNIT + 1, shorter than 1 by as much of their last bits. */
static struct sph_across across_of(const int64_t u[3]) {
    int64_t mag[3] = {llabs(u[0]), llabs(u[1]), llabs(u[2])};
    int m = mag[0] <= mag[1] && mag[0] <= mag[2] ? 0 : mag[1] <= mag[2] ? 1 : 2;
    struct sph_across r = {.axis_a = m == 0 ? 1 : 0, .axis_b = m == 2 ? 1 : 2};
    int64_t a = u[r.axis_a], b = u[r.axis_b];
    uint64_t square = (uint64_t)(mag[m] * mag[m]) << (32 - 2 * UNIT);
    int64_t scale = sph_rsqrt((uint32_t)~square >> 14) - (SPH_ACROSS_SHORT << (16 - UNIT));
    r.p_a = (int32_t)sph_round(scale * b, 15);
    r.p_b = (int32_t)sph_round(scale * a, 15);
    r.q[r.axis_a] = (int32_t)sph_round(u[m] * r.p_b, UNIT);
    r.q[r.axis_b] = (int32_t)sph_round(u[m] * r.p_a, UNIT);
    r.q[m] = (int32_t)sph_round(~(a * r.p_b + b * r.p_a), UNIT);
    return r;
}

/* sph_filter() with these axes: the squared distance of units 2^-FILTER_FRACTION, cut as there. */
static int64_t cut(int64_t x) {
    x >>= UNIT + 1 - SPH_FILTER_FRACTION;
    return x < 0 ? ~x : x;
}
static int64_t distance(const int64_t oc[3], const struct sph_across *a) {
    int64_t p = cut(oc[a->axis_a] * a->p_a - oc[a->axis_b] * a->p_b);
    int64_t q = cut(oc[0] * a->q[0] + oc[1] * a->q[1] + oc[2] * a->q[2]);
    return p * p + q * q;
}

static uint64_t tests, hits_1; /* hits_1: would be lost with a margin of 1 */

static int fail(const char *what, const struct sph_ray *ray, const int64_t exact[3], int64_t rad) {
    printf("fails: %s: dir %d %d %d, ctr - org %d %d %d, radius %d\n", what, (int)ray->dir[0],
           (int)ray->dir[1], (int)ray->dir[2], (int)exact[0], (int)exact[1], (int)exact[2],
           (int)rad);
    return 1;
}

/* Does the ray hit the sphere around `exact` whose radius is `rad` filter units? */
static int hits(const struct sph_ray *ray, const int64_t exact[3], int64_t rad) {
    struct sph_leaf leaf = {{exact[0], exact[1], exact[2]}, rad * (1 << K), 1};
    return rad > 0 && sph_leaf_test(ray, &leaf).hit;
}

/* One direction, every origin and centre. */
static int check_dir(struct sph_ray *ray, const uint8_t *root) {
    int64_t u[3];
    unit_of(ray, u);
    const struct sph_across across = across_of(u);
    if (UNIT == 16 && (u[0] != ray->unit.u[0] || u[1] != ray->unit.u[1] || u[2] != ray->unit.u[2]))
        return fail("another unit vector", ray, u, 0);
    for (int i = 0; i < n_pairs; i++)
        for (int j = 0; j < n_pairs; j++)
            for (int k = 0; k < n_pairs; k++) {
                int64_t exact[3] = {pairs[i].exact, pairs[j].exact, pairs[k].exact};
                int64_t oc[3] = {pairs[i].seen, pairs[j].seen, pairs[k].seen};
                int64_t depth = ray->negative ? -oc[ray->axis] : oc[ray->axis];
                int64_t rejected = root[distance(oc, &across)] - 1; /* the greatest */
                if (rejected < -depth - 1) rejected = -depth - 1;
                if (UNIT == 16) {
                    struct sph_child child = {{(int32_t)oc[0], (int32_t)oc[1], (int32_t)oc[2]},
                                              (int32_t)rejected + 1};
                    int32_t near;
                    ray->forg[0] = ray->forg[1] = ray->forg[2] = 0;
                    if (!sph_filter(ray, &child, ray->depth_max, &near))
                        return fail("the filter rejects more", ray, oc, child.rad);
                }
                tests++;
                if (hits(ray, exact, rejected - SPH_FILTER_MARGIN))
                    return fail("rejected, but hit", ray, exact, rejected - SPH_FILTER_MARGIN);
                hits_1 += (uint64_t)hits(ray, exact, rejected - SPH_FILTER_MARGIN + 1);
            }
    return 0;
}

int main(void) {
    /* least radius that is not below a squared distance */
    const size_t one = (size_t)1 << (2 * SPH_FILTER_FRACTION);
    size_t most = one << (2 * FW + 4); /* 12 * 2^(2FW) and the roundings */
    uint8_t *root = malloc(most);
    if (!root) return 2;
    for (size_t d = 0, r = 0; d < most; root[d++] = (uint8_t)r)
        while (one * r * r < d)
            r++;
    make_pairs();
    for (int64_t x = -(1 << (DIR - 1)); x < 1 << (DIR - 1); x++)
        for (int64_t y = -(1 << (DIR - 1)); y < 1 << (DIR - 1); y++)
            for (int64_t z = -(1 << (DIR - 1)); z < 1 << (DIR - 1); z++) {
                struct sph_ray ray = {
                    .dir = {x, y, z}, .kind = SPH_PRIMARY, .inside = 1, .skip = {SPH_ID_NONE, 0}};
                if (!x && !y && !z) continue;
                sph_ray_setup(&profile, &ray);
                if (check_dir(&ray, root)) return 1;
            }
    free(root);
    printf("%d pairs an axis, %llu cases; with a margin of one less %llu hits would be lost\n",
           n_pairs, (unsigned long long)tests, (unsigned long long)hits_1);
    return 0;
}
