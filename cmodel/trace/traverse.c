/* traverse.c - see traverse.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/traverse.h"

#include <stddef.h>

#include "core/stages.h"
#include "machine/records.h"
#include "trace/bih_walk.h"
#include "trace/bih.h"
#include "trace/leaf_unit.h"
#include "trace/filter.h"
#include "trace/order.h"
#include "trace/setup.h"

/* ---- visit ---- */

/* Near children come first, equal ones in the order of the node. */
static void insert(struct sph_siblings *s, uint32_t child, int32_t near) {
    int at = s->count++;
    for (; at > 0 && near < s->list[at - 1].near; at--)
        s->list[at] = s->list[at - 1];
    s->list[at].child = (uint8_t)child;
    s->list[at].near = near;
}

/* Whether the ray meets child i of a node, and where; axes: of the frame of boxes, or NULL. */
static int meets(const struct sph_ray *ray, const struct sph_box_axis *axes, const uint32_t *line,
                 int i, int32_t depth_max, int32_t *near) {
    if (axes) {
        struct sph_box_planes planes = sph_box_planes_read(line, i);
        return sph_box_meets(axes, ray, &planes, depth_max, near);
    }
    struct sph_child child = sph_child_read(line, i);
    return sph_filter(ray, &child, depth_max, near);
}

int sph_visit(const struct sph_machine *m, const struct sph_ray *ray, const struct sph_bih_ray *bih,
              uint32_t node, int32_t depth_max, struct sph_found *found) {
    const uint32_t *line = sph_line(m, node);
    uint32_t base = sph_field(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(line, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    found->inner.base = base;
    found->inner.count = 0;
    found->leaves = 0;
    found->line = base + n_inner;
    found->tests = n_inner + n_leaf;
    SPH_NOTE(ray->stages, SPH_STAGE_NODE, 0, node, base, n_inner, n_leaf);
    if (found->tests > 4 ||
        found->line + sph_record_lines(sph_whole(m), n_leaf) > (uint32_t)m->regs[SPH_REG_MEM_LINES])
        return 0;
    struct sph_box_axis axes[3];
    if (bih) {
        struct sph_box_frame frame = sph_box_frame_read(line, sph_machine_profile(m));
        sph_box_axes(sph_machine_profile(m), bih, ray, &frame, axes);
    }
    for (uint32_t i = 0; i < found->tests; i++) {
        int32_t near;
        if (!meets(ray, bih ? axes : NULL, line, (int)i, depth_max, &near)) continue;
        if (i < n_inner)
            insert(&found->inner, i, sph_child_depth(sph_ray_any(ray), near, (int)i));
        else
            found->leaves |= 1u << (i - n_inner);
    }
    return 1;
}

static struct sph_hit brute(const struct sph_machine *m, const struct sph_ray *ray,
                            struct sph_counters *c, uint32_t *errors) {
    struct sph_ray_query query = sph_ray_query_of(m, ray, c, errors);
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    uint32_t spheres = query.whole ? (uint32_t)m->regs[SPH_REG_N_SPHERES] : n;
    for (uint32_t id = 0; id < n;
         id++) { /* a sphere's primitive record begins with its leaf record */
        query.whole = id >= spheres;
        size_t base = (uint32_t)m->regs[query.whole ? SPH_REG_FACET_BASE : SPH_REG_PRIM_BASE];
        sph_leaf_visit(&query, sph_line(m, base + (query.whole ? id - spheres : id)));
        if (ray->kind == SPH_SHADOW && query.best.key) break;
    }
    return query.best;
}

/* Depth of what has a key; boxes have their own. */
static int32_t depth(const struct sph_ray_query *query, const struct sph_bih_ray *bih,
                     uint64_t key) {
    return bih ? sph_box_depth(sph_bih_time(bih, key)) : sph_ray_depth(query->p, query->ray, key);
}

struct sph_hit sph_traverse(const struct sph_machine *m, const struct sph_ray *ray, int how,
                            struct sph_counters *c, uint32_t *visits, uint32_t *errors) {
    if (how == SPH_TRAVERSE_BRUTE) return brute(m, ray, c, errors);
    if (sph_machine_bih(m)) return sph_bih_walk(m, ray, c, visits, errors, NULL);
    struct sph_ray_query query = sph_ray_query_of(m, ray, c, errors);
    const struct sph_hit *best = &query.best;
    struct sph_siblings now = {0}, stack[SPH_STACK_DEPTH];
    int sp = 0, ends = sph_ray_any(ray);
    int32_t depth_max = ray->depth_max;
    struct sph_bih_ray planes, *bih = NULL;
    uint32_t lines = (uint32_t)m->regs[SPH_REG_MEM_LINES], ray_visits = 0;
    uint32_t node = (uint32_t)m->regs[SPH_REG_ROOT];

    if (m->regs[SPH_REG_TREE] == SPH_TREE_BOX4) {
        bih = &planes;
        sph_bih_setup(query.p, ray, bih);
        depth_max = sph_box_depth(bih->limit);
    } else if (ray->stages) {
        const struct sph_across *x = &ray->across;
        SPH_NOTE(ray->stages, SPH_STAGE_ACROSS, 0, SPH_THREE(ray->forg), ray->axis, ray->negative,
                 x->p_a, x->p_b, SPH_THREE(x->q));
    }
    for (;;) {
        if (node >= lines) return *errors |= 1u << SPH_ERROR_BAD_NODE, *best;
        if (ray_visits == (uint32_t)m->regs[SPH_REG_VISIT_LIMIT])
            return *errors |= 1u << SPH_ERROR_VISIT_LIMIT, *best;
        ray_visits++;
        ++*visits;
        c->count[SPH_COUNT_NODE_VISITS]++;

        struct sph_found found;
        if (!sph_visit(m, ray, bih, node, depth_max, &found))
            return *errors |= 1u << SPH_ERROR_BAD_NODE, *best;
        c->count[SPH_COUNT_CHILD_TESTS] += found.tests;
        uint64_t key_before = best->key;
        for (uint32_t j = 0; found.leaves >> j; j++)
            if (found.leaves >> j & 1)
                sph_leaf_visit(&query, sph_record(m, query.whole, found.line, j));
        if (ends && best->key) return *best;
        if (best->key != key_before) depth_max = depth(&query, bih, best->key);

        if (found.inner.count && found.inner.list[0].near <= depth_max) {
            if (now.count) {
                if (sp == SPH_STACK_DEPTH) return *errors |= 1u << SPH_ERROR_STACK_OVERFLOW, *best;
                stack[sp++] = now;
            }
            now = found.inner;
        }
        while (!now.count || now.list[0].near > depth_max) {
            if (!sp) return *best;
            now = stack[--sp];
        }
        node = now.base + now.list[0].child;
        now.count--;
        for (int i = 0; i < now.count; i++)
            now.list[i] = now.list[i + 1];
    }
}
