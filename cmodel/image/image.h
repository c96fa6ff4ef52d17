/* image.h - pictures of frames, through OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 *
 * The C face of image.cpp. layer selects sph_pixel.colour[layer], 0 .. SPH_FRAMES-1. Every writer
 * writes its file whole or not at all and returns 0, or -1 with a message.
 */
#ifndef SPH_IMAGE_H
#define SPH_IMAGE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"
#include "core/frame.h"

/* 8-bit picture in memory: width * height * channels bytes, row 0 on top. */
struct sph_image {
    int width, height, channels;
    uint8_t *bytes;
};

/* What OpenImageIO calls the format of a picture of this name, by its ending in letters of either
 * size: png, also for a name without ending, such as a device; tiff, pnm (of .ppm), bmp, targa,
 * openexr. NULL with a message that lists the endings if it is another. */
const char *sph_image_format(const char *path, struct sph_error *err);

/* 8-bit RGB, in the format of its name, which must lose nothing: any but openexr. */
int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err);

/* The same of two frames of one size beside their difference (per byte, 16 times, at most 255; any
 * difference in id, key, visits or texture alone shows as blue): a | b | difference. */
int sph_image_write_difference(const char *path, const struct sph_frame *a,
                               const struct sph_frame *b, int layer, struct sph_error *err);

/* OpenEXR: R, G, B (float: byte / 255), id, key.hi, key.lo, visits, texture (uint). */
int sph_image_write_exr(const char *path, const struct sph_frame *frame, int layer,
                        struct sph_error *err);

/* Reads any 8-bit picture that OpenImageIO knows (deeper ones are refused); free with
 * sph_image_free. On failure there is nothing to free. */
int sph_image_read(const char *path, struct sph_image *image, struct sph_error *err);

void sph_image_free(struct sph_image *image);

struct sph_image_difference {
    int size_differs;  /* width, height or channels; then nothing else was compared */
    uint64_t pixels;   /* pixels with any channel different */
    int x, y;          /* the first of them, row by row; -1 if none */
    uint32_t max_byte; /* largest difference of one channel */
};

/* Exact comparison, size and channels first. Returns 1 if anything differs, else 0. */
int sph_image_compare(const struct sph_image *a, const struct sph_image *b,
                      struct sph_image_difference *difference);

#ifdef __cplusplus
}
#endif

#endif
