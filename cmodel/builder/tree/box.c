/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/box.h"

#include <stdlib.h>
#include <string.h>

#include "builder/grid/near.h"
#include "builder/prim/build.h"
#include "builder/tree/visibility_samples.h"
#include "machine/box.h"
#include "machine/records.h"
#include "trace/bih.h"
#include "trace/leaf_unit.h"
#include "trace/traverse.h"

int32_t sph_outwards(const struct sph_profile *p, int32_t plane, int up) {
    int64_t unit = 1ll << sph_error_bits(p), end = 1ll << (p->w - 1);
    int64_t margin = (sph_point_error(p) + unit - 1) / unit;
    int64_t far = up ? plane + margin : plane - margin;
    return (int32_t)(far > end ? end : far < -end ? -end : far);
}

void sph_box_of(const struct sph_plants *p, uint32_t id, struct sph_aabb *box) {
    struct sph_grid_prim prim = sph_grid_prim_of(p->balls, p->n_spheres, p->facets, id);
    const struct sph_prim_build *kind = sph_prim_build_of(prim.kind);
    int32_t end = 1 << (p->profile->w - 1);
    if (sph_kind_unbounded(prim.kind)) {
        *box = (struct sph_aabb){{-end, -end, -end}, {end, end, end}};
        return;
    }
    kind->box(&prim, box);
    for (int i = 0; i < 3; i++) {
        box->lo[i] = sph_outwards(p->profile, box->lo[i], 0);
        box->hi[i] = sph_outwards(p->profile, box->hi[i], 1);
    }
}

static void add(struct sph_aabb *to, const struct sph_aabb *box) {
    for (int i = 0; i < 3; i++) {
        if (box->lo[i] < to->lo[i]) to->lo[i] = box->lo[i];
        if (box->hi[i] > to->hi[i]) to->hi[i] = box->hi[i];
    }
}

struct sph_aabb *sph_box_nodes(const struct sph_plants *p, const struct sph_tree *tree,
                               struct sph_error *err) {
    struct sph_aabb *boxes = malloc(tree->n_nodes * sizeof *boxes), leaf;
    if (!boxes) sph_fail(err, "out of memory for %u boxes", tree->n_nodes);
    for (uint32_t i = boxes ? tree->n_nodes : 0; i-- > 0;) { /* children stand behind parents */
        const struct sph_tree_node *node = &tree->nodes[i];
        boxes[i] =
            (struct sph_aabb){{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
        for (int j = 0; j < node->n_inner; j++)
            add(&boxes[i], &boxes[node->child[j]]);
        for (int j = 0; j < node->n_leaf; j++) {
            sph_box_of(p, node->child[node->n_inner + j], &leaf);
            add(&boxes[i], &leaf);
        }
    }
    return boxes;
}

/* An axis of a frame that holds lo .. hi: the least step of SPH_BOX_CODES of which reach the end.
 * The origin is a whole number of units of 2^shift. */
static void frame(const struct sph_profile *p, int32_t lo, int32_t hi, int32_t *org, int *step) {
    int unit = sph_frame_org_shift(p);
    *org = lo >> unit;
    for (*step = sph_frame_step_shift(p);
         (int64_t)hi - ((int64_t)*org * (1 << unit)) > (int64_t)SPH_BOX_CODES << *step;)
        ++*step;
}

void sph_box_put(uint32_t *line, const struct sph_aabb *boxes, int n, const struct sph_profile *p) {
    for (int i = 0; n && i < 3; i++) {
        struct sph_aabb all = boxes[0];
        int32_t org;
        int step;
        for (int j = 1; j < n; j++)
            add(&all, &boxes[j]);
        frame(p, all.lo[i], all.hi[i], &org, &step);
        sph_field_set(line, SPH_FRAME_ORG_X_LSB + i * SPH_FRAME_ORG_X_BITS, SPH_FRAME_ORG_X_BITS,
                      (uint32_t)org);
        sph_field_set(line, SPH_FRAME_STEP_X_LSB + i * SPH_FRAME_STEP_X_BITS, SPH_FRAME_STEP_X_BITS,
                      (uint32_t)(step - sph_frame_step_shift(p)));
        for (int j = 0; j < n; j++) {
            int at = j * SPH_BOX_STRIDE;
            int64_t from = (int64_t)org * (1 << sph_frame_org_shift(p));
            int64_t lo = (boxes[j].lo[i] - from) >> step;
            int64_t hi = ((boxes[j].hi[i] - from + (1ll << step) - 1) >> step) - 1;
            if (lo == SPH_BOX_CODES) lo--; /* nothing but the end of the last step */
            if (hi < 0) hi = 0;            /* nothing but the origin */
            sph_field_set(line, at + SPH_BOX_LO_X_LSB + i * SPH_BOX_LO_X_BITS, SPH_BOX_LO_X_BITS,
                          (uint32_t)lo);
            sph_field_set(line, at + SPH_BOX_HI_X_LSB + i * SPH_BOX_HI_X_BITS, SPH_BOX_HI_X_BITS,
                          (uint32_t)hi);
        }
    }
}

/* ---- box_order ---- */

/* What the rays that met a node found below it: each looks at the node as if it came there first.
 */
struct found {
    uint64_t visits, hits;
};

struct work {
    const struct sph_machine *m;
    struct found *found; /* of each line that may be a node */
};

/* A ray on its walk. */
struct walker {
    const struct work *work;
    const struct sph_ray *ray;
    struct sph_bih_ray planes;
    int32_t depth_max;
    struct sph_ray_query query;
};

/* Walks all that the ray meets below a node, whatever is hit there. Returns its visits there until
 * the first hit. */
static uint32_t walk(struct walker *w, uint32_t node, int *hit) {
    struct sph_found met;
    uint32_t visits = 1;
    *hit = 0;
    if (!sph_visit(w->work->m, w->ray, &w->planes, node, w->depth_max, &met)) return visits;
    w->query.best.key = 0;
    for (uint32_t j = 0; met.leaves >> j; j++)
        if (met.leaves >> j & 1)
            sph_leaf_visit(&w->query, sph_record(w->work->m, w->query.whole, met.line, j));
    *hit = w->query.best.key != 0;
    for (int i = 0; i < met.inner.count; i++) {
        int below;
        uint32_t more = walk(w, met.inner.base + met.inner.list[i].child, &below);
        if (!*hit) visits += more;
        *hit |= below;
    }
    struct found *found = &w->work->found[node];
    __atomic_fetch_add(&found->visits, visits, __ATOMIC_RELAXED);
    __atomic_fetch_add(&found->hits, (uint64_t)*hit, __ATOMIC_RELAXED);
    return visits;
}

static void look(void *user, const struct sph_logged *logged) {
    const struct sph_ray *ray = &logged->ray;
    struct walker walker = {.work = user, .ray = ray};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    int hit;
    if (ray->kind != SPH_SHADOW) return;
    sph_bih_setup(sph_machine_profile(walker.work->m), ray, &walker.planes);
    walker.depth_max = sph_box_depth(walker.planes.limit);
    walker.query = sph_ray_query_of(walker.work->m, ray, &counters, &errors);
    walk(&walker, (uint32_t)walker.work->m->regs[SPH_REG_ROOT], &hit);
}

/* Whether a is more likely to hit in a visit than b. */
static int before(const struct found *a, const struct found *b) {
    return a->hits * (b->visits + 1) > b->hits * (a->visits + 1);
}

/* Child i of a node, which stands in line base + i, becomes that in place `from[i]` of what was. */
static void reorder_children(struct sph_machine *m, uint32_t node, uint32_t base, const int *from,
                             int n) {
    uint32_t lines[4][SPH_LINE_WORDS], old[SPH_LINE_WORDS], *line = sph_line(m, node);
    memcpy(lines, sph_line(m, base), (size_t)n * sizeof *lines);
    memcpy(old, line, sizeof old);
    for (int i = 0; i < n; i++) {
        memcpy(sph_line(m, base + (uint32_t)i), lines[from[i]], sizeof *lines);
        for (int at = 0; at < SPH_BOX_STRIDE; at += SPH_BOX_LO_X_BITS)
            sph_field_set(line, i * SPH_BOX_STRIDE + at, SPH_BOX_LO_X_BITS,
                          sph_field(old, from[i] * SPH_BOX_STRIDE + at, SPH_BOX_LO_X_BITS));
    }
}

/* Orders the children of a node, and what is below them. */
static void order(const struct work *w, struct sph_machine *m, uint32_t node) {
    const uint32_t *line = sph_line(m, node);
    uint32_t base = sph_field(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    int n = (int)sph_field(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS), from[4];
    for (int i = 0; i < n; i++) {
        int at = i;
        for (; at > 0 &&
               before(&w->found[base + (uint32_t)i], &w->found[base + (uint32_t)from[at - 1]]);
             at--)
            from[at] = from[at - 1];
        from[at] = i;
        order(w, m, base + (uint32_t)i);
    }
    reorder_children(m, node, base, from, n);
}

int sph_box_order(struct sph_machine *m, struct sph_error *err) {
    if (m->regs[SPH_REG_TREE] != SPH_TREE_BOX4 || !m->regs[SPH_REG_N_LIGHTS] ||
        !sph_machine_effect(m, SPH_EFFECT_SHADOW) || sph_machine_effect(m, SPH_EFFECT_FIRST))
        return 0;
    uint32_t lines = (uint32_t)m->regs[SPH_REG_PRIM_BASE];
    struct work w = {m, calloc(lines, sizeof *w.found)};
    int failed = w.found ? sph_sample(m, look, &w, err)
                         : sph_fail(err, "out of memory for the order of %u lines", lines);
    if (!failed) order(&w, m, (uint32_t)m->regs[SPH_REG_ROOT]);
    free(w.found);
    return failed;
}
