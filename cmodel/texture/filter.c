/* filter.c - see filter.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/filter.h"

#include "math/fx.h"

static int64_t channel(uint32_t texel, int c) {
    return texel >> (8 * c) & 255;
}

/* a + (b - a) * weight / 256, times 256: exact. */
static int64_t between(int64_t a, int64_t b, uint32_t weight) {
    return a * 256 + (b - a) * (int64_t)weight;
}

void sph_filter_bilinear(const uint32_t texel[4], uint32_t wx, uint32_t wy, uint32_t out[4]) {
    for (int c = 0; c < 4; c++) {
        int64_t upper = between(channel(texel[0], c), channel(texel[1], c), wx); /* u8.8 */
        int64_t lower = between(channel(texel[2], c), channel(texel[3], c), wx);
        out[c] = (uint32_t)sph_round(between(upper, lower, wy), 8); /* u8.16 before */
    }
}

uint32_t sph_filter_levels(const uint32_t near[4], const uint32_t far[4], uint32_t weight) {
    uint32_t texel = 0;
    for (int c = 0; c < 4; c++)
        texel |= (uint32_t)sph_round(between(near[c], far[c], weight), 16) << (8 * c);
    return texel;
}

uint32_t sph_texture_albedo(uint32_t albedo, uint32_t texel) {
    return (albedo * texel + 127) / 255;
}
