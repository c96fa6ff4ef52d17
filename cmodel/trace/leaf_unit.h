/* leaf_unit.h - exact tests of leaf records, the best hit kept        RTL: rtl/trace/rt_leaf_unit.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_LEAF_UNIT_H
#define SPH_LEAF_UNIT_H

#include "machine/records.h"
#include "prim/prim.h"

/* A query of a ray that was set up, which has hit nothing yet; c and errors are added to. */
static inline struct sph_ray_query sph_ray_query_of(const struct sph_machine *m,
                                                    const struct sph_ray *ray,
                                                    struct sph_counters *c, uint32_t *errors) {
    int passes = ray->kind == SPH_SHADOW && sph_machine_effect(m, SPH_EFFECT_CLEAR);
    return (struct sph_ray_query){sph_machine_profile(m), ray, sph_whole(m), passes,
                                  {0, SPH_ID_NONE, 0, 0}, c,   errors};
}

/* The hits from inside that there are with one more than *best has, in both. A sphere that holds
 * the origin of a ray is never pruned, so that their number hangs on no order. */
static inline void sph_hit_count(struct sph_hit *best, struct sph_hit *hit) {
    hit->fars = (int16_t)(best->fars + (hit->far && best->fars < 2));
    best->fars = hit->fars;
}

/* Tests the primitive of a leaf record; a hit that comes first replaces query->best: the smaller
 * key, then the smaller id. A record of no kind is a miss and an error. A shadow ray has key 1 for
 * any hit, and with the effect CLEAR none on what is marked as clear, though that is tested. */
void sph_leaf_visit(struct sph_ray_query *query, const uint32_t *record);

#endif
