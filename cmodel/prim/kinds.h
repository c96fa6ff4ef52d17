/* kinds.h - the operations of each kind of primitive, and what several of them share
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PRIM_KINDS_H
#define SPH_PRIM_KINDS_H

#include "prim/facet.h"
#include "prim/prim.h"

#define SPH_PRIM_EXTERN(name) extern const struct sph_prim sph_prim_##name;
SPH_EACH_KIND(SPH_PRIM_EXTERN)

/* A vector of three fields of 24 bits from bit `at` on, w of each count. */
static inline void sph_vector_read(const uint32_t *line, int at, int w, int64_t v[3]) {
    for (int i = 0; i < 3; i++)
        v[i] = sph_field_signed(line, at + SPH_LEAF_CTR_Y_LSB * i, w);
}

/* The test of a facet whose corners, or point and normal, are read: as sph_prim.test. */
int sph_facet_visit(const struct sph_ray_query *query, const struct sph_facet_leaf *facet,
                    struct sph_hit *hit);

/* Id and group of a facet's leaf line; all of the line of a triangle, of a plane. */
struct sph_facet_leaf sph_facet_head(const uint32_t *line, int kind);
struct sph_facet_leaf sph_triangle_read(const struct sph_profile *p, const uint32_t *line);
struct sph_facet_leaf sph_plane_read(const struct sph_profile *p, const uint32_t *line);

/* The normal that a primitive record has in place of a centre: as sph_prim.normal. */
void sph_stored_normal(const struct sph_profile *p, const uint32_t *prim, const int64_t guarded[3],
                       int64_t normal[3]);

/* For sph_prim.validate: whether a vector of a line lies on the grid; whether bits first .. last
 * are 0; whether a primitive record has this normal and its id. */
int sph_on_grid(const struct sph_machine *m, const uint32_t *line, int at);
int sph_any_bit(const uint32_t *line, int first, int last);
int sph_validate_normal(uint32_t id, const uint32_t *prim, const int32_t normal[3],
                        struct sph_error *err);

#endif
