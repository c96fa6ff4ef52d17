/* colour.c - see colour.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/colour.h"

#include "math/fx.h"
#include "shade/power_table.h"
#include "texture/log2_table.h"

uint32_t sph_lambert(const struct sph_unit *normal, const struct sph_unit *to_light) {
    int64_t dot = 0; /* s2.32 */
    for (int i = 0; i < 3; i++)
        dot += (int64_t)normal->u[i] * to_light->u[i];
    int64_t cosine = sph_round(dot, 17);
    return cosine < 0 ? 0 : cosine > 32768 ? 32768 : (uint32_t)cosine;
}

uint32_t sph_light_add(uint32_t sum, uint32_t cosine, uint32_t intensity) {
    uint32_t r = sum + (uint32_t)sph_round((int64_t)cosine * intensity, 15);
    return r < 131071 ? r : 131071;
}

uint32_t sph_surface_colour(uint32_t albedo, uint32_t light) {
    uint32_t r = (uint32_t)sph_round((int64_t)albedo * light, 7);
    return r < 65280 ? r : 65280;
}

uint32_t sph_share(uint32_t weight, uint32_t part) {
    return (uint32_t)sph_round((int64_t)weight * part, 8);
}

void sph_shares_add(struct sph_shares *s, int depth, uint32_t whole, uint32_t own,
                    const uint32_t colour[3]) {
    for (int f = 0; f < SPH_FRAMES; f++) {
        if (f < depth && f < SPH_FRAMES - 1) continue;
        uint32_t share = f == depth && f < SPH_FRAMES - 1 ? whole : own;
        for (int i = 0; i < 3; i++) {
            uint32_t sum = s->sum[f][i] + (uint32_t)sph_round((int64_t)share * colour[i], 16);
            s->sum[f][i] = sum < 65535 ? sum : 65535;
        }
    }
}

uint32_t sph_shares_colour(const struct sph_shares *s, int frame) {
    uint32_t pixel = 0;
    for (int i = 0; i < 3; i++) {
        uint32_t byte = (uint32_t)sph_round(s->sum[frame][i], 8);
        pixel |= (byte < 255 ? byte : 255) << (8 * i);
    }
    return pixel;
}

void sph_blend_start(struct sph_blend *b) {
    *b = (struct sph_blend){{0, 0, 0}, 1u << 16, 0, {0}};
}

void sph_blend_add(struct sph_blend *b, const uint32_t colour[3], uint32_t kr, int last) {
    uint32_t pixel = 0;
    uint32_t front = (uint32_t)sph_round((int64_t)b->weight * (256 - kr), 8); /* u1.16 */
    for (int i = 0; i < 3; i++) {
        uint32_t all = b->sum[i] + (uint32_t)sph_round((int64_t)b->weight * colour[i], 16);
        uint32_t byte = (uint32_t)sph_round(all, 8);
        pixel |= (byte < 255 ? byte : 255) << (8 * i);
        b->sum[i] += (uint32_t)sph_round((int64_t)front * colour[i], 16);
    }
    int frame = b->depth < SPH_FRAMES - 1 ? b->depth : SPH_FRAMES - 1;
    for (int i = frame; i < SPH_FRAMES; i++)
        if (i == frame || last) b->colour[i] = pixel;
    b->weight = (uint32_t)sph_round((int64_t)b->weight * kr, 8);
    b->depth++;
}

/* ---- specular ---- */

enum { COSINE_ONE = 1 << 16, POWER_FRACTION = 4 };

static int64_t unit_dot(const struct sph_unit *a, const struct sph_unit *b) {
    int64_t sum = 0; /* s2.32 */
    for (int i = 0; i < 3; i++)
        sum += (int64_t)a->u[i] * b->u[i];
    return sum;
}

uint32_t sph_specular_cosine(const struct sph_unit *normal, const struct sph_unit *to_light,
                             const struct sph_unit *dir) {
    int64_t nl = sph_round(unit_dot(normal, to_light), 16),
            nd = sph_round(unit_dot(normal, dir), 16);
    int64_t c = sph_round(unit_dot(to_light, dir) - 2 * nl * nd, 16);
    return c < 0 ? 0 : c > COSINE_ONE ? COSINE_ONE : (uint32_t)c;
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
