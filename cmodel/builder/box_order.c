/* box_order.c - see box_order.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/box_order.h"

#include <stdlib.h>
#include <string.h>

#include "engine/render_pixel.h"
#include "machine/records.h"
#include "trace/box.h"
#include "trace/leaf_unit.h"
#include "trace/visit.h"

/* Pixels of the sample at most, and how far they lie apart at least. */
enum { COLUMNS = 32, ROWS = 18, APART = 4 };

/* What the rays that met a node found below it: each looks at the node as if it came there first.
 */
struct found {
    uint64_t visits, hits;
};

struct work {
    const struct sph_machine *m;
    struct found *found; /* of each line that may be a node */
    int failed;
};

/* A ray on its walk. */
struct walker {
    const struct work *work;
    const struct sph_ray *ray;
    struct sph_bih_ray planes;
    int32_t depth_max;
    struct sph_probe probe;
};

/* Walks all that the ray meets below a node, whatever is hit there. Returns its visits there until
 * the first hit. */
static uint32_t walk(struct walker *w, uint32_t node, int *hit) {
    struct sph_found met;
    uint32_t visits = 1;
    *hit = 0;
    if (!sph_visit(w->work->m, w->ray, &w->planes, node, w->depth_max, &met)) return visits;
    w->probe.best.key = 0;
    for (uint32_t j = 0; met.leaves >> j; j++)
        if (met.leaves >> j & 1)
            sph_leaf_visit(&w->probe, sph_record(w->work->m, w->probe.whole, met.line, j));
    *hit = w->probe.best.key != 0;
    for (int i = 0; i < met.inner.count; i++) {
        int below;
        uint32_t more = walk(w, met.inner.base + met.inner.list[i].child, &below);
        if (!*hit) visits += more;
        *hit |= below;
    }
    struct found *found = &w->work->found[node];
#pragma omp atomic
    found->visits += visits;
#pragma omp atomic
    found->hits += (uint64_t)*hit;
    return visits;
}

/* The shadow rays of a pixel. */
static void look(struct work *w, int x, int y) {
    struct sph_ray_log log = {0};
    struct sph_render_options o = {.traverse = SPH_TRAVERSE_TREE, .log = &log};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    int hit;
    sph_render_pixel(w->m, &o, x, y, &counters, &errors, NULL);
    for (int i = 0; i < log.n; i++) {
        const struct sph_ray *ray = &log.rays[i].ray;
        struct walker walker = {.work = w, .ray = ray};
        if (ray->kind != SPH_SHADOW) continue;
        sph_bih_setup(sph_machine_profile(w->m), ray, &walker.planes);
        walker.depth_max = sph_box_depth(walker.planes.limit);
        walker.probe = sph_probe_of(w->m, ray, &counters, &errors);
        walk(&walker, (uint32_t)w->m->regs[SPH_REG_ROOT], &hit);
    }
#pragma omp atomic
    w->failed |= log.full;
    sph_ray_log_free(&log);
}

/* The sample: the middles of equal parts of the frame. */
static void sample(struct work *w) {
    int width = w->m->regs[SPH_REG_FRAME_W], height = w->m->regs[SPH_REG_FRAME_H];
    int columns = (width + APART - 1) / APART, rows = (height + APART - 1) / APART;
    if (columns > COLUMNS) columns = COLUMNS;
    if (rows > ROWS) rows = ROWS;
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < columns * rows; i++)
        look(w, (2 * (i % columns) + 1) * width / (2 * columns),
             (2 * (i / columns) + 1) * height / (2 * rows));
}

/* Whether a is more likely to hit in a visit than b. */
static int before(const struct found *a, const struct found *b) {
    return a->hits * (b->visits + 1) > b->hits * (a->visits + 1);
}

/* Child i of a node, which stands in line base + i, becomes that in place `from[i]` of what was. */
static void put(struct sph_machine *m, uint32_t node, uint32_t base, const int *from, int n) {
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
    put(m, node, base, from, n);
}

int sph_box_order(struct sph_machine *m, struct sph_error *err) {
    if (m->regs[SPH_REG_TREE] != SPH_TREE_BOX4 || !m->regs[SPH_REG_N_LIGHTS] ||
        !sph_machine_effect(m, SPH_EFFECT_SHADOW) || sph_machine_effect(m, SPH_EFFECT_FIRST))
        return 0;
    uint32_t lines = (uint32_t)m->regs[SPH_REG_PRIM_BASE];
    struct work w = {.m = m, .found = calloc(lines, sizeof *w.found)};
    if (w.found) sample(&w);
    int failed = !w.found || w.failed;
    if (!failed) order(&w, m, (uint32_t)m->regs[SPH_REG_ROOT]);
    free(w.found);
    return failed ? sph_fail(err, "out of memory for the order of %u lines", lines) : 0;
}
