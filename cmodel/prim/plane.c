/* plane.c - a plane behind the interface of primitives; see prim.h
 * SPDX-License-Identifier: Apache-2.0                                    RTL: rtl/prim/rt_facet.v
 */
#include "prim/prim.h"

struct sph_facet_leaf sph_plane_read(const struct sph_profile *p, const uint32_t *line) {
    struct sph_facet_leaf f = sph_facet_head(line, SPH_PLANE);
    sph_vector_read(line, SPH_PLANE_P_X_LSB, p->w, f.v[0]);
    sph_vector_read(line, SPH_PLANE_N_X_LSB, SPH_PLANE_N_X_BITS, f.v[1]);
    return f;
}

static int test(const struct sph_ray_query *query, const uint32_t *record, struct sph_hit *hit) {
    struct sph_facet_leaf f = sph_plane_read(query->p, record);
    return sph_facet_visit(query, &f, hit);
}

static int validate(const struct sph_machine *m, uint32_t line, const uint32_t *record, uint32_t id,
                    const uint32_t *prim, struct sph_error *err) {
    const int end = SPH_PLANE_N_Z_LSB + SPH_PLANE_N_Z_BITS;
    int32_t normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = sph_field_signed(record, SPH_PLANE_N_X_LSB + SPH_PLANE_N_X_BITS * i,
                                     SPH_PLANE_N_X_BITS);
    if (!sph_on_grid(m, record, SPH_PLANE_P_X_LSB))
        return sph_fail(err, "line %u: the point of the plane is not on the grid", line);
    if (!normal[0] && !normal[1] && !normal[2])
        return sph_fail(err, "line %u: the normal of the plane is zero", line);
    for (int i = 0; i < 3; i++) /* it is turned where it looks along a ray */
        if (normal[i] == -(1 << (SPH_PLANE_N_X_BITS - 1)))
            return sph_fail(err, "line %u: the normal of the plane cannot be turned", line);
    if (sph_any_bit(record, end, SPH_FACET_ID_LSB - 1) ||
        sph_any_bit(record, SPH_FACET_BEFORE_LSB, SPH_FACET_CLEAR_LSB - 1) ||
        sph_any_bit(record, SPH_FACET_AFTER_LSB, SPH_FACET_KIND_LSB - 1))
        return sph_fail(err, "line %u: bits of the plane that must be 0 are not", line);
    return sph_validate_normal(id, prim, normal, err);
}

const struct sph_prim sph_prim_plane = {1, test, sph_stored_normal, validate, sph_plane_read};
