/* packet_rays.h - the rays of a packet as doubles, and the planes around them; see packet_walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/lanes.h"
#include "fast/packets.h"

enum { VECTORS = SPH_PACKET / LANES };

struct packet {
    _Alignas(64) double org[3][SPH_PACKET];
    double dir[3][SPH_PACKET];
    double a[SPH_PACKET];
    /* nearest hits: the key is b - floor(root); the number of the leaf record */
    double b[SPH_PACKET];
    double root[SPH_PACKET];
    double leaf[SPH_PACKET];
    double own[SPH_PACKET]; /* of shadow rays: the id of where they start, -1: none */
    uint64_t live;          /* rays that look for something */
    uint64_t found;         /* rays that have hit */
    uint64_t exact;         /* b is the key, made by integers */
    const struct sph_fast *f;
    const struct sph_bundle *rays;
    int n, vectors;
    struct sph_shaft shaft;
};

static inline real get(const double *at, int v) {
    return *(const real *)(const void *)(at + v * LANES);
}

static inline void put(double *at, int v, real x) {
    *(real *)(void *)(at + v * LANES) = x;
}

/* Doubles of n rays, those of numbers `lanes` or, if that is NULL, the first; what fills the last
 * vector is as the first of them. */
static void load(struct packet *p, const int *lanes, int n) {
    const struct sph_bundle *r = p->rays;
    p->n = n;
    p->vectors = (n + LANES - 1) / LANES;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < n && lanes; i++) {
            p->org[k][i] = r->org[k][lanes[i]];
            p->dir[k][i] = r->dir[k][lanes[i]];
        }
        for (int i = 0; i < n && !lanes; i++) {
            p->org[k][i] = r->org[k][i];
            p->dir[k][i] = r->dir[k][i];
        }
        for (int i = n; i < p->vectors * LANES; i++) {
            p->org[k][i] = p->org[k][0];
            p->dir[k][i] = p->dir[k][0];
        }
    }
    for (int v = 0; v < p->vectors; v++) {
        real x = get(p->dir[0], v), y = get(p->dir[1], v), z = get(p->dir[2], v);
        put(p->a, v, x * x + y * y + z * z);
    }
    p->live = ~0ull >> (SPH_PACKET - n);
    p->found = p->exact = 0;
}

/* Bounds of rays for one side of a shaft: of slopes along another axis, and of where they are at
 * the shaft's start. */
static void side_of(const struct packet *p, int other, double unit, const real *s, const real *back,
                    double slope[2], double bound[2]) {
    real most = {0}, least = {0}, high = {0}, low = {0};
    for (int v = 0; v < p->vectors; v++) {
        real m = get(p->dir[other], v) * back[v], c = get(p->org[other], v) * unit - m * s[v];
        most = v ? greater(most, m) : m;
        least = v ? greater(least, -m) : -m;
        high = v ? greater(high, c) : c;
        low = v ? greater(low, -c) : -c;
    }
    slope[0] = greatest(most);
    slope[1] = greatest(least);
    bound[0] = greatest(high);
    bound[1] = greatest(low);
}

/* Whether the rays have a shaft, along an axis of which none goes more than twice as far another
 * way; back: it begins at their ends, and ends where they start. */
static int shaft_of(struct packet *p, int axis, int back) {
    const struct sph_profile *w = sph_machine_profile(p->f->m);
    struct sph_shaft *h = &p->shaft;
    double unit = 1.0 / (1 << (w->w - w->fw)), slope[2], bound[2];
    double sign = (p->dir[axis][0] < 0) != back ? -1 : 1, ahead = back ? -sign : sign;
    real s[VECTORS], per[VECTORS], first = {0}, last = {0};
    unsigned wrong = 0;
    for (int v = 0; v < p->vectors; v++) {
        real along = get(p->dir[axis], v) * ahead, from = get(p->org[axis], v) * sign;
        real to = back ? along - from : 0 - from;
        first = v ? greater(first, to) : to;
        last = v ? greater(last, from) : from;
        wrong |= bits(along <= 0);
        s[v] = from * unit;
        per[v] = ahead * sign / along; /* rate of the other axes along this one */
    }
    if (wrong) return 0;
    double start = floor(-greatest(first) * unit);
    start = start < -SPH_SHAFT_FAR ? -SPH_SHAFT_FAR : start;
    for (int v = 0; v < p->vectors; v++)
        s[v] -= start;
    h->axis = axis;
    h->sign = sign < 0 ? -1 : 0;
    h->start = (int32_t)start;
    h->end = back ? (int32_t)(greatest(last) * unit - start) + 2 : 4 * SPH_SHAFT_FAR;
    for (int side = 0; side < 2; side++) {
        side_of(p, (axis + 1 + side) % 3, unit, s, per, slope, bound);
        for (int i = 0; i < 2; i++) {
            if (!(fabs(slope[i]) < 2.01) || !(fabs(bound[i]) < 3 * SPH_SHAFT_FAR)) return 0;
            struct sph_shaft_side *to = i ? &h->least[side] : &h->most[side];
            double m = (slope[i] * SPH_SHAFT_ONE + 2) / SPH_SHAFT_ONE;
            to->slope = (int32_t)floor(slope[i] * SPH_SHAFT_ONE) + 2;
            to->bound = (int32_t)floor(bound[i] * SPH_SHAFT_ONE) + 3;
            to->length = (int32_t)(sqrt(1 + m * m) * SPH_SHAFT_ONE) + 2;
        }
    }
    return 1;
}
