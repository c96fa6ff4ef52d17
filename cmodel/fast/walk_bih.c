/* walk_bih.c - the walk of a BIH: trace/bih.c and trace/bih_walk.c are read beside it
 * SPDX-License-Identifier: Apache-2.0
 *
 * A node is read by whole words; what a ray needs of the planes is divided by the processor.
 */
#include "fast/leaf.h"
#include "fast/setup.h"
#include "machine/records.h"

/* A node to visit, and where along the ray what lies below it may be. */
struct place {
    uint32_t line, half;
    struct sph_interval span;
};

struct walk {
    const struct sph_fast *f;
    struct sph_ray_query query;
    struct sph_bih_ray bih;
    uint32_t limit, leaf_tests;
};

/* sph_bih_cut() */
static inline int cut(const struct walk *w, int axis, int64_t clip, int below,
                      struct sph_interval *span) {
    const struct sph_bih_axis *x = &w->bih.axis[axis];
    int v_shift = w->bih.v_shift;
    int64_t v = clip - w->query.ray->org[axis];
    if (x->zero) return below ? v >= 0 : v <= 0;
    if (x->negative) v = -v;
    if (below != x->negative) {
        if (v < 0) return 0;
        if (x->shift < 0) return 1; /* no bound */
        uint64_t up = (uint64_t)((v + (1ll << v_shift) - 1) >> v_shift);
        uint64_t hi = (up * (x->mant + 2ull) >> x->shift) + 1;
        if (hi < span->hi) span->hi = (uint32_t)hi;
    } else if (v > 0) {
        uint64_t lo = ((uint64_t)(v >> v_shift) * x->mant) >> (x->shift > 0 ? x->shift : 0);
        if (lo > SPH_BIH_NO_BOUND) lo = SPH_BIH_NO_BOUND;
        if (lo > span->lo) span->lo = (uint32_t)lo;
    }
    return 1;
}

/* Cuts the span of a child by one plane; whether the ray meets it. */
static inline int meets(const struct walk *w, int axis, int64_t clip, int below,
                        struct sph_interval *span) {
    return cut(w, axis, clip, below, span) && span->lo <= span->hi && span->lo <= w->limit;
}

/* Tests leaf records first .. end-1 in chunks; 0 if the ray ends with a hit. */
static int leaf(struct walk *w, uint32_t first, uint32_t end) {
    while (first < end) {
        uint32_t stop = (w->query.whole ? first : first & ~1u) + SPH_BIH_CHUNK;
        for (; first < end && first < stop; first++) {
            w->leaf_tests += !w->f->leaves[first].record;
            sph_fast_visit(&w->query, w->f, first);
        }
        if (!w->query.best.key) continue;
        if (w->query.ray->kind == SPH_SHADOW) return 0;
        w->limit = sph_bih_time(&w->bih, w->query.best.key);
    }
    return 1;
}

/* What of the ray lies in the global box. */
static int box(const struct walk *w, struct sph_interval *span) {
    const int32_t *r = w->f->m->regs;
    for (int i = 0; i < 3; i++)
        if (!cut(w, i, r[SPH_REG_BOX_X0 + i], 0, span) ||
            !cut(w, i, r[SPH_REG_BOX_X1 + i], 1, span))
            return 0;
    return span->lo <= span->hi && span->lo <= w->limit;
}

/* The visits of a ray from `at` on; the error it ends with, as a bit. */
static uint32_t visit(struct walk *w, struct place at, uint32_t *visited, uint64_t *tests) {
    const struct sph_machine *m = w->f->m;
    const int32_t *r = m->regs;
    uint32_t root = (uint32_t)r[SPH_REG_ROOT], lines = (uint32_t)r[SPH_REG_MEM_LINES];
    uint32_t prims = (uint32_t)r[SPH_REG_N_PRIMS];
    int spare = 30 - w->query.p->w; /* bits of a word above a plane's w + 2 */
    struct place stack[SPH_BIH_STACK];
    int sp = 0;
    for (;;) {
        if (*visited == w->f->visit_limit) return 1u << SPH_ERROR_VISIT_LIMIT;
        ++*visited;
        const uint32_t *node = sph_line(m, at.line) + at.half * (SPH_BIH_STRIDE / 32);
        int axis = (int)(node[0] >> SPH_BIH_AXIS_LSB), met[2];
        if (axis == SPH_BIH_LEAF) {
            uint32_t first = node[SPH_BIH_FIRST_LSB / 32], count = node[SPH_BIH_COUNT_LSB / 32];
            if ((uint64_t)first + count > prims) return 1u << SPH_ERROR_BAD_NODE;
            if (!leaf(w, first, first + count)) return 0;
            met[0] = met[1] = 0;
        } else {
            int64_t clip_l = (int32_t)(node[SPH_BIH_CLIP_L_LSB / 32] << spare) >> spare;
            int64_t clip_r = (int32_t)(node[SPH_BIH_CLIP_R_LSB / 32] << spare) >> spare;
            uint64_t line = (uint64_t)root + (node[0] & ((1u << SPH_BIH_CHILD_BITS) - 1));
            if (line >= lines) return 1u << SPH_ERROR_BAD_NODE;
            *tests += 2;
            struct place child[2] = {{(uint32_t)line, 0, at.span}, {(uint32_t)line, 1, at.span}};
            if (node[0] >> SPH_BIH_FIT_LSB & 1) {
                met[0] = meets(w, axis, clip_l, 0, &child[0].span) &&
                         meets(w, axis, clip_r, 1, &child[0].span);
                met[1] = 0;
            } else {
                met[0] = meets(w, axis, clip_l, 1, &child[0].span);
                met[1] = meets(w, axis, clip_r, 0, &child[1].span);
            }
            int near = w->bih.axis[axis].negative;
            if (met[0] && met[1]) {
                if (sp == SPH_BIH_STACK) return 1u << SPH_ERROR_STACK_OVERFLOW;
                if (near) {
                    stack[sp++] = child[0];
                    at = child[1];
                } else {
                    stack[sp++] = child[1];
                    at = child[0];
                }
            } else if (met[1]) {
                at = child[1];
            } else if (met[0]) {
                at = child[0];
            }
        }
        if (met[0] || met[1]) continue;
        do {
            if (!sp) return 0;
            at = stack[--sp];
        } while (at.span.lo > w->limit);
    }
}

struct sph_hit sph_fast_walk_bih(const struct sph_fast *f, const struct sph_ray *ray,
                                 struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    struct walk w = {.f = f, .query = sph_fast_ray_query(f, ray, c, errors)};
    struct place at = {f->root, 0, {0, SPH_BIH_NO_BOUND}};
    uint32_t visited = 0;
    sph_bih_setup(w.query.p, ray, &w.bih);
    w.limit = w.bih.limit;
    if (leaf(&w, 0, (uint32_t)f->m->regs[SPH_REG_N_LOOSE]) && box(&w, &at.span))
        *errors |= visit(&w, at, &visited, &c->count[SPH_COUNT_CHILD_TESTS]);
    *visits += visited;
    c->count[SPH_COUNT_NODE_VISITS] += visited;
    c->count[SPH_COUNT_LEAF_TESTS] += w.leaf_tests;
    return w.query.best;
}
