/* packet_rays.h - the rays of a packet, and the planes around them; see packet_walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef PACKET_RAYS_H
#define PACKET_RAYS_H

#include <stddef.h>
#include <stdint.h>

#include "fast/lanes.h"
#include "fast/packets.h"
#include "machine/layout.h"

/* ---- planes around the rays of a packet ---- */

/* Farther from the middle of the grid than any sphere reaches, in filter units of FW <= 14 bits:
 * half the grid and the greatest radius of a node. */
enum { SPH_SHAFT_FAR = 25000 };

/* A sphere of a node lies outside, with its radius r, if of its pairs of words, as the node has
 * them, xy . (x, y) + zr . (z, r) > bound; each for four children. */
struct sph_shaft_plane {
    four xy, zr, bound;
};

/* s is the way along an axis from a plane behind all rays, in filter units, sign * c[axis] - start;
 * no point of a ray has s < 0 or s > end. u is one of the other axes, or minus it: of each point
 * u - slope * s <= bound, with a slope and a bound for each of the four. */
enum { SPH_SHAFT_END, SPH_SHAFT_BEGIN, SPH_SHAFT_SIDES, SPH_SHAFT_PLANES = 6 };

struct sph_shaft {
    struct sph_shaft_plane plane[SPH_SHAFT_PLANES];
    int axis;
    int32_t start;
};

enum { VECTORS = SPH_PACKET / LANES };

struct packet {
    _Alignas(64) double a[SPH_PACKET];
    /* nearest hits: the key is b - floor(root); the leaf record, by leaf_word() */
    double b[SPH_PACKET];
    double root[SPH_PACKET];
    int64_t leaf[SPH_PACKET];
    double own[SPH_PACKET]; /* of shadow rays: the id of where they start */
    uint64_t live;          /* rays that look for something */
    uint64_t found;         /* rays that have hit */
    uint64_t exact;         /* b is the key, made by integers */
    const struct sph_fast *f;
    const struct sph_bundle *rays; /* its last vector is full */
    struct sph_bundle some;        /* rays, if they are not those of the caller */
    int n, vectors;
    struct sph_shaft shaft;
};

/* The number of a leaf record above its id; the second word of a hit on it. */
static inline int64_t leaf_word(uint32_t number, uint32_t id) {
    return (int64_t)((uint64_t)number << 32 | id);
}

static inline real_mask hit_word(real_mask leaf) {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return leaf << 32;
#else
    return leaf & 0xffffffff;
#endif
}

_Static_assert(sizeof(struct sph_hit) == 16 && offsetof(struct sph_hit, id) == 8, "two words");

static inline real load_vector(const double *at, int v) {
    return *(const real *)(const void *)(at + v * LANES);
}

static inline void store_vector(double *at, int v, real x) {
    *(real *)(void *)(at + v * LANES) = x;
}

static inline real_mask *leaves_at(struct packet *p, int v) {
    return (real_mask *)(void *)(p->leaf + v * LANES);
}

static inline real org(const struct packet *p, int k, int v) {
    return reals(p->rays->org[k] + v * LANES);
}

static inline real dir(const struct packet *p, int k, int v) {
    return reals(p->rays->dir[k] + v * LANES);
}

/* The packet is of n rays of a bundle, those of numbers `lanes` or, if that is NULL, all; what
 * fills the last vector is as the first of them. */
static void load(struct packet *p, const struct sph_bundle *rays, const int *lanes, int n) {
    struct sph_bundle *to = &p->some;
    p->n = n;
    p->vectors = (n + LANES - 1) / LANES;
    p->live = ~0ull >> (SPH_PACKET - n);
    p->found = p->exact = 0;
    p->rays = rays;
    if (!lanes && n == p->vectors * LANES) return;
    p->rays = to;
    to->n = n;
    to->kind = rays->kind;
    to->inside = rays->inside;
    for (int i = 0; i < p->vectors * LANES; i++) {
        int from = i >= n ? lanes ? lanes[0] : 0 : lanes ? lanes[i] : i;
        for (int k = 0; k < 3; k++) {
            to->org[k][i] = rays->org[k][from];
            to->dir[k][i] = rays->dir[k][from];
        }
        if (rays->kind == SPH_SHADOW) to->skip[i] = rays->skip[from];
    }
}

/* The plane of a side, with slope and bound in filter units; 0 if the slope is too great. */
static inline int side_of(struct sph_shaft *h, int side, int axis, int up, int sign, double slope,
                          double bound) {
    struct sph_shaft_plane *plane = &h->plane[SPH_SHAFT_SIDES + side];
    if (!(fabs(slope) < 2.01) || !(fabs(bound) < 3 * SPH_SHAFT_FAR)) return 0;
    int one = fabs(slope) < 1.7 ? 1 << 14 : 1 << 13; /* all below fit 16 bits */
    int m = (int)floor(slope * one) + 2;
    int length = (int)sqrt((double)one * one + (double)m * m) + 2; /* of the plane's normal */
    int64_t limit =
        (int64_t)floor(bound * one) + 3 - (int64_t)m * h->start - length * SPH_FILTER_MARGIN;
    int c[3] = {0, 0, 0};
    c[axis] = up ? one : -one;
    c[h->axis] = sign < 0 ? m : -m;
    limit = limit > INT32_MAX ? INT32_MAX : limit < INT32_MIN ? INT32_MIN : limit;
    *plane =
        (struct sph_shaft_plane){pair(c[0], c[1]), pair(c[2], -length), (four){0} + (int32_t)limit};
    return 1;
}

/* The planes across the axis: s + r < 0, and s - r > end. */
static void ends_of(struct sph_shaft *h, int sign, int32_t end) {
    int c[3] = {0, 0, 0};
    c[h->axis] = sign;
    h->plane[SPH_SHAFT_BEGIN] = (struct sph_shaft_plane){pair(-c[0], -c[1]), pair(-c[2], -1),
                                                         (four){0} - h->start - SPH_FILTER_MARGIN};
    h->plane[SPH_SHAFT_END] = (struct sph_shaft_plane){
        pair(c[0], c[1]), pair(c[2], -1), (four){0} + (end + h->start - SPH_FILTER_MARGIN)};
}

/* Whether the rays have a shaft, along an axis of which none goes more than twice as far another
 * way; back: it begins at their ends, and ends where they start. Else they start together. Makes
 * their squares too. */
static int shaft_of(struct packet *p, int axis, int back) {
    const struct sph_profile *w = sph_machine_profile(p->f->m);
    struct sph_shaft *h = &p->shaft;
    const int other[2] = {(axis + 1) % 3, (axis + 2) % 3};
    double unit = 1.0 / (1 << (w->w - w->fw)), slope[4], bound[4];
    int sign = (p->rays->dir[axis][0] < 0) != back ? -1 : 1;
    double ahead = back ? -sign : sign;
    real rate[2][VECTORS], from[VECTORS], far = (real){0} + 0x1p60;
    real high[2] = {-far, -far}, low[2] = {far, far}, first = -far, last = -far;
    real_mask wrong = {0};
    for (int v = 0; v < p->vectors; v++) {
        real along = dir(p, axis, v) * ahead, x = dir(p, other[0], v), y = dir(p, other[1], v);
        real per = (back ? -1 : 1) / along, m[2] = {x * per, y * per};
        store_vector(p->a, v, along * along + x * x + y * y);
        wrong |= along <= 0;
        for (int i = 0; i < 2; i++) {
            high[i] = greater(high[i], m[i]);
            low[i] = lesser(low[i], m[i]);
        }
        if (!back) continue;
        from[v] = org(p, axis, v) * sign;
        rate[0][v] = m[0];
        rate[1][v] = m[1];
        first = greater(first, along - from[v]);
        last = greater(last, from[v]);
    }
    if (bits(wrong)) return 0;
    for (int i = 0; i < 4; i++)
        slope[i] = greatest(i & 1 ? -low[i >> 1] : high[i >> 1]);
    double start = p->rays->org[axis][0] * sign * unit, ends = start;
    if (back) {
        start = -greatest(first) * unit;
        ends = greatest(last) * unit;
        high[0] = high[1] = -far;
        low[0] = low[1] = far;
    }
    start = floor(start < -SPH_SHAFT_FAR ? -SPH_SHAFT_FAR : start);
    for (int v = 0; v < p->vectors && back; v++) {
        real s = from[v] * unit - start;
        for (int i = 0; i < 2; i++) {
            real c = org(p, other[i], v) * unit - rate[i][v] * s;
            high[i] = greater(high[i], c);
            low[i] = lesser(low[i], c);
        }
    }
    for (int i = 0; i < 4; i++) {
        double c = p->rays->org[other[i >> 1]][0] * unit;
        bound[i] = back ? greatest(i & 1 ? -low[i >> 1] : high[i >> 1])
                        : (i & 1 ? -c : c) + (ends - start) * slope[i ^ 1];
    }
    h->axis = axis;
    h->start = (int32_t)start;
    ends_of(h, sign, back ? (int32_t)(ends - start) + 2 : 4 * SPH_SHAFT_FAR);
    for (int i = 0; i < 4; i++)
        if (!side_of(h, i, other[i >> 1], !(i & 1), sign, slope[i], bound[i])) return 0;
    return 1;
}

#endif
