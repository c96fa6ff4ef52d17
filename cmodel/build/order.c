/* order.c - spheres along a Morton curve, or by z                 RTL: rtl/build/rt_build_sort.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * A key of the curve has BUILD_AXIS bits of each coordinate, counted from the least centre, of
 * which the longest axis needs all: x in the highest place, then y, z. One of the paper is z, which
 * falls. Keys are sorted by digits of BUILD_DIGIT bits, the low ones first, each pass stable.
 */
#include "build/build_tree.h"
#include "machine/layout.h"
#include "math/fx.h"

enum { DIGITS = 1 << SPH_BUILD_DIGIT, KEY_BITS = 3 * SPH_BUILD_AXIS };

static uint32_t interleaved(const uint32_t v[3]) {
    uint32_t key = 0;
    for (int bit = SPH_BUILD_AXIS - 1; bit >= 0; bit--)
        for (int i = 0; i < 3; i++)
            key = key << 1 | (v[i] >> bit & 1);
    return key;
}

void sph_bt_order(const struct sph_bt_leaf *leaves, uint32_t n, int mode,
                  const struct sph_profile *profile, uint32_t *order, uint64_t *spare) {
    int32_t lo[3] = {INT32_MAX, INT32_MAX, INT32_MAX}, hi[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    for (uint32_t id = 0; id < n; id++)
        for (int i = 0; i < 3; i++) {
            if (leaves[id].ctr[i] < lo[i]) lo[i] = leaves[id].ctr[i];
            if (leaves[id].ctr[i] > hi[i]) hi[i] = leaves[id].ctr[i];
        }
    uint32_t extents = 0; /* the length of their OR is that of the longest */
    for (int i = 0; n && i < 3; i++)
        extents |= (uint32_t)(hi[i] - lo[i]);
    int shift = sph_bit_length(extents) - SPH_BUILD_AXIS;
    if (shift < 0) shift = 0;

    uint64_t *from = spare, *to = spare + n;
    for (uint32_t id = 0; id < n; id++) {
        uint32_t v[3];
        for (int i = 0; i < 3; i++)
            v[i] = (uint32_t)(leaves[id].ctr[i] - lo[i]) >> shift;
        uint32_t falling = (uint32_t)((1 << (profile->w - 1)) - 1 - leaves[id].ctr[2]);
        from[id] = (uint64_t)(mode == SPH_BUILD_PAPER ? falling : interleaved(v)) << 32 | id;
    }
    for (int low = 0; low < KEY_BITS; low += SPH_BUILD_DIGIT) {
        uint32_t place[DIGITS] = {0}, sum = 0;
        for (uint32_t i = 0; i < n; i++)
            place[from[i] >> (32 + low) & (DIGITS - 1)]++;
        for (int d = 0; d < DIGITS; d++) {
            uint32_t here = place[d];
            place[d] = sum, sum += here;
        }
        for (uint32_t i = 0; i < n; i++)
            to[place[from[i] >> (32 + low) & (DIGITS - 1)]++] = from[i];
        uint64_t *swap = from;
        from = to, to = swap;
    }
    for (uint32_t i = 0; i < n; i++)
        order[i] = (uint32_t)from[i];
}
