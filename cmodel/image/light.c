/* light.c - pictures of light: sums of samples, transfer curves; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>

#include "core/trail.h"
#include "image/bytes.h"

static const float white = 255;

/* IEC 61966-2-1, 1 is white. */
static float srgb(float light) {
    return light <= 0.0031308f ? 12.92f * light : 1.055f * powf(light, 1 / 2.4f) - 0.055f;
}

uint8_t sph_linear_byte(float light, int transfer) {
    if (transfer == SPH_TRANSFER_SRGB) light = white * srgb(light / white);
    return (uint8_t)floorf((light < white ? light : white) + 0.5f);
}

/* The light of a pixel's channel, u8.8: what its byte is rounded from, if that is known. */
static uint32_t light_of(const struct sph_frame *frame, const struct sph_trail *trails, size_t at,
                         int layer, int c) {
    return trails ? trails[at].sum[layer][c]
                  : 256u * sph_channel(frame->pixels[at].colour[layer], c);
}

int sph_linear_of(const struct sph_frame *frame, const struct sph_trail *trails, int layer,
                  int samples, struct sph_linear *out, struct sph_error *err) {
    if (samples < 1 || frame->width % samples || frame->height % samples)
        return sph_fail(err, "a frame of %dx%d has no whole pixels of %d x %d samples",
                        frame->width, frame->height, samples, samples);
    *out = (struct sph_linear){frame->width / samples, frame->height / samples, NULL};
    size_t w = (size_t)frame->width, n = (size_t)samples;
    size_t columns = w / n, channels = 3 * (sph_pixel_count(frame) / (n * n));
    out->rgb = malloc(channels * sizeof *out->rgb);
    if (!out->rgb)
        return sph_fail(err, "no memory for a picture of %dx%d", out->width, out->height);
    for (size_t i = 0; i < channels; i++) {
        size_t corner = i / 3 / columns * n * w + i / 3 % columns * n;
        uint64_t sum = 0;
        for (size_t k = 0; k < n * n; k++)
            sum += light_of(frame, trails, corner + k / n * w + k % n, layer, (int)(i % 3));
        double mean = (double)sum / (double)(n * n) / 256;
        out->rgb[i] = mean < white ? (float)mean : white;
    }
    return 0;
}

int sph_linear_write(const char *path, const struct sph_linear *picture, int transfer,
                     struct sph_error *err) {
    size_t n = 3 * (size_t)picture->width * (size_t)picture->height;
    uint8_t *rgb = malloc(n);
    if (!rgb) return sph_fail(err, "%s: no memory for the picture", path);
    for (size_t i = 0; i < n; i++)
        rgb[i] = sph_linear_byte(picture->rgb[i], transfer);
    int rc = sph_bytes_write(path, picture->width, picture->height, rgb, transfer, err);
    free(rgb);
    return rc;
}
