/* uncut.h - compares a frame with the double reference but far beyond the grid
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_UNCUT_H
#define SPH_TEST_UNCUT_H

#include "reference/reference.h"

/* The reference was rendered with the frame's machine as its world. Pixels that see a plane far
 * beyond its grid, of which build tells, are made equal: the others show what the arithmetic costs.
 * Returns how many pixels the eye sees so. */
static inline uint64_t uncut(const struct sph_frame *frame, struct sph_reference *r) {
    uint64_t count = 0;
    for (int i = 0; i < r->width * r->height; i++) {
        if (!r->pixels[i].beyond) continue;
        count += (r->pixels[i].beyond & SPH_BEYOND_EYE) != 0;
        r->pixels[i].id = frame->pixels[i].id;
        r->pixels[i].textured = 0;
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            r->pixels[i].colour[layer] = frame->pixels[i].colour[layer];
    }
    return count;
}

#endif
