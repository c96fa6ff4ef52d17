/* plain.c - of image.h and texture.h, what needs no library
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "image/image.h"
#include "image/texture.h"

/* Endings of names and what OpenImageIO calls their formats. */
static const struct {
    const char *ending, *format;
} formats[] = {{"png", "png"},  {"tif", "tiff"},  {"tiff", "tiff"},
               {"ppm", "pnm"},  {"bmp", "bmp"},   {"tga", "targa"},
               {"jpg", "jpeg"}, {"jpeg", "jpeg"}, {"exr", "openexr"}};
enum { FORMATS = sizeof formats / sizeof *formats };

const char *sph_image_format(const char *path, struct sph_error *err) {
    char endings[16 * FORMATS] = "";
    int used = 0;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const char *dot = *name ? strrchr(name + 1, '.') : NULL; /* .. is a folder */
    if (!dot) return formats[0].format;
    for (int i = 0; i < FORMATS; i++) {
        if (!strcasecmp(dot + 1, formats[i].ending)) return formats[i].format;
        used += snprintf(endings + used, sizeof endings - (size_t)used, "%s%s", i ? ", " : "",
                         formats[i].ending);
    }
    sph_fail(err, "%s: no picture is written as %s; endings are %s", path, dot, endings);
    return NULL;
}

void sph_image_free(struct sph_image *image) {
    free(image->bytes);
    *image = (struct sph_image){0};
}

void sph_linear_free(struct sph_linear *picture) {
    free(picture->rgb);
    *picture = (struct sph_linear){0};
}

void sph_mip_free(struct sph_mip *mip) {
    free(mip->texels);
    *mip = (struct sph_mip){0};
}

int sph_image_compare(const struct sph_image *a, const struct sph_image *b,
                      struct sph_image_difference *d) {
    *d = (struct sph_image_difference){.x = -1, .y = -1};
    if (a->width != b->width || a->height != b->height || a->channels != b->channels)
        return d->size_differs = 1;
    size_t at = 0;
    for (int y = 0; y < a->height; y++)
        for (int x = 0; x < a->width; x++) {
            int differs = 0;
            for (int c = 0; c < a->channels; c++, at++) {
                int by = abs(a->bytes[at] - b->bytes[at]);
                differs |= by;
                if ((uint32_t)by > d->max_byte) d->max_byte = (uint32_t)by;
            }
            if (differs && !d->pixels++) d->x = x, d->y = y;
        }
    return d->pixels != 0;
}
