/* overlap.c - search for two spheres that are near each other; see near.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres in the order of a space-filling curve (bits of x, y, z in turn) are the leaves of a
 * complete binary tree of boxes, LEAF to a box. Boxes farther apart than the bound along an axis
 * are passed over; spheres that are left are compared exactly. Time grows like n log n where
 * spheres keep apart, and where they do not the search ends with the first pair.
 */
#include <stdlib.h>

#include "builder/grid/near.h"
#include "builder/tree/radix.h"

enum { LEAF = 4, CODE_BITS = 21 };

struct box {
    int32_t lo[3], hi[3]; /* lo > hi: empty */
};

struct search {
    const struct sph_ball *balls;
    const struct sph_profile *profile;
    const uint32_t *order;
    struct box *boxes; /* 1: root; children of i: 2i and 2i+1; the last `leaves` are the leaves */
    uint32_t n, leaves;
    int64_t reach; /* grid units, up */
    uint32_t *pair;
};

/* The low CODE_BITS of v, two zero bits between any two. */
static uint64_t spread(uint64_t v) {
    v &= (1ull << CODE_BITS) - 1;
    v = (v | v << 32) & 0x1f00000000ffffu;
    v = (v | v << 16) & 0x1f0000ff0000ffu;
    v = (v | v << 8) & 0x100f00f00f00f00fu;
    v = (v | v << 4) & 0x10c30c30c30c30c3u;
    return (v | v << 2) & 0x1249249249249249u;
}

/* Indices in the order of the curve, of equal places by number; malloc, NULL if memory is out. */
static uint32_t *curve(const struct sph_ball *balls, uint32_t n, int w) {
    uint64_t *codes = malloc(n * sizeof *codes), *keys = malloc(2ull * n * sizeof *keys);
    uint32_t *order = malloc(n * sizeof *order);
    for (uint32_t i = 0; codes && keys && i < n; i++) {
        codes[i] = 0;
        for (int axis = 0; axis < 3; axis++) {
            uint64_t v = (uint64_t)(balls[i].c[axis] + (1ll << (w - 1)));
            codes[i] |= spread(w > CODE_BITS ? v >> (w - CODE_BITS) : v) << axis;
        }
        keys[i] = codes[i] << 32 | i;
    }
    if (codes && keys && order) {
        uint64_t *low = sph_radix(keys, keys + n, n), *spare = low == keys ? keys + n : keys;
        for (uint32_t i = 0; i < n; i++)
            low[i] = codes[(uint32_t)low[i]] >> 32 << 32 | (uint32_t)low[i];
        const uint64_t *sorted = sph_radix(low, spare, n);
        for (uint32_t i = 0; i < n; i++)
            order[i] = (uint32_t)sorted[i];
    } else {
        free(order);
        order = NULL;
    }
    free(codes);
    free(keys);
    return order;
}

static void grow(struct box *box, const struct box *by) {
    for (int i = 0; i < 3; i++) {
        if (by->lo[i] < box->lo[i]) box->lo[i] = by->lo[i];
        if (by->hi[i] > box->hi[i]) box->hi[i] = by->hi[i];
    }
}

static void fill(struct search *s) {
    const struct box empty = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (uint32_t i = 1; i < 2 * s->leaves; i++)
        s->boxes[i] = empty;
    for (uint32_t i = 0; i < s->n; i++) {
        const struct sph_ball *b = &s->balls[s->order[i]];
        struct box box;
        for (int axis = 0; axis < 3; axis++)
            box.lo[axis] = b->c[axis] - b->r, box.hi[axis] = b->c[axis] + b->r;
        grow(&s->boxes[s->leaves + i / LEAF], &box);
    }
    for (uint32_t i = s->leaves - 1; i >= 1; i--) {
        s->boxes[i] = s->boxes[2 * i];
        grow(&s->boxes[i], &s->boxes[2 * i + 1]);
    }
}

/* Whether the spheres in two boxes are all farther apart than the bound; so if one is empty. */
static int apart(const struct search *s, uint32_t a, uint32_t b) {
    const struct box *p = &s->boxes[a], *q = &s->boxes[b];
    for (int i = 0; i < 3; i++)
        if ((int64_t)p->lo[i] - q->hi[i] > s->reach || (int64_t)q->lo[i] - p->hi[i] > s->reach)
            return 1;
    return 0;
}

/* Compares the spheres of two leaves, or of one with each other. */
static int leaves(const struct search *s, uint32_t a, uint32_t b) {
    uint32_t first = (a - s->leaves) * LEAF, second = (b - s->leaves) * LEAF;
    for (uint32_t i = first; i < first + LEAF && i < s->n; i++)
        for (uint32_t j = a == b ? i + 1 : second; j < second + LEAF && j < s->n; j++) {
            uint32_t p = s->order[i], q = s->order[j];
            if (sph_nearness(&s->balls[p], &s->balls[q], s->profile) == SPH_APART) continue;
            s->pair[0] = p < q ? p : q;
            s->pair[1] = p < q ? q : p;
            return 1;
        }
    return 0;
}

/* A sphere below box a against one below box b of the same level. */
static int between(const struct search *s, uint32_t a, uint32_t b) {
    if (apart(s, a, b)) return 0;
    if (a >= s->leaves) return leaves(s, a, b);
    return between(s, 2 * a, 2 * b) || between(s, 2 * a, 2 * b + 1) ||
           between(s, 2 * a + 1, 2 * b) || between(s, 2 * a + 1, 2 * b + 1);
}

/* Two spheres below one box. */
static int within(const struct search *s, uint32_t a) {
    if (a >= s->leaves) return leaves(s, a, a);
    return within(s, 2 * a) || within(s, 2 * a + 1) || between(s, 2 * a, 2 * a + 1);
}

int sph_near_pair(const struct sph_ball *balls, uint32_t n, const struct sph_profile *p,
                  uint32_t pair[2], struct sph_error *err) {
    if (n < 2) return 0;
    int bits = sph_error_bits(p);
    struct search s = {.balls = balls, .profile = p, .n = n, .leaves = 1, .pair = pair};
    s.reach = (sph_point_error(p) + (1ll << bits) - 1) >> bits;
    while ((uint64_t)s.leaves * LEAF < n)
        s.leaves *= 2;
    uint32_t *order = curve(balls, n, p->w);
    s.order = order;
    s.boxes = malloc(2 * (size_t)s.leaves * sizeof *s.boxes);
    int result;
    if (order && s.boxes) {
        fill(&s);
        result = within(&s, 1);
    } else {
        result = sph_fail(err, "out of memory to compare %u spheres", n);
    }
    free(order);
    free(s.boxes);
    return result;
}
