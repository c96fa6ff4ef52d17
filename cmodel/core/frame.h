/* frame.h - what a machine renders: pixels and counters, the same from model and RTL
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FRAME_H
#define SPH_FRAME_H

#include <stdint.h>

#include "machine/layout.h"

struct sph_pixel {
    uint32_t colour[SPH_FRAMES]; /* 0xBBGGRR at depth 0 (Rendering), 1 (L1), deepest (L2) */
    uint32_t id;                 /* primary hit, SPH_ID_NONE: background */
    uint32_t visits;             /* node visits of all rays of the pixel */
    uint32_t texture;            /* SPH_NO_TEXTURE, or lod and texels: docs/design/textures.md */
    uint64_t key;                /* of the primary hit, 0: none */
};

/* The word `texture` of a pixel whose rays see no textured surface. */
#define SPH_LOD_LSB 20
#define SPH_NO_TEXTURE ((uint32_t)SPH_LOD_NONE << SPH_LOD_LSB)

struct sph_frame {
    int width, height;
    struct sph_pixel *pixels; /* row by row, row 0 on top */
};

struct sph_counters {
    uint64_t count[SPH_COUNTERS]; /* SPH_COUNT_* */
};

/* 1 if counter i is the model's too, and equals the RTL's; else the RTL alone counts it. */
static inline int sph_counter_both(int i) {
    return SPH_COUNTERS_BOTH >> i & 1;
}

/* FNV-1a, 64 bits, over width, height and of every pixel colour[0..], id, visits, key: each number
 * little endian in its own width; texture, behind visits, where something is hit and textured.
 * Equal hashes stand for equal frames. */
uint64_t sph_frame_hash(const struct sph_frame *frame);

/* The same without visits, of texture only lod: what is seen, whatever the tree or the traversal.
 */
uint64_t sph_frame_picture_hash(const struct sph_frame *frame);

/* Both, in the time of one. */
struct sph_hashes {
    uint64_t frame, picture;
};
struct sph_hashes sph_frame_hashes(const struct sph_frame *frame);

void sph_frame_free(struct sph_frame *frame);

#endif
