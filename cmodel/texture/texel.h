/* texel.h - from texture coordinates to texels and their addresses      RTL: rtl/texture/rt_texel.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEXEL_H
#define SPH_TEXEL_H

#include <stdint.h>

/* Texels along one axis that surround a coordinate, and the weight of the second in 1/256. */
struct sph_axis {
    uint32_t texel[2];
    uint32_t weight; /* u0.8 */
    uint32_t nearest;
};

/* at: s19.20. size: texels of the level along the axis, 1..4096. clamp: 0 repeats, 1 stays at the
 * edge. Texel i covers i/size .. (i+1)/size; its colour stands in the middle. */
struct sph_axis sph_axis_at(int64_t at, uint32_t size, int clamp);

/* Texels of a level along an axis of `size` texels in level 0: size >> level, at least 1. */
static inline uint32_t sph_level_size(uint32_t size, int level) {
    return size >> level > 1 ? size >> level : 1;
}

enum { SPH_TILE_W = 4, SPH_TILE_H = 2 };

/* Word address of a texel behind the first word of its level, which is `width` texels wide: tiles
 * of 4 x 2 texels, one a line, row by row; inside a tile row by row too. */
static inline uint32_t sph_texel_word(uint32_t width, uint32_t x, uint32_t y) {
    uint32_t tiles = (width + SPH_TILE_W - 1) / SPH_TILE_W;
    return (y / SPH_TILE_H * tiles + x / SPH_TILE_W) * (SPH_TILE_W * SPH_TILE_H) +
           y % SPH_TILE_H * SPH_TILE_W + x % SPH_TILE_W;
}

/* Lines of a level: its last tiles may stand out over the right and the lower edge. */
static inline uint32_t sph_level_lines(uint32_t width, uint32_t height) {
    return (width + SPH_TILE_W - 1) / SPH_TILE_W * ((height + SPH_TILE_H - 1) / SPH_TILE_H);
}

#endif
