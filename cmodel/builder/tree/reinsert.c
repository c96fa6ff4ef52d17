/* reinsert.c - see links.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Meister, Bittner: Parallel Reinsertion for Bounding Volume Hierarchy Optimization (2018), with
 * balls or boxes. In a round nodes look for the place where they would save most; the tree stands
 * still, so that threads may share the work. Then the moves are made one after another, those that
 * save most first, unless one before touched the same nodes. In the next round those look again
 * that wanted to move or were touched.
 */
#include "builder/tree/links.h"

#include "builder/tree/radix.h"
#include "common/parallel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* EXACT: more spheres than that have a ball around those of the children, while nodes move.
 * ENOUGH: a round that saves less than this part is the last one. STEP:
 * nodes between two tellings. */
enum { ROUNDS = 10, LOOKS = 256, EXACT = 4096, ENOUGH = 1024, PARALLEL = 8192, STEP = 65536 };

struct move {
    uint32_t node, to; /* becomes the sibling of `to` */
};

/* A search for the best place of a node. */
struct seek {
    const struct sph_link_pair *pairs;
    struct sph_link_ball ball; /* of the node */
    float area;                /* its own, which no place is better than */
    float gain;                /* of the best place, */
    uint32_t to;               /* a side; NONE is beside the root */
    int boxes;
    int looks; /* places that may still be looked at */
};

static float square(float x) {
    return x * x;
}

static inline const struct sph_link_ball *ball_of(const struct seek *s, uint32_t side) {
    return &s->pairs[side >> 1].ball[side & 1];
}

static inline float area_of(const struct seek *s, const struct sph_link_ball *a) {
    return s->boxes ? sph_link_surface(a->lo, a->hi) : a->r * a->r;
}

/* How far a node's ball or box is from another: between centres, of boxes four times the square of
 * that. */
static inline float distance(const struct seek *s, const struct sph_link_ball *at,
                             const struct sph_link_ball *to) {
    float sum = 0;
    if (!s->boxes) return sph_link_apart(at, to);
    for (int i = 0; i < 3; i++)
        sum += square(at->lo[i] + at->hi[i] - to->lo[i] - to->hi[i]);
    return sum;
}

/* The area of what is around two that are so far apart. */
static inline float merged(const struct seek *s, const struct sph_link_ball *a,
                           const struct sph_link_ball *b, float apart) {
    if (s->boxes) {
        struct sph_link_ball both = sph_link_box(a, b);
        return sph_link_surface(both.lo, both.hi);
    }
    if (apart + b->r <= a->r) return square(a->r);
    if (apart + a->r <= b->r) return square(b->r);
    return square((apart + a->r + b->r) / 2);
}

/* Looks for the best place in the subtree `top`, a side, which the node is not in. saved: what
 * taking it out saves. */
static inline void look_below(struct seek *s, uint32_t top, float saved) {
    enum { DEEP = 64 };
    struct {
        uint32_t side;
        float left; /* saved, less what the nodes above it grow */
        float apart;
    } stack[DEEP];
    const struct sph_link_ball ball = s->ball;
    int n = 0;
    stack[n].side = top, stack[n].left = saved;
    stack[n++].apart = distance(s, ball_of(s, top), &ball);
    while (n && s->looks > 0) {
        uint32_t side = stack[--n].side;
        float left = stack[n].left, apart[2];
        if (left - s->area <= s->gain) continue;
        s->looks--;
        const struct sph_link_ball *at = ball_of(s, side);
        float area = merged(s, at, &ball, stack[n].apart), grown = area - area_of(s, at);
        if (left - area > s->gain) s->gain = left - area, s->to = side;
        if (grown > 0) left -= grown;
        uint32_t below = s->pairs[side >> 1].child[side & 1];
        if (below & SPH_PAIR_LEAF || left - s->area <= s->gain || n + 2 > DEEP) continue;
        const struct sph_link_pair *pair = &s->pairs[below];
        for (int i = 0; i < 2; i++)
            apart[i] = distance(s, &pair->ball[i], &ball);
        uint32_t near = apart[1] < apart[0]; /* goes first */
        stack[n].side = 2 * below + !near, stack[n].apart = apart[!near], stack[n++].left = left;
        stack[n].side = 2 * below + near, stack[n].apart = apart[near], stack[n++].left = left;
    }
}

/* The best move of a node, a side: up from ancestor to ancestor, each time into its other side. */
static inline struct seek look(const struct sph_links *l, uint32_t side, int boxes) {
    struct seek s = {.pairs = l->pairs, .to = SPH_LINK_NONE, .boxes = boxes, .looks = LOOKS};
    const struct sph_link_ball *root = &l->ball[l->root];
    uint32_t below = l->pairs[side >> 1].above, sibling = l->pairs[side >> 1].child[~side & 1];
    s.ball = *ball_of(&s, side);
    s.area = area_of(&s, &s.ball);
    float saved = area_of(&s, below == SPH_LINK_NONE ? root : ball_of(&s, below));
    struct sph_link_ball rest = *ball_of(&s, side ^ 1); /* of `below` without the node */
    if (!(sibling & SPH_PAIR_LEAF)) {
        float more = saved + area_of(&s, &rest) -
                     merged(&s, &rest, &s.ball, boxes ? 0 : distance(&s, &rest, &s.ball));
        for (uint32_t i = 0; i < 2; i++) /* the place beside the sibling is where it is */
            look_below(&s, 2 * sibling + i, more);
    }
    while (below != SPH_LINK_NONE && s.looks > 0) {
        uint32_t other = below ^ 1, pivot = l->pairs[below >> 1].above;
        look_below(&s, other, saved);
        rest = boxes ? sph_link_box(&rest, ball_of(&s, other))
                     : sph_link_merge(l, &rest, ball_of(&s, other));
        const struct sph_link_ball *old = pivot == SPH_LINK_NONE ? root : ball_of(&s, pivot);
        float area = area_of(&s, old), less = area_of(&s, &rest);
        if (less > area) rest = *old, less = area;
        if (saved - less > s.gain) s.gain = saved - less, s.to = pivot;
        saved += area - less;
        below = pivot;
    }
    return s;
}

static int is_below(const struct sph_links *l, uint32_t node, uint32_t above) {
    while (node != SPH_LINK_NONE && node != above)
        node = l->parent[node];
    return node == above;
}

static void replace(struct sph_links *l, uint32_t parent, uint32_t old, uint32_t new) {
    l->parent[new] = parent;
    if (parent == SPH_LINK_NONE)
        l->root = new;
    else
        l->child[parent - l->n][l->child[parent - l->n][1] == old] = new;
}

/* What is below an inner node changes, and below all above it. */
static void outdate(struct sph_links *l, uint32_t node) {
    for (; node != SPH_LINK_NONE && !l->stale[node - l->n]; node = l->parent[node])
        l->stale[node - l->n] = 1;
}

/* Makes a move unless a node that it touches is marked; marks them. */
static int apply(struct sph_links *l, const struct move *m, uint8_t *marked) {
    uint32_t node = m->node, to = m->to, parent = l->parent[node];
    if (marked[node]) return 0; /* it may be the root by now */
    uint32_t sibling = sph_link_other(l, parent, node);
    uint32_t touched[] = {node, to, parent, sibling, l->parent[parent], l->parent[to]};
    int n = sizeof touched / sizeof *touched;
    for (int i = 0; i < n; i++)
        if (touched[i] != SPH_LINK_NONE && marked[touched[i]]) return 0;
    if (is_below(l, to, node)) return 0; /* since another move */
    for (int i = 0; i < n; i++)
        if (touched[i] != SPH_LINK_NONE) marked[touched[i]] = 1;
    outdate(l, parent);
    replace(l, l->parent[parent], parent, sibling);
    replace(l, l->parent[to], to, parent);
    l->child[parent - l->n][0] = to, l->child[parent - l->n][1] = node;
    l->parent[to] = l->parent[node] = parent;
    outdate(l, l->parent[parent]); /* the parent itself is */
    return 1;
}

/* What a round works on. */
struct work {
    float *gain;   /* 2n-1: of each node, and the node that it should be the sibling of */
    uint32_t *to;  /* 2n-1 */
    uint8_t *look; /* 2n-1: it looks in the next round; nodes that moves have touched */
    uint64_t *key; /* of those that gain; two lists */
    uint32_t most; /* keys that there is room for */
    int failed;    /* memory is out */
    int end;       /* nobody wants the tree any more */
    struct sph_links *links;
    uint32_t seen; /* steps of a round that are done */
    const struct sph_progress *progress;
};

/* The node of a side. */
static uint32_t node_of(const struct sph_links *l, uint32_t side) {
    if (side == SPH_LINK_NONE) return l->root;
    uint32_t child = l->pairs[side >> 1].child[side & 1];
    return child & SPH_PAIR_LEAF ? child & ~SPH_PAIR_LEAF : l->pairs[child].node;
}

/* The nodes that gain, the most first, of equal ones the lower node; how many. */
static uint32_t most_first(const struct sph_links *l, struct work *w, const uint64_t **sorted) {
    uint32_t all = 2 * l->n - 1, n = 0, bits;
    for (uint32_t i = 0; i < all; i++)
        n += w->gain[i] > 0;
    if (n > w->most) {
        free(w->key);
        w->most = n;
        w->key = malloc(2ull * n * sizeof *w->key);
        if (!w->key) return w->failed = 1, w->most = 0;
    }
    n = 0;
    for (uint32_t i = 0; i < all; i++) {
        if (!(w->gain[i] > 0)) continue;
        memcpy(&bits, &w->gain[i], sizeof bits);
        w->key[n++] = (uint64_t)~bits << 32 | i;
    }
    *sorted = n ? sph_radix(w->key, w->key + n, n) : NULL;
    return n;
}

/* The nodes on some sides look for the place where they would save most. */
static void sides(void *user, uint32_t first, uint32_t end) {
    struct work *w = user;
    const struct sph_links *l = w->links;
    for (uint32_t side = first; side < end && !__atomic_load_n(&w->end, __ATOMIC_RELAXED); side++) {
        if (side % STEP == STEP - 1) {
            uint32_t steps = __atomic_add_fetch(&w->seen, 1, __ATOMIC_RELAXED);
            if (sph_progress_at(w->progress, (double)steps * STEP / (2 * l->n - 1)))
                __atomic_store_n(&w->end, 1, __ATOMIC_RELAXED);
        }
        uint32_t node = node_of(l, side);
        w->gain[node] = 0;
        if (!w->look[node]) continue;
        struct seek s = l->boxes ? look(l, side, 1) : look(l, side, 0);
        w->gain[node] = s.gain;
        if (s.gain > 0) w->to[node] = node_of(l, s.to);
    }
}

/* One round; the number of moves. */
static uint32_t go_round(struct sph_links *l, struct work *w, const struct sph_progress *p) {
    uint32_t all = 2 * l->n - 1, done = 0;
    const uint64_t *key;
    w->gain[l->root] = 0;
    w->links = l, w->seen = 0, w->progress = p;
    sph_parallel_for(all - 1, PARALLEL, sides, w);
    if (w->end) return 0;
    memset(w->look, 0, all);
    uint32_t n = most_first(l, w, &key);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t node = (uint32_t)key[i];
        done += (uint32_t)apply(l, &(struct move){node, w->to[node]}, w->look);
    }
    for (uint32_t i = 0; i < n; i++)
        w->look[(uint32_t)key[i]] = 1;
    return done;
}

int sph_reinsert(struct sph_links *l) {
    uint32_t all = 2 * l->n - 1;
    struct work w = {.gain = malloc(all * sizeof *w.gain),
                     .to = malloc(all * sizeof *w.to),
                     .look = malloc(all)};
    l->pairs = aligned_alloc(sizeof *l->pairs, (l->n - 1) * sizeof *l->pairs);
    int good = w.gain && w.to && w.look && l->pairs;
    if (good) {
        double sum = sph_links_fit(l, EXACT), before = 0;
        memset(w.look, 1, all);
        for (int round = 0; round < ROUNDS; round++) { /* each takes some half of the one before */
            double from = 1 - exp2(-round), to = 1 - exp2(-round - 1);
            struct sph_progress part = sph_progress_part(l->progress, from, to);
            if (!go_round(l, &w, &part) || w.end) break;
            before = sum, sum = sph_links_fit(l, EXACT);
            if (before - sum < sum / ENOUGH) break;
        }
        good = !w.failed;
    }
    free(w.gain);
    free(w.to);
    free(w.look);
    free(w.key);
    free(l->pairs);
    l->pairs = NULL;
    return good ? 0 : -1;
}
