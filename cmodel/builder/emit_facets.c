/* emit_facets.c - triangles and planes to memory words; see emit.h, machine/machine.def
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/emit.h"

/* Three numbers in fields of 24 bits from bit `at` on. */
static void put_vector(uint32_t *line, int at, const int32_t v[3]) {
    for (int i = 0; i < 3; i++)
        sph_field_set(line, at + SPH_LEAF_CTR_Y_LSB * i, SPH_LEAF_CTR_Y_BITS, (uint32_t)v[i]);
}

void sph_emit_facet(uint32_t *line, const struct sph_grid_facet *f, uint32_t id) {
    if (f->kind == SPH_PLANE) {
        put_vector(line, SPH_PLANE_P_X_LSB, f->v[0]);
        put_vector(line, SPH_PLANE_N_X_LSB, f->v[1]);
    } else {
        put_vector(line, SPH_TRIANGLE_V0_X_LSB, f->v[0]);
        put_vector(line, SPH_TRIANGLE_V1_X_LSB, f->v[1]);
        put_vector(line, SPH_TRIANGLE_V2_X_LSB, f->v[2]);
    }
    sph_field_set(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, id);
    sph_field_set(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, f->before);
    sph_field_set(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, f->after);
    sph_field_set(line, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, (uint32_t)f->kind);
}

void sph_emit_facet_prim(uint32_t *line, const struct sph_grid_facet *f, uint32_t id) {
    put_vector(line, SPH_LEAF_CTR_X_LSB, f->normal);
    sph_field_set(line, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, id);
    sph_field_set(line, SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS, (uint32_t)f->kind);
}
