/* kinds.c - what several kinds of primitives share; see prim.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "prim/prim.h"

#include <string.h>

struct sph_facet_leaf sph_facet_head(const uint32_t *line, int kind) {
    struct sph_facet_leaf f = {.kind = kind};
    f.id = sph_field(line, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS);
    if (kind >= (1 << SPH_FACET_KIND_BITS) - 1) return f; /* its kind stands in place of a group */
    f.before = sph_field(line, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS);
    f.after = sph_field(line, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS);
    return f;
}

int sph_facet_visit(const struct sph_ray_query *query, const struct sph_facet_leaf *facet,
                    struct sph_hit *hit) {
    const struct sph_ray *ray = query->ray;
    struct sph_facet_result r = sph_facet_test(query->p, ray, facet);
    uint64_t *divisions = &query->c->count[SPH_COUNT_DIVISIONS];
    query->c->count[SPH_COUNT_FACET_TESTS]++;
    if (!r.hit) return 0;
    uint64_t key = ray->kind == SPH_SHADOW ? 1 : sph_facet_key(ray, &r, divisions);
    *hit = (struct sph_hit){key, facet->id, r.far != 0, 0};
    return 1;
}

void sph_stored_normal(const struct sph_profile *p, const uint32_t *prim, const int64_t guarded[3],
                       int64_t normal[3]) {
    (void)p, (void)guarded;
    sph_vector_read(prim, SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS, normal);
}

int sph_on_grid(const struct sph_machine *m, const uint32_t *line, int at) {
    int64_t v[3], half = 1ll << (sph_machine_profile(m)->w - 1);
    sph_vector_read(line, at, SPH_LEAF_CTR_X_BITS, v);
    for (int i = 0; i < 3; i++)
        if (v[i] < -half || v[i] >= half) return 0;
    return 1;
}

int sph_any_bit(const uint32_t *line, int first, int last) {
    for (int bit = first; bit <= last; bit++)
        if (line[bit / 32] >> bit % 32 & 1) return 1;
    return 0;
}

int sph_validate_normal(uint32_t id, const uint32_t *prim, const int32_t normal[3],
                        struct sph_error *err) {
    for (int i = 0; i < 3; i++)
        if (sph_field_signed(prim, SPH_LEAF_CTR_X_LSB + SPH_LEAF_CTR_X_BITS * i,
                             SPH_LEAF_CTR_X_BITS) != normal[i])
            return sph_fail(err, "primitive %u: the normal is not that of its facet", id);
    if (sph_field(prim, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS) != id)
        return sph_fail(err, "primitive %u: another id", id);
    return 0;
}
