/* mip.h - an image and its smaller ones, as the texture unit reads them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MIP_H
#define SPH_MIP_H

#include <stddef.h>
#include <stdint.h>

#include "machine/layout.h" /* SPH_TEXTURE_LEVELS */
#include "texture/texel.h"

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

#endif
