/* tile.h - the pixels of a tile, their primary and shadow rays set up together or in packets
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_TILE_H
#define SPH_FAST_TILE_H

#include "engine/render_pixel.h"
#include "fast/packet.h"

enum { SPH_TILE = 8 }; /* pixels along a side */

/* Pixel i of a tile, so that those that follow one another are neighbours: 4x4 after 4x4. */
static inline int sph_tile_x(int i) {
    return (i & 3) | (i >> 2 & 4);
}

static inline int sph_tile_y(int i) {
    return (i >> 2 & 3) | (i >> 3 & 4);
}

/* 1 if sph_fast_tile() draws the machine in packets: sph_fast_shades(), without FIRST, and packets
 * fit. */
int sph_fast_tiles(const struct sph_machine *m, const struct sph_fast *fast);

/* Draws the pixels x0 .. x1-1, y0 .. y1-1, at most a tile, into the frame as sph_fast_pixel() does
 * of a machine that sph_fast_shades() knows; in packets visits and what counters tell of the
 * tree's work mean nothing. */
void sph_fast_tile(const struct sph_machine *m, const struct sph_render_options *o, int packets,
                   int x0, int y0, int x1, int y1, struct sph_frame *frame, struct sph_counters *c,
                   uint32_t *errors);

#endif
