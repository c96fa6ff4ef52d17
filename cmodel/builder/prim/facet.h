/* facet.h - what triangles and planes share on the grid; see build.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PRIM_FACET_BUILD_H
#define SPH_PRIM_FACET_BUILD_H

#include "builder/prim/build.h"

/* Three numbers in fields of 24 bits from bit `at` on. */
static inline void sph_put_vector(uint32_t *line, int at, const int32_t v[3]) {
    for (int i = 0; i < 3; i++)
        sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB * i, SPH_LEAF_CTR_Y_BITS, (uint32_t)v[i]);
}

/* Kind, id and group of a leaf line; a kind that needs more bits has no group. */
static inline void sph_put_head(const struct sph_grid_prim *prim, uint32_t *line) {
    const uint32_t more = (1u << SPH_FACET_KIND_BITS) - 1;
    sph_field_set(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, prim->id);
    if (prim->kind >= more) {
        sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, more);
        sph_field_set(line, SPH_FACET_MORE_LSB, SPH_FACET_MORE_BITS, prim->kind - more);
        return;
    }
    sph_field_set(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, prim->facet->before);
    sph_field_set(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, prim->facet->after);
    sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, prim->kind);
}

/* As sph_prim_build.prim: the normal in place of a centre, and the kind. */
static inline void sph_put_normal(const struct sph_grid_prim *prim, uint32_t *line) {
    sph_put_vector(line, SPH_LEAF_CTR_X_LSB, prim->facet->normal);
    sph_field_set(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, prim->id);
    sph_field_set(line, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS, prim->kind);
}

/* As sph_prim_build.near. */
int sph_triangle_near(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                      const struct sph_profile *profile);
int sph_plane_near(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                   const struct sph_profile *profile);

#endif
