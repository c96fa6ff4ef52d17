/* frame.h - what a machine renders: pixels and counters, the same from model and RTL
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FRAME_H
#define SPH_FRAME_H

#include <stdint.h>
#include <stdio.h>

#include "common/error.h"
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

/* ---- frames in files, to carry them from a simulator to the comparison ---- */
/*   byte 0   "SPHFRAME"
 *        8   u32 version (2), width, height, SPH_FRAMES, SPH_COUNTERS, error bits
 *       32   u64 counter[SPH_COUNTERS]
 *            per pixel, row by row: u32 colour[SPH_FRAMES], id, visits, texture; u64 key
 *            u64 FNV-1a of all bytes before it
 *
 * Everything is little endian; nothing is padded. */

/* A frame and what came with it. */
struct sph_shot {
    struct sph_frame frame;
    struct sph_counters counters;
    uint32_t errors; /* 1 << SPH_ERROR_* */
};

/* Writes path, whole or not at all. 0, or -1 with a message. */
int sph_shot_write(const struct sph_shot *shot, const char *path, struct sph_error *err);

/* Reads and checks path. 0, or -1 with a message and nothing to free; free shot->frame with
 * sph_frame_free. */
int sph_shot_read(const char *path, struct sph_shot *shot, struct sph_error *err);

/* ---- frame against frame, exactly ---- */

struct sph_frame_difference {
    int size_differs;    /* then nothing else was compared */
    uint64_t pixels;     /* pixels with any field different */
    int x, y;            /* the first of them, row by row */
    uint32_t max_colour; /* largest difference of a colour byte in any of the frames */
    uint32_t counters;   /* bit i: counter i differs; only those that both sides must have */
    uint32_t errors;     /* error bits that only one side has */
};

/* Compares size first, then every field of every pixel, counters and error bits; with
 * ignore_work neither visits, sums of texel addresses nor counters, which another tree or traversal
 * changes. Returns 1 if anything differs, else 0. */
int sph_shot_compare(const struct sph_shot *a, const struct sph_shot *b, int ignore_work,
                     struct sph_frame_difference *d);

/* Says in words what differs, the first pixel field by field. name_a and name_b head the columns.
 */
void sph_shot_explain(const struct sph_shot *a, const struct sph_shot *b,
                      const struct sph_frame_difference *d, const char *name_a, const char *name_b,
                      FILE *file);

#endif
