/* order.c - see order.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/order.h"

#include "texture/texel.h"

enum { WORDS = SPH_TILE_W * SPH_TILE_H };

static uint32_t up_to_power(uint32_t n) {
    uint32_t power = 1;
    while (power < n)
        power *= 2;
    return power;
}

/* Bits of x and y by turns, x first, as long as both sides have some; then those of the longer. */
static uint32_t morton(uint32_t x, uint32_t y, uint32_t wide, uint32_t high) {
    uint32_t at = 0, bit = 1;
    while (wide > 1 || high > 1) {
        if (wide > 1) {
            at += (x & 1) * bit;
            x >>= 1, wide >>= 1, bit <<= 1;
        }
        if (high > 1) {
            at += (y & 1) * bit;
            y >>= 1, high >>= 1, bit <<= 1;
        }
    }
    return at;
}

static uint32_t level_lines(int order, uint32_t w, uint32_t h) {
    if (order == SPH_ORDER_ROWS) return (w + WORDS - 1) / WORDS * h;
    if (order == SPH_ORDER_TILES) return sph_level_lines(w, h);
    return up_to_power((w + SPH_TILE_W - 1) / SPH_TILE_W) *
           up_to_power((h + SPH_TILE_H - 1) / SPH_TILE_H);
}

uint32_t sph_order_lines(int order, uint32_t width, uint32_t height, uint32_t levels) {
    uint32_t lines = 0;
    for (uint32_t l = 0; l < levels; l++)
        lines += level_lines(order, sph_level_size(width, (int)l), sph_level_size(height, (int)l));
    return lines;
}

uint32_t sph_order_word(int order, uint32_t width, uint32_t height, uint32_t level, uint32_t x,
                        uint32_t y) {
    uint32_t w = sph_level_size(width, (int)level), h = sph_level_size(height, (int)level);
    uint32_t first = WORDS * sph_order_lines(order, width, height, level);
    if (order == SPH_ORDER_ROWS) return first + (w + WORDS - 1) / WORDS * WORDS * y + x;
    uint32_t word = sph_texel_word(w, x, y);
    if (order == SPH_ORDER_TILES) return first + word;
    return first +
           WORDS * morton(x / SPH_TILE_W, y / SPH_TILE_H,
                          up_to_power((w + SPH_TILE_W - 1) / SPH_TILE_W),
                          up_to_power((h + SPH_TILE_H - 1) / SPH_TILE_H)) +
           word % WORDS;
}
