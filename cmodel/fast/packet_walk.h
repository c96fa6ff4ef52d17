/* packet_walk.h - the walk of packets, for processors of any kind; see packet.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * packet_plain.c and packet_avx2.c compile it. A double holds each integer here exactly but a
 * discriminant, which is off by less than 2^-50 of b * b where it is not far below 0: what lies
 * nearer to a border than that is left to integers.
 */
#include <stdlib.h>

#include "fast/packet_rays.h"
#include "machine/layout.h"

enum { MOST_WAITING = 4 * SPH_STACK_DEPTH };

/* Shadow rays that need more nodes than PATIENCE together are taken PART at a time. */
enum { PART = 16, PATIENCE = 64 };

#define DOUBT 0x1p-49 /* of b * b, of a discriminant */

/* A node to visit, and where along the shaft it begins. */
struct waiting {
    int32_t near;
    uint32_t node;
};

static inline four beyond(const struct sph_shaft_side *side, four c, four s, four r) {
    return (c * SPH_SHAFT_ONE - s * side->slope) > (r * side->length + side->bound);
}

/* Puts the inner children that the shaft meets on the stack, the nearest last; returns the leaves
 * that it meets. */
static unsigned meets(const struct sph_shaft *h, const struct sph_fast_node *n,
                      struct waiting *stack, int *sp) {
    four xy = pairs(n->xy), zr = pairs(n->zr), r = (zr >> 16) - SPH_FILTER_MARGIN;
    four c[3] = {xy << 16 >> 16, xy >> 16, zr << 16 >> 16};
    four along = c[h->axis], u = c[(h->axis + 1) % 3], w = c[(h->axis + 2) % 3];
    four s = (along ^ h->sign) - h->sign - h->start, near = s - r;
    four missed = beyond(&h->most[0], u, s, r) | beyond(&h->most[1], w, s, r) |
                  beyond(&h->least[0], -u, s, r) | beyond(&h->least[1], -w, s, r) | ((s + r) < 0) |
                  (near > h->end);
    unsigned met = ~signs(missed) & n->valid;
    int from = *sp;
    for (unsigned i = met & ((1u << n->n_inner) - 1); i; i &= i - 1) {
        int child = __builtin_ctz(i), at = (*sp)++;
        struct waiting w_new = {near[child], n->inner + (uint32_t)child};
        for (; at > from && stack[at - 1].near < w_new.near; at--)
            stack[at] = stack[at - 1];
        stack[at] = w_new;
    }
    return met >> n->n_inner;
}

/* Ray i against a leaf record, by integers; the nearer of two hits stays. */
static void decide(struct packet *p, int i, uint32_t leaf) {
    struct sph_hit hit =
        sph_packet_exact(p->f, p->rays, i, p->found >> i & 1 ? (int64_t)p->leaf[i] : -1, &leaf);
    if (!hit.key) return;
    p->found |= 1ull << i;
    p->exact |= 1ull << i;
    p->leaf[i] = leaf;
    p->b[i] = (double)hit.key;
    p->root[i] = 0;
}

/* A sphere against primary rays; 1 if a hit is nearer than before. */
static int nearer(struct packet *p, uint32_t number) {
    const struct sph_fast_leaf *leaf = &p->f->leaves[number];
    int64_t oc[3], k = (int64_t)leaf->rad * leaf->rad;
    for (int i = 0; i < 3; i++) {
        oc[i] = leaf->ctr[i] - p->rays->org[i][0];
        k -= oc[i] * oc[i];
    }
    if (k >= 0) {
        for (int i = 0; i < p->n && p->rays->inside; i++)
            decide(p, i, number);
        return p->rays->inside;
    }
    double x = (double)oc[0], y = (double)oc[1], z = (double)oc[2], less = (double)k;
    uint64_t changed = 0;
    for (int v = 0; v < p->vectors; v++) {
        real b = get(p->dir[0], v) * x + get(p->dir[1], v) * y + get(p->dir[2], v) * z;
        real bb = b * b, disc = bb + get(p->a, v) * less, doubt = bb * DOUBT;
        unsigned hit = bits((b > 0) & (disc > -doubt));
        if (!hit) continue;
        real root = roots(disc), key = b - root, best = get(p->b, v) - get(p->root, v);
        real margin = b * 0x1p-22 + 4;
        real_mask sure = disc > doubt, first = sure & (b > 0) & (key < best - margin);
        unsigned take = bits(first), leave = bits(sure & (key > best + margin));
        put(p->b, v, pick(first, b, get(p->b, v)));
        put(p->root, v, pick(first, root, get(p->root, v)));
        put(p->leaf, v, pick(first, (real){0} + number, get(p->leaf, v)));
        changed |= (uint64_t)take << v * LANES;
        p->exact &= ~((uint64_t)take << v * LANES);
        for (unsigned more = hit & ~take & ~leave; more; more &= more - 1) {
            int i = v * LANES + __builtin_ctz(more);
            if (i < p->n) decide(p, i, number), changed |= 1ull << i;
        }
    }
    p->found |= changed & p->live;
    return changed != 0;
}

/* No ray is deeper than this at its hit. */
static int32_t deepest(const struct packet *p) {
    const struct sph_shaft *h = &p->shaft;
    real most = {0};
    for (int v = 0; v < p->vectors; v++) {
        real along = get(p->dir[h->axis], v), key = get(p->b, v) - get(p->root, v);
        most = greater(most, greater(along, -along) * key / get(p->a, v));
    }
    const struct sph_profile *w = sph_machine_profile(p->f->m);
    double s = greatest(most) / (double)(1 << (w->w - w->fw)) + 4; /* it starts less than 1 ahead */
    return s < SPH_SHAFT_FAR ? (int32_t)s : SPH_SHAFT_FAR;
}

static void nearest(struct packet *p) {
    struct waiting stack[MOST_WAITING];
    int sp = 1;
    stack[0] = (struct waiting){0, p->f->root};
    while (sp) {
        struct waiting at = stack[--sp];
        if (at.near > p->shaft.end) continue;
        const struct sph_fast_node *n = &p->f->nodes[at.node];
        int changed = 0;
        for (unsigned leaves = meets(&p->shaft, n, stack, &sp); leaves; leaves &= leaves - 1)
            changed |= nearer(p, n->leaf + (unsigned)__builtin_ctz(leaves));
        if (changed && p->found == p->live) p->shaft.end = deepest(p);
    }
}

/* Keys of what was found; what a double cannot tell, integers do. */
static void keys_of(struct packet *p, struct sph_hit *hits) {
    for (int i = 0; i < p->n; i++)
        hits[i] = (struct sph_hit){0, SPH_ID_NONE, 0};
    for (int v = 0; v < p->vectors; v++) {
        unsigned some = (unsigned)(p->found >> v * LANES) & ((1u << LANES) - 1);
        if (!some) continue;
        real b = get(p->b, v), root = get(p->root, v);
        real whole = (root + 0x1p52) - 0x1p52, off = root - whole;
        real error = b * b * 0x1p-50 / pick(root > 0, root, b) + root * 0x1p-51;
        unsigned doubt = bits((off <= error) & (off >= -error));
        real key = b - (whole + pick(whole > root, (real){0} - 1, (real){0}));
        doubt |= (unsigned)(p->exact >> v * LANES);
        for (; some; some &= some - 1) {
            int k = __builtin_ctz(some), i = v * LANES + k;
            uint32_t leaf = (uint32_t)p->leaf[i];
            if (doubt >> k & 1)
                hits[i] = sph_packet_exact(p->f, p->rays, i, -1, &leaf);
            else
                hits[i] = (struct sph_hit){(uint64_t)key[k], p->f->leaves[leaf].id, 0};
        }
    }
}

/* A sphere against shadow rays, by the rule of sph_leaf_test(). */
static void hides(struct packet *p, const int *lanes, uint32_t number) {
    const struct sph_fast_leaf *leaf = &p->f->leaves[number];
    double x = leaf->ctr[0], y = leaf->ctr[1], z = leaf->ctr[2];
    double square = (double)leaf->rad * leaf->rad, id = leaf->id;
    for (int v = 0; v < p->vectors; v++) {
        real ox = x - get(p->org[0], v), oy = y - get(p->org[1], v), oz = z - get(p->org[2], v);
        real k = square - (ox * ox + oy * oy + oz * oz), a = get(p->a, v);
        real b = ox * get(p->dir[0], v) + oy * get(p->dir[1], v) + oz * get(p->dir[2], v);
        real bb = b * b, disc = bb + a * k, doubt = bb * DOUBT;
        real_mask other = get(p->own, v) != id;
        real_mask meets_it =
            other & (k < 0) & (b > 0) & (disc > -doubt) & ((b < a) | (k + 2 * b - a > 0));
        unsigned hit = bits(meets_it & (disc > doubt)), slow = bits(meets_it) & ~hit;
        if (p->rays->inside) slow |= bits(other & (k >= 0));
        p->live &= ~((uint64_t)hit << v * LANES);
        for (slow &= (unsigned)(p->live >> v * LANES) & ((1u << LANES) - 1); slow;
             slow &= slow - 1) {
            int i = v * LANES + __builtin_ctz(slow);
            uint32_t same = number;
            if (sph_packet_exact(p->f, p->rays, lanes[i], -1, &same).key) p->live &= ~(1ull << i);
        }
    }
}

/* Of the rays that are left those that go as the first of them does, mostly along one axis; *axis.
 */
static uint64_t alike(const struct sph_bundle *r, uint64_t left, int *axis) {
    int first = __builtin_ctzll(left), most = 0;
    int32_t unlike[SPH_PACKET];
    for (int k = 1; k < 3; k++)
        if (abs(r->dir[k][first]) > abs(r->dir[most][first])) most = k;
    const int32_t *along = r->dir[most], *u = r->dir[(most + 1) % 3], *w = r->dir[(most + 2) % 3];
    int32_t sign = along[first] < 0 ? -2 : 2;
    uint64_t some = 0;
    int32_t any = 0;
    for (int i = 0; i < r->n; i++) {
        int32_t twice = along[i] * sign;
        unlike[i] = (twice < u[i]) | (twice < -u[i]) | (twice < w[i]) | (twice < -w[i]);
        any |= unlike[i];
    }
    *axis = most;
    if (!any) return left;
    for (int i = 0; i < r->n; i++)
        some |= (uint64_t)!unlike[i] << i;
    return some & left;
}

/* Through the tree; 0 if more nodes are met than a packet of so many rays is worth. */
static int hidden(struct packet *p, const int *lanes) {
    struct waiting stack[MOST_WAITING];
    int sp = 1, visits = 0, most = p->n > PART ? PATIENCE : INT32_MAX;
    stack[0] = (struct waiting){0, p->f->root};
    while (sp && p->live) {
        if (visits++ == most) return 0;
        const struct sph_fast_node *n = &p->f->nodes[stack[--sp].node];
        unsigned leaves = meets(&p->shaft, n, stack, &sp);
        for (; leaves && p->live; leaves &= leaves - 1)
            hides(p, lanes, n->leaf + (unsigned)__builtin_ctz(leaves));
    }
    return 1;
}

static void packet_nearest(const struct sph_fast *f, const struct sph_bundle *rays,
                           struct sph_hit *hits) {
    struct packet p;
    int axis = 0;
    p.f = f;
    p.rays = rays;
    for (int k = 1; k < 3; k++)
        if (abs(rays->dir[k][0]) > abs(rays->dir[axis][0])) axis = k;
    load(&p, NULL, rays->n);
    if (!shaft_of(&p, axis, 0)) {
        for (int i = 0; i < p.n; i++)
            hits[i] = sph_packet_alone(f, rays, i);
        return;
    }
    for (int v = 0; v < p.vectors; v++) {
        put(p.b, v, (real){0} + 0x1p60);
        put(p.root, v, (real){0});
        put(p.leaf, v, (real){0});
    }
    nearest(&p);
    keys_of(&p, hits);
}

/* Which of n rays that go alike, of numbers `lanes`, end at something: bits of these. */
static uint64_t hidden_of(struct packet *p, const int *lanes, int n, int axis) {
    enum { FEW = 3 };
    const struct sph_bundle *r = p->rays;
    uint64_t result = 0;
    load(p, n < r->n ? lanes : NULL, n);
    if (n <= FEW || !shaft_of(p, axis, 1)) {
        for (int i = 0; i < n; i++)
            result |= (uint64_t)(sph_packet_alone(p->f, r, lanes[i]).key != 0) << lanes[i];
        return result;
    }
    for (int i = 0; i < p->vectors * LANES; i++)
        p->own[i] = i < n ? r->skip[lanes[i]].id : -1.0;
    uint64_t all = p->live;
    int left[SPH_PACKET], n_left = 0, whole = hidden(p, lanes);
    if (n == r->n) result = all & ~p->live;
    for (uint64_t some = n < r->n ? all & ~p->live : 0; some; some &= some - 1)
        result |= 1ull << lanes[__builtin_ctzll(some)];
    if (whole) return result;
    for (uint64_t some = p->live; some; some &= some - 1)
        left[n_left++] = lanes[__builtin_ctzll(some)];
    for (int i = 0; i < n_left; i += PART)
        result |= hidden_of(p, left + i, n_left - i < PART ? n_left - i : PART, axis);
    return result;
}

static uint64_t packet_hidden(const struct sph_fast *f, const struct sph_bundle *rays) {
    struct packet p;
    uint64_t left = ~0ull >> (SPH_PACKET - rays->n), result = 0;
    p.f = f;
    p.rays = rays;
    for (int i = 0; i < rays->n && rays->inside; i++) {
        if (!rays->skip[i].inside) continue; /* the far root of the own sphere */
        left &= ~(1ull << i);
        result |= (uint64_t)(sph_packet_alone(f, rays, i).key != 0) << i;
    }
    while (left) {
        int lanes[SPH_PACKET], axis, n = 0;
        uint64_t some = alike(rays, left, &axis);
        left &= ~some;
        if (some == ~0ull >> (SPH_PACKET - rays->n))
            for (; n < rays->n; n++)
                lanes[n] = n;
        for (; n < rays->n && some; some &= some - 1)
            lanes[n++] = __builtin_ctzll(some);
        result |= hidden_of(&p, lanes, n, axis);
    }
    return result;
}
