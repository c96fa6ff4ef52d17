/* specular.c - see specular.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/specular.h"

#include "math/fx.h"
#include "shade/power_table.h"
#include "texture/log2_table.h"

enum { ONE = 1 << 16, POWER_FRACTION = 4 };

static int64_t dot(const struct sph_unit *a, const struct sph_unit *b) {
    int64_t sum = 0; /* s2.32 */
    for (int i = 0; i < 3; i++)
        sum += (int64_t)a->u[i] * b->u[i];
    return sum;
}

uint32_t sph_specular_cosine(const struct sph_unit *normal, const struct sph_unit *to_light,
                             const struct sph_unit *dir) {
    int64_t nl = sph_round(dot(normal, to_light), 16), nd = sph_round(dot(normal, dir), 16);
    int64_t c = sph_round(dot(to_light, dir) - 2 * nl * nd, 16);
    return c < 0 ? 0 : c > ONE ? ONE : (uint32_t)c;
}

uint32_t sph_specular_log2(uint32_t c) {
    int z = 17 - sph_bit_length(c);
    uint32_t x = c << z, i = x >> 8 & 255, f = x & 255; /* x: u1.16, 1 or more */
    uint32_t start = (uint32_t)(256 * sph_log2_table[i] + sph_log2_line[i].low);
    return ((uint32_t)z << 16) - start - (sph_log2_line[i].slope * f >> 8);
}

uint32_t sph_power(uint32_t c, uint32_t power) {
    if (!c) return 0;
    uint64_t e = (uint64_t)power * sph_specular_log2(c) >> POWER_FRACTION; /* u13.16 */
    uint32_t whole = (uint32_t)(e >> 16), i = (uint32_t)e >> 8 & 255, f = (uint32_t)e & 255;
    if (whole > 16) return 0;
    uint32_t y = sph_exp2_line[i].start - (sph_exp2_line[i].slope * f >> 8); /* u1.16 */
    return (uint32_t)sph_round(y, (int)whole + 1);
}
