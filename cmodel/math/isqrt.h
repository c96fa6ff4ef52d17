/* isqrt.h - integer square root                                      RTL: rtl/math/rt_isqrt.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_ISQRT_H
#define SPH_ISQRT_H

#include "math/fx.h"

/* floor(sqrt(x)) for x < 2^124 (the remainder and two bits more must fit a word), its `bits` most
 * significant bits, from its first 1 on, with 0s behind them; bits 0: all. *inexact = (what is
 * returned squared != x). Digit by digit, two radicand bits a step. */
uint64_t sph_isqrt_bits(sph_u128 x, int bits, int *inexact);

/* Every bit of the root. */
static inline uint64_t sph_isqrt(sph_u128 x, int *inexact) {
    return sph_isqrt_bits(x, 0, inexact);
}

#endif
