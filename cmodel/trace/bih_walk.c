/* bih_walk.c - see bih_walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/bih_walk.h"

#include <stddef.h>

#include "core/stages.h"
#include "trace/bih.h"
#include "trace/leaf_unit.h"

/* A node to visit, and where along the ray what lies below it may be. */
struct place {
    uint32_t line, half;
    struct sph_interval span;
};

struct walk {
    const struct sph_machine *m;
    struct sph_ray_query query;
    struct sph_bih_ray bih;
    uint32_t limit; /* T-word of the best hit */
    uint32_t *gaps;
    struct place stack[SPH_BIH_STACK];
    int sp;
};

static int fail(const struct walk *w, int error) {
    *w->query.errors |= 1u << error;
    return 0;
}

/* Tests leaf records first .. end-1 in chunks; 0 if the ray ends with a hit. */
static int leaf(struct walk *w, uint32_t first, uint32_t end) {
    int whole = w->query.whole;
    size_t base = (uint32_t)w->m->regs[SPH_REG_LEAF_BASE];
    while (first < end) {
        uint32_t stop = (whole ? first : first & ~1u) + SPH_BIH_CHUNK;
        for (; first < end && first < stop; first++)
            sph_leaf_visit(&w->query, sph_record(w->m, whole, base, first));
        if (!w->query.best.key) continue;
        if (w->query.ray->kind == SPH_SHADOW) return 0;
        w->limit = sph_bih_time(&w->bih, w->query.best.key);
    }
    return 1;
}

/* Whether the registers let a ray start. */
static int sound(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    uint64_t records = (uint64_t)(uint32_t)r[SPH_REG_LEAF_BASE] + (uint32_t)r[SPH_REG_N_PRIMS];
    return (uint32_t)r[SPH_REG_ROOT] < (uint32_t)r[SPH_REG_MEM_LINES] &&
           records <= (uint32_t)r[SPH_REG_MEM_LINES] &&
           (uint32_t)r[SPH_REG_N_LOOSE] <= (uint32_t)r[SPH_REG_N_PRIMS];
}

/* What of the ray lies in the global box. */
static int box(const struct walk *w, struct sph_interval *span) {
    int in = 1;
    for (int i = 0; i < 3; i++)
        in &= sph_bih_cut(&w->bih, w->query.ray, i, w->m->regs[SPH_REG_BOX_X0 + i], 0, span) &&
              sph_bih_cut(&w->bih, w->query.ray, i, w->m->regs[SPH_REG_BOX_X1 + i], 1, span);
    return in && span->lo <= span->hi && span->lo <= w->limit;
}

/* Takes what was put aside last and does not lie behind the best hit. */
static int pop(struct walk *w, struct place *at) {
    while (w->sp)
        if (w->stack[--w->sp].span.lo <= w->limit) {
            *at = w->stack[w->sp];
            return 1;
        }
    return 0;
}

/* Cuts the span of a child by one plane; whether the ray meets it. */
static int meets(const struct walk *w, int axis, int64_t clip, int below,
                 struct sph_interval *span) {
    return sph_bih_cut(&w->bih, w->query.ray, axis, clip, below, span) && span->lo <= span->hi &&
           span->lo <= w->limit;
}

/* From an inner node to the next; 0 if there is none or an error ends the ray. */
static int inner(struct walk *w, const uint32_t *node, struct place *at) {
    int axis = (int)sph_field(node, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS);
    int64_t clip_l = sph_field_signed(node, SPH_BIH_CLIP_L_LSB, w->query.p->w + 2);
    int64_t clip_r = sph_field_signed(node, SPH_BIH_CLIP_R_LSB, w->query.p->w + 2);
    uint64_t line = (uint64_t)(uint32_t)w->m->regs[SPH_REG_ROOT] +
                    sph_field(node, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS);
    SPH_NOTE(w->query.ray->stages, SPH_STAGE_PLANES, 0, at->line, at->half, axis, clip_l, clip_r,
             sph_field(node, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS),
             sph_field(node, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS));
    if (line >= (uint32_t)w->m->regs[SPH_REG_MEM_LINES]) return fail(w, SPH_ERROR_BAD_NODE);
    w->query.c->count[SPH_COUNT_CHILD_TESTS] += 2;

    struct place child[2] = {{(uint32_t)line, 0, at->span}, {(uint32_t)line, 1, at->span}};
    int met[2];
    if (sph_field(node, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS)) {
        met[0] =
            meets(w, axis, clip_l, 0, &child[0].span) && meets(w, axis, clip_r, 1, &child[0].span);
        met[1] = 0;
    } else {
        met[0] = meets(w, axis, clip_l, 1, &child[0].span);
        met[1] = meets(w, axis, clip_r, 0, &child[1].span);
    }
    int near = w->bih.axis[axis].negative;
    if (met[0] && met[1]) {
        if (w->sp == SPH_BIH_STACK) return fail(w, SPH_ERROR_STACK_OVERFLOW);
        w->stack[w->sp++] = child[!near];
        *at = child[near];
        return 1;
    }
    if (met[0] || met[1]) {
        *at = child[met[1]];
        return 1;
    }
    if (w->gaps) ++*w->gaps;
    return pop(w, at);
}

struct sph_hit sph_bih_walk(const struct sph_machine *m, const struct sph_ray *ray,
                            struct sph_counters *c, uint32_t *visits, uint32_t *errors,
                            uint32_t *gaps) {
    struct walk w = {.m = m, .query = sph_ray_query_of(m, ray, c, errors), .gaps = gaps};
    struct place at = {(uint32_t)m->regs[SPH_REG_ROOT], 0, {0, SPH_BIH_NO_BOUND}};
    uint32_t prims = (uint32_t)m->regs[SPH_REG_N_PRIMS], ray_visits = 0;
    if (!sound(m)) return fail(&w, SPH_ERROR_BAD_NODE), w.query.best;
    sph_bih_setup(w.query.p, ray, &w.bih);
    w.limit = w.bih.limit;
    if (!leaf(&w, 0, (uint32_t)m->regs[SPH_REG_N_LOOSE])) return w.query.best;

    for (int more = box(&w, &at.span); more;) {
        if (ray_visits == (uint32_t)m->regs[SPH_REG_VISIT_LIMIT])
            return fail(&w, SPH_ERROR_VISIT_LIMIT), w.query.best;
        ray_visits++;
        ++*visits;
        c->count[SPH_COUNT_NODE_VISITS]++;
        const uint32_t *node = sph_line(m, at.line) + at.half * (SPH_BIH_STRIDE / 32);
        if (sph_field(node, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS) != SPH_BIH_LEAF) {
            more = inner(&w, node, &at);
            continue;
        }
        uint32_t first = sph_field(node, SPH_BIH_FIRST_LSB, SPH_BIH_FIRST_BITS);
        uint32_t count = sph_field(node, SPH_BIH_COUNT_LSB, SPH_BIH_COUNT_BITS);
        SPH_NOTE(ray->stages, SPH_STAGE_LEAF, 0, at.line, at.half, first, count);
        if ((uint64_t)first + count > prims) return fail(&w, SPH_ERROR_BAD_NODE), w.query.best;
        if (!leaf(&w, first, first + count)) return w.query.best;
        more = pop(&w, &at);
    }
    return w.query.best;
}
