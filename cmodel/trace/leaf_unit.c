/* leaf_unit.c - see leaf_unit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/leaf_unit.h"

#include "core/stages.h"

/* A hit that comes first replaces *best; those from inside are counted. */
static void keep_nearest(struct sph_hit *best, struct sph_hit hit) {
    sph_hit_count(best, &hit);
    if (!best->key || hit.key < best->key || (hit.key == best->key && hit.id < best->id))
        *best = hit;
}

void sph_leaf_visit(struct sph_ray_query *query, const uint32_t *record) {
    uint32_t kind = sph_record_kind(query->whole, record);
    struct sph_hit hit;
    if (!sph_prim_of(kind)->test(query, record, &hit)) return;
    if (query->passes && sph_record_clear(kind, record)) return;
    SPH_NOTE(query->ray->stages, SPH_STAGE_KEY, hit.id, (sph_i128)hit.key, hit.far);
    keep_nearest(&query->best, hit);
}
