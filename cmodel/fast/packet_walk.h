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

#define DOUBT 0x1p-49         /* of b * b, of a discriminant */
#define NOTHING 0x1p59        /* b of what has hit is less */
#define WHOLE 0xfffffffffffff /* the bits of a double that 2^52 is added to */

/* A node to visit, and where along the shaft it begins. */
struct waiting {
    int32_t near;
    uint32_t node;
};

/* Puts the inner children that the shaft meets on the stack, the nearest last; returns the leaves
 * that it meets. */
static inline unsigned meets(const struct sph_shaft *h, const struct sph_fast_node *n,
                             struct waiting *stack, int *sp) {
    const struct sph_shaft_plane *plane = h->plane;
    four near = products(n->xy, plane->xy) + products(n->zr, plane->zr);
    four missed = near > plane->bound;
    for (int i = 1; i < SPH_SHAFT_PLANES; i++)
        missed |= products(n->xy, plane[i].xy) + products(n->zr, plane[i].zr) > plane[i].bound;
    unsigned met = ~signs(missed) & ((1u << n->tests) - 1), inner = met & ((1u << n->n_inner) - 1);
    int from = *sp;
    for (unsigned i = inner; i; i &= i - 1) {
        int child = __builtin_ctz(i), at = (*sp)++;
        struct waiting w_new = {near[child], n->inner + (uint32_t)child};
        for (; at > from && stack[at - 1].near < w_new.near; at--)
            stack[at] = stack[at - 1];
        stack[at] = w_new;
    }
    return met ^ inner;
}

/* Ray i against a leaf record, by integers; the nearer of two hits stays. */
static void decide(struct packet *p, int i, uint32_t leaf) {
    int64_t best = p->found >> i & 1 ? p->leaf[i] >> 32 : -1;
    struct sph_hit hit = sph_packet_exact(p->f, p->rays, i, best, &leaf);
    if (!hit.key) return;
    p->found |= 1ull << i;
    p->exact |= 1ull << i;
    p->leaf[i] = leaf_word(leaf, hit.id);
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
    double x = (double)oc[0], y = (double)oc[1], z = (double)oc[2], beside = -(double)k;
    real mine = (real)((real_mask){0} + leaf_word(number, leaf->id));
    uint64_t changed = 0;
    for (int v = 0; v < p->vectors; v++) {
        real b = greater(dir(p, 0, v) * x + dir(p, 1, v) * y + dir(p, 2, v) * z, (real){0});
        real bb = b * b, past = load_vector(p->a, v) * beside;
        unsigned hit = bits(bb * (1 + DOUBT) > past);
        if (!hit) continue;
        real disc = bb - past, root = roots(disc), key = b - root;
        real margin = b * 0x1p-22 + 4, best = load_vector(p->b, v) - load_vector(p->root, v);
        real_mask sure = disc > bb * DOUBT, first = sure & (key < best - margin);
        unsigned take = bits(first), leave = bits(sure & (key > best + margin));
        store_vector(p->b, v, pick(first, b, load_vector(p->b, v)));
        store_vector(p->root, v, pick(first, root, load_vector(p->root, v)));
        *leaves_at(p, v) = (real_mask)pick(first, mine, (real)*leaves_at(p, v));
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
        real along = dir(p, h->axis, v), key = load_vector(p->b, v) - load_vector(p->root, v);
        most = greater(most, greater(along, -along) * key / load_vector(p->a, v));
    }
    const struct sph_profile *w = sph_machine_profile(p->f->m);
    double s = greatest(most) / (double)(1 << (w->w - w->fw)) + 4; /* it starts less than 1 ahead */
    return (s < SPH_SHAFT_FAR ? (int32_t)s : SPH_SHAFT_FAR) + h->start - SPH_FILTER_MARGIN;
}

static void begin(struct packet *p) {
    real_mask none = (real_mask){0} + leaf_word(0, SPH_ID_NONE);
    for (int v = 0; v < p->vectors; v++) {
        store_vector(p->b, v, (real){0} + 2 * NOTHING);
        store_vector(p->root, v, (real){0});
        *leaves_at(p, v) = none;
    }
}

/* Through the tree; 0 if no sphere was tested. */
static int nearest(struct packet *p) {
    struct waiting stack[MOST_WAITING];
    four *end = &p->shaft.plane[SPH_SHAFT_END].bound;
    int sp = 1, begun = 0;
    stack[0] = (struct waiting){INT32_MIN, p->f->root};
    while (sp) {
        struct waiting at = stack[--sp];
        if (at.near > (*end)[0]) continue;
        const struct sph_fast_node *n = &p->f->nodes[at.node];
        unsigned leaves = meets(&p->shaft, n, stack, &sp);
        if (!leaves) continue;
        if (!begun) begin(p);
        begun = 1;
        int changed = 0;
        for (; leaves; leaves &= leaves - 1)
            changed |= nearer(p, n->leaf + (unsigned)__builtin_ctz(leaves));
        if (changed && p->found == p->live) *end = (four){0} + deepest(p);
    }
    return begun;
}

/* Keys of what was found; what a double cannot tell, integers do. */
static void keys_of(struct packet *p, struct sph_hit *hits) {
    for (int v = 0; v < p->vectors; v++) {
        real b = load_vector(p->b, v), root = load_vector(p->root, v);
        real down = (root + 0x1p52) - 0x1p52, off = root - down, by = pick(root > 0, root, b);
        real error = b * b * 0x1p-50 + root * by * 0x1p-51;
        unsigned doubt = bits((off * by <= error) & (off * by >= -error));
        real key = b - (down + pick(down > root, (real){0} - 1, (real){0}));
        real_mask some = b < NOTHING, word = (real_mask)(key + 0x1p52) & WHOLE & some;
        store_pairs(&hits[v * LANES], word, hit_word(*leaves_at(p, v)));
        doubt |= (unsigned)(p->exact >> v * LANES) & ((1u << LANES) - 1);
        for (doubt &= bits(some); doubt; doubt &= doubt - 1) {
            int i = v * LANES + __builtin_ctz(doubt);
            uint32_t leaf = (uint32_t)(p->leaf[i] >> 32);
            if (i < p->n) hits[i] = sph_packet_exact(p->f, p->rays, i, -1, &leaf);
        }
    }
}

/* A sphere against shadow rays, by the rule of sph_leaf_test(). */
static void hides(struct packet *p, uint32_t number) {
    const struct sph_fast_leaf *leaf = &p->f->leaves[number];
    double x = leaf->ctr[0], y = leaf->ctr[1], z = leaf->ctr[2];
    double square = (double)leaf->rad * leaf->rad, id = leaf->id;
    for (int v = 0; v < p->vectors; v++) {
        real ox = x - org(p, 0, v), oy = y - org(p, 1, v), oz = z - org(p, 2, v);
        real k = square - (ox * ox + oy * oy + oz * oz), a = load_vector(p->a, v);
        real b = ox * dir(p, 0, v) + oy * dir(p, 1, v) + oz * dir(p, 2, v);
        real bb = b * b, disc = bb + a * k, doubt = bb * DOUBT;
        real_mask other = load_vector(p->own, v) != id;
        real_mask meets_it =
            other & (k < 0) & (b > 0) & (disc > -doubt) & ((b < a) | (k + 2 * b - a > 0));
        unsigned hit = bits(meets_it & (disc > doubt)), slow = bits(meets_it) & ~hit;
        if (p->rays->inside) slow |= bits(other & (k >= 0));
        p->live &= ~((uint64_t)hit << v * LANES);
        for (slow &= (unsigned)(p->live >> v * LANES) & ((1u << LANES) - 1); slow;
             slow &= slow - 1) {
            int i = v * LANES + __builtin_ctz(slow);
            uint32_t same = number;
            if (sph_packet_exact(p->f, p->rays, i, -1, &same).key) p->live &= ~(1ull << i);
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
static int hidden(struct packet *p) {
    struct waiting stack[MOST_WAITING];
    int sp = 1, visits = 0, most = p->n > PART ? PATIENCE : INT32_MAX;
    stack[0] = (struct waiting){0, p->f->root};
    while (sp && p->live) {
        if (visits++ == most) return 0;
        const struct sph_fast_node *n = &p->f->nodes[stack[--sp].node];
        unsigned leaves = meets(&p->shaft, n, stack, &sp);
        for (; leaves && p->live; leaves &= leaves - 1)
            hides(p, n->leaf + (unsigned)__builtin_ctz(leaves));
    }
    return 1;
}

static void packet_nearest(const struct sph_fast *f, const struct sph_bundle *rays,
                           struct sph_hit *hits) {
    struct packet p;
    int axis = 0;
    for (size_t at = 0; at < sizeof rays->dir; at += 64)
        __builtin_prefetch((const char *)rays->dir + at);
    p.f = f;
    for (int k = 1; k < 3; k++)
        if (abs(rays->dir[k][0]) > abs(rays->dir[axis][0])) axis = k;
    load(&p, rays, NULL, rays->n);
    int together = shaft_of(&p, axis, 0);
    if (together && nearest(&p)) {
        keys_of(&p, hits);
        return;
    }
    for (int i = 0; i < p.n; i++)
        hits[i] = together ? (struct sph_hit){0, SPH_ID_NONE, 0, 0} : sph_packet_alone(f, rays, i);
}

/* Which of n rays that go alike, of numbers `lanes`, end at something: bits of these. */
static uint64_t hidden_of(struct packet *p, const struct sph_bundle *rays, const int *lanes, int n,
                          int axis) {
    enum { FEW = 3 };
    uint64_t result = 0;
    if (n > FEW) load(p, rays, n < rays->n ? lanes : NULL, n);
    if (n <= FEW || !shaft_of(p, axis, 1)) {
        for (int i = 0; i < n; i++)
            result |= (uint64_t)(sph_packet_alone(p->f, rays, lanes[i]).key != 0) << lanes[i];
        return result;
    }
    for (int i = 0; i < p->vectors * LANES; i++)
        p->own[i] = p->rays->skip[i].id;
    uint64_t all = p->live;
    int left[SPH_PACKET], n_left = 0, whole = hidden(p);
    if (n == rays->n) result = all & ~p->live;
    for (uint64_t some = n < rays->n ? all & ~p->live : 0; some; some &= some - 1)
        result |= 1ull << lanes[__builtin_ctzll(some)];
    if (whole) return result;
    for (uint64_t some = p->live; some; some &= some - 1)
        left[n_left++] = lanes[__builtin_ctzll(some)];
    for (int i = 0; i < n_left; i += PART)
        result |= hidden_of(p, rays, left + i, n_left - i < PART ? n_left - i : PART, axis);
    return result;
}

static uint64_t packet_hidden(const struct sph_fast *f, const struct sph_bundle *rays) {
    struct packet p;
    uint64_t left = ~0ull >> (SPH_PACKET - rays->n), result = 0;
    p.f = f;
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
        result |= hidden_of(&p, rays, lanes, n, axis);
    }
    return result;
}
