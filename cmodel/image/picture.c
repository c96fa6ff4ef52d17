/* picture.c - pictures of a frame's bytes; see image.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "image/bytes.h"

enum { AMPLIFY = 16 };

int sph_image_write(const char *path, const struct sph_frame *frame, int layer,
                    struct sph_error *err) {
    size_t n = 3 * sph_pixel_count(frame);
    uint8_t *rgb = malloc(n);
    if (!rgb) return sph_fail(err, "%s: no memory for the picture", path);
    for (size_t i = 0; i < n; i++)
        rgb[i] = sph_channel(frame->pixels[i / 3].colour[layer], (int)(i % 3));
    int rc = sph_bytes_write(path, frame->width, frame->height, rgb, SPH_NO_LIGHT, err);
    free(rgb);
    return rc;
}

int sph_image_write_difference(const char *path, const struct sph_frame *a,
                               const struct sph_frame *b, int layer, struct sph_error *err) {
    if (a->width != b->width || a->height != b->height)
        return sph_fail(err, "%s: frames of %dx%d and %dx%d do not stand side by side", path,
                        a->width, a->height, b->width, b->height);
    size_t w = (size_t)a->width, n = sph_pixel_count(a);
    uint8_t *rgb = malloc(9 * n);
    if (!rgb) return sph_fail(err, "%s: no memory for the picture", path);
    for (size_t i = 0; i < n; i++) {
        const struct sph_pixel *p = &a->pixels[i], *q = &b->pixels[i];
        uint8_t *left = rgb + (i / w * 3 * w + i % w) * 3;
        uint8_t *middle = left + 3 * w, *right = left + 6 * w;
        int dark = 1;
        for (int c = 0; c < 3; c++) {
            int l = sph_channel(p->colour[layer], c), m = sph_channel(q->colour[layer], c);
            int by = AMPLIFY * abs(l - m);
            left[c] = sph_linear_byte((float)l, SPH_TRANSFER_SRGB);
            middle[c] = sph_linear_byte((float)m, SPH_TRANSFER_SRGB);
            right[c] = (uint8_t)(by > 255 ? 255 : by);
            dark &= !by;
        }
        if (dark && (p->id != q->id || p->key != q->key || p->visits != q->visits ||
                     p->texture != q->texture))
            right[2] = 255;
    }
    int rc = sph_bytes_write(path, 3 * a->width, a->height, rgb, SPH_NO_LIGHT, err);
    free(rgb);
    return rc;
}
