/* bytes.h - writing of 8-bit pictures, for the sources of this folder
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_IMAGE_BYTES_H
#define SPH_IMAGE_BYTES_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"
#include "image/image.h"

enum { SPH_NO_LIGHT = -1 }; /* beside SPH_TRANSFER_*: of bytes that stand for no light */

/* Bytes, RGB, row 0 on top, into a file of the format of its name, whole or not at all; PNG names
 * the transfer, SPH_TRANSFER_* or SPH_NO_LIGHT. 0, or -1 with a message. */
int sph_bytes_write(const char *path, int width, int height, const uint8_t *rgb, int transfer,
                    struct sph_error *err);

/* The same in a format that is neither PNG nor PPM, by OpenImageIO; lazy.c looks for it. */
__attribute__((visibility("default"))) int sph_bytes_write_other(const char *path,
                                                                 const char *format, int width,
                                                                 int height, const uint8_t *rgb,
                                                                 struct sph_error *err);

/* The same as PNG, by libpng, into an open file, whose own state tells of failed writes. */
int sph_png_write(FILE *file, const char *path, int width, int height, const uint8_t *rgb,
                  int transfer, struct sph_error *err);

static inline uint8_t sph_channel(uint32_t colour, int c) {
    return (uint8_t)(colour >> 8 * c & 255);
}

static inline size_t sph_pixel_count(const struct sph_frame *frame) {
    return (size_t)frame->width * (size_t)frame->height;
}

#ifdef __cplusplus
}
#endif

#endif
