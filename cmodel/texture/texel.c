/* texel.c - see texel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "texture/texel.h"

#include "texture/coords.h"

struct sph_axis sph_axis_at(int64_t at, uint32_t size, int clamp) {
    const int64_t one = 1 << SPH_ST_FRACTION;
    if (clamp) at = at < 0 ? 0 : at >= one ? one - 1 : at;
    uint64_t inside = (uint64_t)at & (uint64_t)(one - 1);                /* u0.20 */
    uint32_t place = (uint32_t)(inside * size >> (SPH_ST_FRACTION - 8)); /* u12.8 */
    uint32_t before = (place + 128) >> 8, last = size - 1;               /* 1 too much */
    struct sph_axis axis = {.weight = (place + 128) & 255, .nearest = place >> 8};
    axis.texel[0] = before ? before - 1 : clamp ? 0 : last;
    axis.texel[1] = before <= last ? before : clamp ? last : 0;
    return axis;
}
