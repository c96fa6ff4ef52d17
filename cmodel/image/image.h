/* image.h - pictures of frames: PNG by libpng, PPM, all else by OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 *
 * layer selects sph_pixel.colour[layer], 0 .. SPH_FRAMES-1. Every writer
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
#include "engine/layers.h"

/* lazy.c looks for these by name */
#pragma GCC visibility push(default)

/* 8-bit picture in memory: width * height * channels bytes, row 0 on top. */
struct sph_image {
    int width, height, channels;
    uint8_t *bytes;
};

/* What OpenImageIO calls the format of a picture of this name, by its ending in letters of either
 * size: png, also for a name without ending, such as a device; tiff, pnm (of .ppm), bmp, targa,
 * jpeg, openexr. NULL with a message that lists the endings if it is another. */
const char *sph_image_format(const char *path, struct sph_error *err);

/* ---- bytes as a frame has them ---- */

/* 8-bit RGB, in the format of its name, which must lose nothing: neither openexr nor jpeg. For
 * colours that are no light, such as differences and false colours. */
int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err);

/* Two frames of one size, in sRGB, beside the difference of their bytes (16 times, at most 255; any
 * difference in id, key, visits or texture alone shows as blue): a | b | difference. */
int sph_image_write_difference(const char *path, const struct sph_frame *a,
                               const struct sph_frame *b, int layer, struct sph_error *err);

/* ---- light ---- */

/* Colours in linear light, 255 is white: red, green, blue of each pixel, row 0 on top. */
struct sph_linear {
    int width, height;
    float *rgb;
};

/* How bytes stand for light: as it is; as people see it (IEC 61966-2-1). */
enum { SPH_TRANSFER_LINEAR, SPH_TRANSFER_SRGB };

struct sph_trail;

/* The light of a frame: of its trails, which have more than 8 bits, or of its bytes if trails is
 * NULL. A pixel is the mean of samples x samples of the frame's. -1 with a message if the frame's
 * sides are no multiples, or memory is out; free with sph_linear_free. */
int sph_linear_of(const struct sph_frame *frame, const struct sph_trail *trails, int layer,
                  int samples, struct sph_linear *out, struct sph_error *err);

void sph_linear_free(struct sph_linear *picture);

/* Linear light, 255 is white, as a byte in a transfer, SPH_TRANSFER_*; halves are rounded up. */
uint8_t sph_linear_byte(float light, int transfer);

/* The light as bytes in a file, in a transfer that PNG names. */
int sph_linear_write(const char *path, const struct sph_linear *picture, int transfer,
                     struct sph_error *err);

/* OpenEXR: R, G, B (float, linear, 1 is white); and if picture and frame are of one size id,
 * key.hi, key.lo, visits, texture (uint), and unless layers is NULL Z, N.X, N.Y, N.Z, albedo.R,
 * albedo.G, albedo.B, level (float) of layers.h. */
int sph_linear_write_exr(const char *path, const struct sph_linear *picture,
                         const struct sph_frame *frame, const struct sph_layer *layers,
                         struct sph_error *err);

/* ---- files ---- */

/* An animated GIF of n >= 1 picture files of one size, 8-bit RGB; of a frame 256 colours are kept.
 * rate: frames a second. */
int sph_image_write_gif(const char *path, const char *const *pictures, int n, double rate,
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

#pragma GCC visibility pop

#ifdef __cplusplus
}
#endif

#endif
