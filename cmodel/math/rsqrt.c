/* rsqrt.c - see rsqrt.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "math/rsqrt.h"

#include "math/fx.h"
#include "math/rsqrt_table.h"

uint32_t sph_rsqrt(uint32_t x) {
    uint32_t i = (x >> 10) - 64, frac = x & 1023;
    return sph_rsqrt_table[i].start - (sph_rsqrt_table[i].slope * frac >> 10);
}

struct sph_unit sph_unit(const int64_t v[3], uint64_t vv, int bits) {
    struct sph_unit r = {{0, 0, 0}, 0, 0};
    if (!vv) return r;
    r.h = (2 * bits - sph_bit_length(vv)) >> 1;
    int up = r.h > 0 ? r.h : 0, down = up - r.h;
    r.y = sph_rsqrt((uint32_t)(vv << (2 * up) >> (2 * down) >> (2 * bits - 18)));
    for (int i = 0; i < 3; i++)
        r.u[i] = (int32_t)sph_round((int64_t)((uint64_t)v[i] << up) * r.y >> down, bits);
    return r;
}
