/* colour.c - see colour.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "shade/colour.h"

#include "math/fx.h"

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
