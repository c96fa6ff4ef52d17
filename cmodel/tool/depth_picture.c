/* depth_picture.c - see depth_picture.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/depth_picture.h"

#include <stdlib.h>

#include "engine/layers.h"

int depth_picture(const struct sph_frame *frame, const struct sph_trail *trails,
                  struct sph_frame *painted) {
    size_t n = (size_t)frame->width * (size_t)frame->height;
    *painted = (struct sph_frame){frame->width, frame->height, malloc(n * sizeof *frame->pixels)};
    if (!painted->pixels) return -1;
    for (size_t i = 0; i < n; i++) {
        painted->pixels[i] = frame->pixels[i];
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            painted->pixels[i].colour[layer] = sph_depth_colours[trails[i].depth];
    }
    return 0;
}
