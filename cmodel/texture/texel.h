/* texel.h - from texture coordinates to texels and their addresses
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEXEL_H
#define SPH_TEXEL_H

#include <stddef.h>
#include <stdint.h>

#include "machine/layout.h" /* SPH_TEXTURE_LEVELS */

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

/* ---- an image and its smaller ones, as the texture unit reads them ---- */

/* How an image's bytes stand for light: as its file says, or as asked for. */
enum { SPH_COLOURS_OF_FILE, SPH_COLOURS_SRGB, SPH_COLOURS_LINEAR };

struct sph_mip {
    int width, height, levels; /* level l: sph_level_size() of both; the last is 1 x 1 */
    int decoded;               /* colours were not linear in the file: sRGB, or a gamma */
    uint32_t *texels;          /* linear, 0xAABBGGRR, level after level, row by row from the top */
};

/* Levels of an image down to one texel. */
static inline int sph_mip_levels(int width, int height) {
    int levels = 1;
    while (width >> levels || height >> levels)
        levels++;
    return levels;
}

/* Texels in front of a level; with level = mip->levels, all of them. */
static inline size_t sph_mip_at(const struct sph_mip *mip, int level) {
    size_t at = 0;
    for (int l = 0; l < level; l++)
        at += (size_t)sph_level_size((uint32_t)mip->width, l) *
              sph_level_size((uint32_t)mip->height, l);
    return at;
}

/* ---- one texel from up to eight (RTL: rtl/texture/rt_texel_filter.v) ---- */
/* Equal texels stay what they are: the weights of every step sum to 256. */

/* Bilinear, of four channels of 8 bits. texel: (x, y), (x+1, y), (x, y+1), (x+1, y+1); wx, wy: u0.8
 * weights of x+1 and y+1. out: u8.8, half up. */
void sph_filter_bilinear(const uint32_t texel[4], uint32_t wx, uint32_t wy, uint32_t out[4]);

/* The two levels, u8.8 a channel, weight u0.8 of the second: a texel word, each channel half up. */
uint32_t sph_filter_levels(const uint32_t near[4], const uint32_t far[4], uint32_t weight);

/* albedo * texel / 255 to nearest; both 0..255. There are no ties. */
uint32_t sph_texture_albedo(uint32_t albedo, uint32_t texel);

#endif
