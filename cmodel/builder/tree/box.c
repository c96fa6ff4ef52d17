/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/box.h"

#include <stdlib.h>

#include "builder/grid/near.h"
#include "machine/box.h"
#include "builder/prim/build.h"
#include "machine/kinds.h"

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
