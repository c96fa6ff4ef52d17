/* isqrt.h - integer square root                                      RTL: rtl/math/rt_isqrt.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_ISQRT_H
#define SPH_ISQRT_H

#include "math/fx.h"

/* floor(sqrt(x)) for x < 2^124 (the remainder and two bits more must fit a word); *inexact =
 * (root^2 != x). Digit by digit, two radicand bits a step. */
uint64_t sph_isqrt(sph_u128 x, int *inexact);

#endif
