/* prim.h - what the model asks of a primitive, of whatever kind it is
 * SPDX-License-Identifier: Apache-2.0
 *
 * Kinds stand in machine.def; prim/NAME.c has the operations of each. What build asks of it stands
 * in solid.h.
 */
#ifndef SPH_PRIM_H
#define SPH_PRIM_H

#include "core/frame.h"
#include "core/ray.h"
#include "machine/machine.h"
#include "machine/records.h"
#include "prim/facet.h"

/* A ray on its way through leaf records, and what it has found. */
struct sph_ray_query {
    const struct sph_profile *p;
    const struct sph_ray *ray;
    int whole;  /* each leaf record has a line: the machine has FACETS */
    int passes; /* what is clear is no hit: a shadow ray of a machine with CLEAR */
    struct sph_hit best;
    struct sph_counters *c;
    uint32_t *errors; /* sticky */
};

struct sph_prim {
    /* Flat: rays that leave it start in front of its plane, not at the nearest point of the grid.
     */
    int flat;
    /* The exact test of the ray with a leaf record: 1 with key (of a shadow ray 1), id and side of
     * a hit, 0 for a miss. Counts its work. */
    int (*test)(const struct sph_ray_query *query, const uint32_t *record, struct sph_hit *hit);
    /* From the primitive record and the point with its guard bits: a vector along the normal, of
     * any length, outwards or to the front. */
    void (*normal)(const struct sph_profile *p, const uint32_t *prim, const int64_t guarded[3],
                   int64_t normal[3]);
    /* Checks leaf record and primitive record `prim` of primitive id, of which it is known that
     * both are of this kind. 0, or -1 with a message; line: of the leaf record, for messages. */
    int (*validate)(const struct sph_machine *m, uint32_t line, const uint32_t *record, uint32_t id,
                    const uint32_t *prim, struct sph_error *err);
    /* The facet of a leaf record; null of a kind that has none. */
    struct sph_facet_leaf (*facet)(const struct sph_profile *p, const uint32_t *record);
};

/* The operations of a kind, SPH_SPHERE and so on; of a number that no kind has: an error for each
 * test, and the normal that the record has. */
const struct sph_prim *sph_prim_of(uint32_t kind);

/* ---- the operations of each kind of primitive, and what several of them share ---- */

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
