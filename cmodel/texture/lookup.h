/* lookup.h - the texture unit: from a hit to the colour that multiplies the surface's
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_LOOKUP_H
#define SPH_LOOKUP_H

#include <stdint.h>

#include "machine/machine.h"
#include "texture/coords.h"

enum {
    SPH_FILTER_NEAREST, /* nearest texel of level 0 */
    SPH_FILTER_OFF,     /* bilinear, level 0 */
    SPH_FILTER_LEVEL,   /* bilinear, nearest level */
    SPH_FILTER_BETWEEN, /* trilinear */
    SPH_FILTERS
};

/* A texel as it is asked for. */
struct sph_texel {
    uint32_t image;       /* line of the header */
    uint32_t width;       /* texels of the level */
    uint32_t level, x, y; /* which */
    uint32_t word;        /* address: 8 * line + word in the line */
    uint32_t map;         /* line of the mapping record */
    int first;            /* of its lookup */
    uint32_t lod;         /* u4.8, of the lookup */
};

/* What lookups leave behind besides the colour; who listens may be NULL. */
struct sph_texture_work {
    uint64_t texels; /* fetched */
    uint32_t lod;    /* u4.8 of the first lookup, SPH_LOD_NONE: none yet */
    uint32_t words;  /* sum of the addresses of all texels fetched, modulo 2^20 */
    uint32_t errors; /* 1 << SPH_ERROR_* */
    void (*fetch)(void *user, const struct sph_texel *texel);
    void *user;
};

/* The texel, 0xAABBGGRR, at the hit `where` of a surface with a mapping record in line `map`. A
 * record, header or texel that does not lie in memory, or a header of no or too many levels, sets
 * BAD_NODE; a lookup that finds no texels is white. */
uint32_t sph_lookup(const struct sph_machine *m, uint32_t map, const struct sph_textured *where,
                    struct sph_texture_work *work);

#endif
