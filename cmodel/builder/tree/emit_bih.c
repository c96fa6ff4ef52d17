/* emit_bih.c - primitives to a bounding interval hierarchy in memory; see emit.h,
 * docs/design/bih.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * The root in line 0, pairs of children as they were made, leaf records in the order of the leaves
 * behind those without bounds, then what every machine has.
 */
#include <stdlib.h>
#include <string.h>

#include "builder/tree/box.h"
#include "builder/emit.h"
#include "machine/records.h"
#include "builder/prim/build.h"

/* What the memory is made of. */
struct content {
    const struct sph_scene *scene;
    const struct sph_ball *balls;
    const struct sph_facets *facets;
    uint32_t *ids; /* of boxes */
    struct sph_aabb *boxes;
    uint32_t n_boxes, n_loose;
    const struct sph_bih *bih;
};

static struct sph_grid_prim prim_of(const struct content *c, uint32_t id) {
    return sph_grid_prim_of(c->balls, c->scene->n_spheres, c->facets, id);
}

/* What has no bounds to the front of ids, boxes of all others. */
static void gather(struct content *c) {
    uint32_t n = c->scene->n_spheres + c->facets->n, next = c->facets->n_loose;
    c->n_boxes = n - next;
    for (uint32_t id = 0; id < n; id++) {
        struct sph_grid_prim prim = prim_of(c, id);
        const struct sph_prim_build *kind = sph_prim_build_of(prim.kind);
        if (sph_kind_unbounded(prim.kind)) {
            c->ids[c->n_loose++] = id;
        } else {
            kind->box(&prim, &c->boxes[next - c->facets->n_loose]);
            c->ids[next++] = id;
        }
    }
}

/* A clip word; the two that leave no room become the ends of W+2 bits. */
static uint32_t clip_word(const struct sph_profile *p, int32_t clip, int up) {
    int32_t end = 1 << (p->w + 1);
    if (clip == SPH_BIH_NOTHING_BELOW) return (uint32_t)-end;
    if (clip == SPH_BIH_NOTHING_ABOVE) return (uint32_t)(end - 1);
    return (uint32_t)sph_outwards(p, clip, up);
}

static void put_node(struct sph_machine *m, const struct sph_bih *bih, uint32_t index,
                     uint32_t n_loose) {
    const struct sph_bih_node *from = &bih->nodes[index];
    const struct sph_profile *p = sph_machine_profile(m);
    uint32_t *to = sph_line(m, index / 2) + index % 2 * (SPH_BIH_STRIDE / 32);
    if (from->axis != SPH_BIH_LEAF && !from->child) return; /* beside the root, or an only child */
    sph_field_set(to, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS, (uint32_t)from->axis);
    if (from->axis == SPH_BIH_LEAF) {
        to[SPH_BIH_FIRST_LSB / 32] = n_loose + from->first;
        to[SPH_BIH_COUNT_LSB / 32] = from->count;
        return;
    }
    if (!from->child) return; /* beside an only child there is none */
    sph_field_set(to, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS, (uint32_t)from->fit);
    sph_field_set(to, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS, from->child / 2);
    to[SPH_BIH_CLIP_L_LSB / 32] = clip_word(p, from->clip_l, !from->fit);
    to[SPH_BIH_CLIP_R_LSB / 32] = clip_word(p, from->clip_r, from->fit);
}

/* Writes leaf records from line `base` on. */
static void put_records(struct sph_machine *m, const struct content *c, uint32_t base) {
    int whole = c->facets->n > 0;
    for (uint32_t i = 0; i < c->n_loose + c->n_boxes; i++) {
        uint32_t id = c->ids[i < c->n_loose ? i : c->n_loose + c->bih->order[i - c->n_loose]];
        struct sph_grid_prim prim = prim_of(c, id);
        sph_put_record(c->scene, &prim, sph_record(m, whole, base, i));
    }
}

/* The global box; brute force has none, and an empty one holds nothing. */
static void put_box(struct sph_machine *m, const struct sph_bih *bih) {
    const struct sph_profile *p = sph_machine_profile(m);
    int32_t *r = m->regs, end = 1 << (p->w + 1);
    for (int i = 0; i < 3; i++) {
        int32_t lo = -end, hi = end - 1;
        if (bih->box.lo[i] > bih->box.hi[i])
            lo = end - 1, hi = -end;
        else if (r[SPH_REG_TREE] == SPH_TREE_BIH)
            lo = sph_outwards(p, bih->box.lo[i], 0), hi = sph_outwards(p, bih->box.hi[i], 1);
        r[SPH_REG_BOX_X0 + i] = lo;
        r[SPH_REG_BOX_X1 + i] = hi;
    }
}

void sph_emit_bih_nodes(const struct sph_bih *bih, uint32_t n_loose, struct sph_machine *m) {
    for (uint32_t i = 0; i < bih->n_nodes; i++)
        put_node(m, bih, i, n_loose);
    put_box(m, bih);
    m->regs[SPH_REG_LEAF_BASE] = (int32_t)(bih->n_nodes / 2);
    m->regs[SPH_REG_N_LOOSE] = (int32_t)n_loose;
}

static int emit(struct content *c, struct sph_machine *m, struct sph_error *err) {
    uint32_t n = c->n_loose + c->n_boxes, tree = c->bih->n_nodes / 2;
    uint64_t records = sph_record_lines(c->facets->n > 0, n);
    uint64_t base = (uint64_t)tree + records;
    if (sph_emit_alloc(m, base + n + c->facets->n, err)) return -1;
    sph_emit_bih_nodes(c->bih, c->n_loose, m);
    put_records(m, c, tree);
    sph_emit_prims(c->scene, c->balls, c->facets, (uint32_t)base, c->bih->n_nodes, m);
    return 0;
}

int sph_emit_bih(const struct sph_scene *scene, const struct sph_plants *plants,
                 const struct sph_bih_options *options, struct sph_kept_tree *kept,
                 struct sph_machine *machine, struct sph_bih_stats *stats, struct sph_error *err) {
    uint32_t n = scene->n_spheres + plants->facets->n;
    struct sph_bih bih = {0};
    struct content c = {.scene = scene,
                        .bih = &bih,
                        .balls = plants->balls,
                        .facets = plants->facets,
                        .ids = malloc((n + 1ull) * sizeof *c.ids),
                        .boxes = malloc((n + 1ull) * sizeof *c.boxes)};
    int failed = -1;
    if (!c.ids || !c.boxes) {
        sph_fail(err, "out of memory for %u boxes", n);
    } else {
        gather(&c);
        failed = sph_bih_next(plants, c.boxes, c.n_boxes, options, kept, &bih, err);
    }
    if (!failed) {
        *stats = bih.stats;
        failed = emit(&c, machine, err);
    }
    free(c.ids);
    free(c.boxes);
    sph_bih_free(&bih);
    return failed;
}
