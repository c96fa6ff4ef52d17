/* node.h - reads the words of a tree node                        layout: machine/machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NODE_H
#define SPH_NODE_H

#include "machine/machine.h"
#include "trace/facet.h"
#include "trace/filter.h"
#include "trace/leaf.h"

/* A leaf record of a line; the low w bits of each number count, as in the RTL. */
static inline struct sph_leaf sph_leaf_read(const uint32_t *line, int half, int w) {
    int at = half * SPH_LEAF_STRIDE;
    return (struct sph_leaf){{sph_field_signed(line, at + SPH_LEAF_CTR_X_LSB, w),
                              sph_field_signed(line, at + SPH_LEAF_CTR_Y_LSB, w),
                              sph_field_signed(line, at + SPH_LEAF_CTR_Z_LSB, w)},
                             sph_field(line, at + SPH_LEAF_RAD_LSB, w),
                             sph_field(line, at + SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS)};
}

/* A vector of three fields of 24 bits from bit `at` on, w of each count. */
static inline void sph_vector_read(const uint32_t *line, int at, int w, int64_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = sph_field_signed(line, at + 24 * i, w);
}

/* What a leaf line of a machine with FACETS holds: 0 a sphere, SPH_TRIANGLE, SPH_PLANE; 3: no
 * kind, which traversal refuses. */
static inline int sph_leaf_kind(const uint32_t *line) {
    return (int)sph_field(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS);
}

static inline struct sph_facet_leaf sph_facet_read(const uint32_t *line, int w) {
    struct sph_facet_leaf f = {
        .kind = sph_leaf_kind(line) == SPH_TRIANGLE ? SPH_TRIANGLE : SPH_PLANE,
        .id = sph_field(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS),
        .before = sph_field(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS),
        .after = sph_field(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS)};
    if (f.kind == SPH_PLANE) {
        sph_vector_read(line, SPH_PLANE_P_X_LSB, w, f.v[0]);
        sph_vector_read(line, SPH_PLANE_N_X_LSB, SPH_PLANE_N_X_BITS, f.v[1]);
    } else {
        sph_vector_read(line, SPH_TRIANGLE_V0_X_LSB, w, f.v[0]);
        sph_vector_read(line, SPH_TRIANGLE_V1_X_LSB, w, f.v[1]);
        sph_vector_read(line, SPH_TRIANGLE_V2_X_LSB, w, f.v[2]);
    }
    return f;
}

static inline struct sph_child sph_child_read(const uint32_t *line, int i) {
    int at = i * SPH_CHILD_STRIDE;
    return (struct sph_child){
        {sph_field_signed(line, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Y_LSB, SPH_CHILD_CTR_Y_BITS),
         sph_field_signed(line, at + SPH_CHILD_CTR_Z_LSB, SPH_CHILD_CTR_Z_BITS)},
        (int32_t)sph_field(line, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS)};
}

#endif
