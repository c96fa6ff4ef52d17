/* bound.c - spheres in filter units that hold spheres of the grid  RTL: rtl/build/rt_build_bound.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A centre is a point of filter units, half a unit rounded up. A radius is rounded up twice, to
 * grid units and to filter units, so that it is never too small.
 *
 * Around spheres of the grid the centre is the mean of two: the middle of their box, and the point
 * that is in the middle, as nearly as one can be, of their extents along the four diagonals of a
 * cube. A diagonal is not normalised: a radius is sqrt(3) times as long along it, or 7/4.
 */
#include "build/build_tree.h"
#include "math/arith.h"
#include "math/fx.h"

struct sph_bt_box sph_bt_nothing(void) {
    return (struct sph_bt_box){{INT64_MAX, INT64_MAX, INT64_MAX},
                               {INT64_MIN, INT64_MIN, INT64_MIN}};
}

void sph_bt_add(struct sph_bt_box *box, const int32_t ctr[3], int32_t rad, int k) {
    for (int i = 0; i < 3; i++) {
        int64_t lo = ((int64_t)ctr[i] - rad) * (1ll << k),
                hi = ((int64_t)ctr[i] + rad) * (1ll << k);
        if (lo < box->lo[i]) box->lo[i] = lo;
        if (hi > box->hi[i]) box->hi[i] = hi;
    }
}

enum { AXES = 3, ALONG = 7 };
static const int along[ALONG][3] = {{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, /* axes, then diagonals */
                                    {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

/* A coordinate of 2^shift parts of a filter unit to one in filter units of the grid. */
static int32_t to_unit(int64_t v, int shift, const struct sph_profile *p) {
    int64_t half = 1ll << (p->fw - 1), f = sph_round(v, shift);
    return (int32_t)(f > half - 1 ? half - 1 : f < -half ? -half : f);
}

/* The two ends of the extent of places first .. last, added. */
static int64_t ends(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t first,
                    uint32_t last, int way) {
    int64_t lo = INT64_MAX, hi = INT64_MIN;
    for (uint32_t at = first; at <= last; at++) {
        const struct sph_bt_leaf *leaf = &leaves[order[at]];
        int64_t rad = leaf->rad, d = 0;
        for (int i = 0; i < 3; i++)
            d += along[way][i] * (int64_t)leaf->ctr[i];
        if (way >= AXES) rad += (rad >> 1) + (rad >> 2);
        if (d - rad < lo) lo = d - rad;
        if (d + rad > hi) hi = d + rad;
    }
    return lo + hi;
}

/* From a point in filter units to one in grid units, rounded up to these. */
static int64_t distance(const int32_t from[3], const int64_t to[3], int k) {
    sph_u128 sum = 0;
    for (int i = 0; i < 3; i++) {
        int64_t d = from[i] * (1ll << k) - to[i];
        sum += (sph_u128)((__int128)d * d);
    }
    int inexact;
    int64_t root = (int64_t)sph_isqrt(sum, &inexact);
    return root + inexact;
}

void sph_bt_enclose(const struct sph_bt_leaf *leaves, const uint32_t *order, uint32_t first,
                    uint32_t last, const struct sph_profile *p, struct sph_bt_ball *ball) {
    int k = p->w - p->fw, unused;
    int64_t half = 1ll << (p->fw - 1), most = 0;
    int64_t sum[ALONG];
    for (int way = 0; way < ALONG; way++)
        sum[way] = ends(leaves, order, first, last, way);
    for (int i = 0; i < 3; i++) {
        int64_t sixteen = 4 * sum[i]; /* times the centre */
        for (int way = AXES; way < ALONG; way++)
            sixteen += along[way][i] * sum[way];
        ball->ctr[i] = to_unit(sixteen, k + 4, p);
    }
    for (uint32_t at = first; at <= last; at++) {
        const struct sph_bt_leaf *leaf = &leaves[order[at]];
        int64_t to[3] = {leaf->ctr[0], leaf->ctr[1], leaf->ctr[2]};
        int64_t reach = distance(ball->ctr, to, k) + leaf->rad;
        if (reach > most) most = reach;
    }
    int64_t r = -(-most >> k), whole = (int64_t)sph_isqrt((uint64_t)(3 * half * half), &unused) + 1;
    for (int i = 0; i < 3 && r > whole; i++)
        ball->ctr[i] = 0;
    ball->rad = (int32_t)(r > whole ? whole : r);
}

void sph_bt_on_box(const struct sph_bt_box *box, const struct sph_profile *p,
                   struct sph_bt_ball *ball) {
    int k = p->w - p->fw;
    int64_t corner[3];
    for (int i = 0; i < 3; i++) {
        ball->ctr[i] = to_unit((box->lo[i] + box->hi[i]) >> 1, k, p);
        int64_t c = ball->ctr[i] * (1ll << k);
        corner[i] = c - box->lo[i] > box->hi[i] - c ? box->lo[i] : box->hi[i];
    }
    ball->rad = (int32_t) - (-distance(ball->ctr, corner, k) >> k);
}
