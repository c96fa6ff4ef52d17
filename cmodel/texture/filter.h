/* filter.h - one texel from up to eight                       RTL: rtl/texture/rt_texel_filter.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Equal texels stay what they are: the weights of every step sum to 256.
 */
#ifndef SPH_TEXTURE_FILTER_H
#define SPH_TEXTURE_FILTER_H

#include <stdint.h>

/* Bilinear, of four channels of 8 bits. texel: (x, y), (x+1, y), (x, y+1), (x+1, y+1); wx, wy: u0.8
 * weights of x+1 and y+1. out: u8.8, half up. */
void sph_filter_bilinear(const uint32_t texel[4], uint32_t wx, uint32_t wy, uint32_t out[4]);

/* The two levels, u8.8 a channel, weight u0.8 of the second: a texel word, each channel half up. */
uint32_t sph_filter_levels(const uint32_t near[4], const uint32_t far[4], uint32_t weight);

/* albedo * texel / 255 to nearest; both 0..255. There are no ties. */
uint32_t sph_texture_albedo(uint32_t albedo, uint32_t texel);

#endif
