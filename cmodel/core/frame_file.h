/* frame_file.h - frames in files, to carry them from a simulator to the comparison
 * SPDX-License-Identifier: Apache-2.0
 *
 *   byte 0   "SPHFRAME"
 *        8   u32 version (2), width, height, SPH_FRAMES, SPH_COUNTERS, error bits
 *       32   u64 counter[SPH_COUNTERS]
 *            per pixel, row by row: u32 colour[SPH_FRAMES], id, visits, texture; u64 key
 *            u64 FNV-1a of all bytes before it
 *
 * Everything is little endian; nothing is padded.
 */
#ifndef SPH_FRAME_FILE_H
#define SPH_FRAME_FILE_H

#include "common/error.h"
#include "core/frame.h"

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

#endif
