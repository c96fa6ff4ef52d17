/* prim.c - see prim.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "prim/prim.h"

#define KIND(name) &sph_prim_##name,
static const struct sph_prim *const kinds[SPH_KINDS] = {SPH_EACH_KIND(KIND)};

static int test_nothing(const struct sph_ray_query *query, const uint32_t *record,
                        struct sph_hit *hit) {
    (void)record, (void)hit;
    *query->errors |= 1u << SPH_ERROR_BAD_NODE;
    return 0;
}

const struct sph_prim *sph_prim_of(uint32_t kind) {
    static const struct sph_prim none = {
        .flat = 1, .test = test_nothing, .normal = sph_stored_normal};
    return kind < SPH_KINDS ? kinds[kind] : &none;
}
