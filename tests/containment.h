/* containment.h - do the nodes of a machine with facets hold what is below them?
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_CONTAINMENT_H
#define SPH_TEST_CONTAINMENT_H

#include "builder/tree/box.h"
#include "build_scene.h"
#include "machine/box.h"
#include "machine/records.h"

/* ---- do the nodes of a machine of boxes hold what is below them? ---- */

/* Everything below a node lies in the node's box; how many primitives there are. */
static inline uint32_t boxes_below(const struct sph_machine *m, const struct sph_plants *plants,
                                   uint32_t line, const struct sph_box *outer) {
    const uint32_t *node = sph_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), n = 0;
    uint32_t inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t leaves = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    for (uint32_t i = 0; i < inner + leaves; i++) {
        struct sph_box box, both;
        sph_box_read(node, (int)i, &m->profile, &box);
        for (int k = 0; k < 3; k++) { /* a box in its parent's step may be the larger one */
            both.lo[k] = box.lo[k] > outer->lo[k] ? box.lo[k] : outer->lo[k];
            both.hi[k] = box.hi[k] < outer->hi[k] ? box.hi[k] : outer->hi[k];
        }
        if (i < inner) {
            n += boxes_below(m, plants, base + i, &both);
            continue;
        }
        const uint32_t *record = sph_record(m, 1, base + inner, i - inner);
        int facet = sph_field(record, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS) != SPH_SPHERE;
        uint32_t id = facet ? sph_field(record, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS)
                            : sph_field(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
        struct sph_aabb prim;
        sph_box_of(plants, id, &prim);
        for (int k = 0; k < 3; k++)
            assert_true(both.lo[k] <= prim.lo[k] && prim.hi[k] <= both.hi[k]);
        n++;
    }
    return n;
}

/* The axes that build has put the grid into. */
static inline int axes_of(const struct sph_machine *m) {
    for (int i = 0; i < 9; i++)
        if (m->rotation[i] != sph_scene_axes[i]) return SPH_AXES_CAMERA;
    return SPH_AXES_SCENE;
}

/* The same of the whole machine of a scene, whose primitives are put on the grid again. */
static inline uint32_t check_boxes(const struct sph_scene *s, const struct sph_machine *m) {
    struct sph_box all = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};
    struct sph_grid grid;
    struct sph_facets facets;
    double smallest;
    struct sph_ball *balls = malloc((s->n_spheres + 1) * sizeof *balls);
    assert_non_null(balls);
    assert_int_equal(sph_grid_fit(s, m->profile.w, axes_of(m), &grid, NULL), 0);
    uint8_t *lost = calloc((size_t)s->n_spheres + 1, 1);
    assert_non_null(lost);
    assert_int_equal(sph_grid_spheres(&grid, s, &m->profile, balls, lost, &smallest, NULL), 0);
    free(lost);
    assert_int_equal(sph_grid_facets(&grid, s, &m->profile, &facets, NULL), 0);
    struct sph_plants plants = {balls,    s->n_spheres,          &facets, &m->profile,
                                grid.eye, m->regs[SPH_REG_TREE], NULL};
    uint32_t n = boxes_below(m, &plants, (uint32_t)m->regs[SPH_REG_ROOT], &all);
    sph_facets_free(&facets);
    free(balls);
    return n;
}

/* Every corner of every leaf lies in all balls above it; counts leaves. */
struct ancestors {
    int n;
    struct sph_ball ball[SPH_STACK_DEPTH + 1];
};

static inline void check_point(const struct sph_machine *m, const struct ancestors *a,
                               const int32_t p[3], int64_t rad) {
    const struct sph_profile *prof = sph_machine_profile(m);
    int64_t k = 1ll << (prof->w - prof->fw);
    for (int up = 0; up < a->n; up++) {
        int64_t room = a->ball[up].r * k - rad, sum = 0;
        for (int i = 0; i < 3; i++)
            sum += (a->ball[up].c[i] * k - p[i]) * (a->ball[up].c[i] * k - p[i]);
        assert_true(room >= 0 && room * room >= sum);
    }
}

static inline void check_leaf(const struct sph_machine *m, uint32_t line,
                              const struct ancestors *a) {
    const uint32_t *leaf = machine_line(m, line);
    const struct sph_ball *ball = &a->ball[a->n - 1];
    int64_t half = 1ll << (sph_machine_profile(m)->fw - 1);
    int32_t v[3];
    switch (sph_field(leaf, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS)) {
    case 0:
        get_vector(leaf, SPH_LEAF_CTR_X_LSB, v);
        check_point(m, a, v, sph_field(leaf, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS));
        break;
    case SPH_TRIANGLE:
        for (int k = 0; k < 3; k++) {
            get_vector(leaf, SPH_TRIANGLE_V0_X_LSB + 72 * k, v);
            check_point(m, a, v, 0);
        }
        break;
    default:                         /* the whole grid */
        assert_in_range(a->n, 1, 2); /* of the first six */
        assert_true(!ball->c[0] && !ball->c[1] && !ball->c[2]);
        assert_true((int64_t)ball->r * ball->r >= 3 * half * half);
    }
}

static inline uint32_t check_below(const struct sph_machine *m, uint32_t line,
                                   struct ancestors *a) {
    const uint32_t *node = machine_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), leaves = 0;
    uint32_t n_inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    assert_true(a->n < SPH_STACK_DEPTH);
    for (uint32_t i = 0; i < n_inner + n_leaf; i++) {
        struct sph_ball *ball = &a->ball[a->n++];
        int lsb = (int)i * SPH_CHILD_STRIDE;
        for (int k = 0; k < 3; k++)
            ball->c[k] =
                sph_field_signed(node, lsb + SPH_CHILD_CTR_Y_LSB * k, SPH_CHILD_CTR_X_BITS);
        ball->r = (int32_t)sph_field(node, lsb + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
        ball->r -= SPH_FILTER_MARGIN;
        if (i < n_inner)
            leaves += check_below(m, base + i, a);
        else
            check_leaf(m, base + i, a), leaves++;
        a->n--;
    }
    return leaves;
}

#endif
