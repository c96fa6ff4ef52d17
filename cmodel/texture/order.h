/* order.h - orders in which texels could stand in lines of eight words, to be compared
 * SPDX-License-Identifier: Apache-2.0
 *
 * The machine has SPH_ORDER_TILES (texel.h); docs/design/textures.md holds the comparison.
 */
#ifndef SPH_ORDER_H
#define SPH_ORDER_H

#include <stdint.h>

enum {
    SPH_ORDER_ROWS,   /* eight texels of a row */
    SPH_ORDER_TILES,  /* tiles of 4 x 2, row by row */
    SPH_ORDER_MORTON, /* the same tiles along a Z curve; sides in tiles up to powers of two */
    SPH_ORDERS
};

/* Word of texel (x, y) of a level behind the first word of an image of width x height texels. */
uint32_t sph_order_word(int order, uint32_t width, uint32_t height, uint32_t level, uint32_t x,
                        uint32_t y);

/* Lines that the first `levels` levels of an image take. */
uint32_t sph_order_lines(int order, uint32_t width, uint32_t height, uint32_t levels);

#endif
