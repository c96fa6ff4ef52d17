/* normalise.h - one shift that fits a vector into a width             RTL: rtl/math/rt_normalise.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NORMALISE_H
#define SPH_NORMALISE_H

#include "math/fx.h"

/* Shifts v[0..2] by one common amount so that the largest component has its top magnitude bit at
 * bits-2: left exactly, or right rounding half up (a component that rounds up to 2^(bits-1) is
 * limited to 2^(bits-1)-1). A vector of only 0 and -1 is left as it is. out: s(bits). */
void sph_normalise(const sph_i128 v[3], int bits, int64_t out[3]);

#endif
