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
#include "prim/leaf.h"

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

/* sph_filter() with UNIT bits of fraction: 16 |oc x u|^2, rounded as there. */
static int64_t distance(const int64_t oc[3], const int64_t u[3]) {
    int64_t x = sph_round(oc[1] * u[2] - oc[2] * u[1], UNIT - 2);
    int64_t y = sph_round(oc[2] * u[0] - oc[0] * u[2], UNIT - 2);
    int64_t z = sph_round(oc[0] * u[1] - oc[1] * u[0], UNIT - 2);
    return x * x + y * y + z * z;
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
    if (UNIT == 16 && (u[0] != ray->unit.u[0] || u[1] != ray->unit.u[1] || u[2] != ray->unit.u[2]))
        return fail("another unit vector", ray, u, 0);
    for (int i = 0; i < n_pairs; i++)
        for (int j = 0; j < n_pairs; j++)
            for (int k = 0; k < n_pairs; k++) {
                int64_t exact[3] = {pairs[i].exact, pairs[j].exact, pairs[k].exact};
                int64_t oc[3] = {pairs[i].seen, pairs[j].seen, pairs[k].seen};
                int64_t depth = ray->negative ? -oc[ray->axis] : oc[ray->axis];
                int64_t rejected = root[distance(oc, u)] - 1; /* the greatest */
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
    /* least radius whose square is not below 1/16 of a squared distance */
    size_t most = (size_t)256 << (2 * FW); /* 16 * 12 * 2^(2FW) and the roundings */
    uint8_t *root = malloc(most);
    if (!root) return 2;
    for (size_t d = 0, r = 0; d < most; root[d++] = (uint8_t)r)
        while (16 * r * r < d)
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
