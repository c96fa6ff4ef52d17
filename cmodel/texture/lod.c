/* lod.c - see lod.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/lod.h"

#include "math/fx.h"
#include "texture/log2_table.h"

enum { FRACTION = 8, PATH_FRACTION = 4 };

uint32_t sph_log2(uint32_t x) {
    int top = sph_bit_length(x) - 1;
    uint64_t nine = (uint64_t)x << (31 - top) >> 22; /* nine bits and the one that rounds */
    nine = (nine + 1) >> 1;                          /* 256 .. 512 */
    return ((uint32_t)top << FRACTION) + (nine == 512 ? 256 : sph_log2_table[nine & 255]);
}

uint64_t sph_path_add(const struct sph_profile *p, const struct sph_ray *ray, uint64_t key,
                      uint64_t path, int spread) {
    sph_u128 product = (sph_u128)key * ray->unit.y; /* u(W+WD+19), key * 2^(WD+16-h) / |dir| */
    int shift = p->wd + 16 - PATH_FRACTION - ray->unit.h - spread;
    sph_u128 sum = path + (sph_u128)sph_round128((sph_i128)product, shift);
    uint64_t most = (1ull << sph_path_bits(p)) - 1;
    return sum < most ? (uint64_t)sum : most;
}

int sph_spread(uint64_t path, int spread, uint32_t bend) {
    if (!path || !bend) return spread;
    int32_t halves = (int32_t)bend << (FRACTION - 1);
    int32_t curved = ((int32_t)sph_log2((uint32_t)path) - halves) >> FRACTION;
    int32_t sum = curved < spread ? spread : curved == spread ? spread + 1 : curved;
    return sum < SPH_SPREAD_MOST ? sum : SPH_SPREAD_MOST;
}

uint32_t sph_lod(uint64_t path, int32_t base, int levels) {
    if (!path) return 0;
    int32_t lod = (int32_t)sph_log2((uint32_t)path) - (PATH_FRACTION << FRACTION) - base;
    int32_t most = (levels - 1) << FRACTION;
    return (uint32_t)(lod < 0 ? 0 : lod > most ? most : lod);
}
