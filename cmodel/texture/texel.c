/* texel.c - see texel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/texel.h"

#include "math/fx.h"
#include "texture/coords.h"

struct sph_axis sph_axis_at(int64_t at, uint32_t size, int clamp) {
    const int64_t one = 1 << SPH_ST_FRACTION;
    if (clamp) at = at < 0 ? 0 : at >= one ? one - 1 : at;
    uint64_t inside = (uint64_t)at & (uint64_t)(one - 1);                /* u0.20 */
    uint32_t place = (uint32_t)(inside * size >> (SPH_ST_FRACTION - 8)); /* u12.8 */
    uint32_t before = (place + 128) >> 8, last = size - 1;               /* 1 too much */
    struct sph_axis axis = {.weight = (place + 128) & 255, .nearest = place >> 8};
    axis.texel[0] = before ? before - 1 : clamp ? 0 : last;
    axis.texel[1] = before <= last ? before : clamp ? last : 0;
    return axis;
}

/* ---- filter ---- */

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
