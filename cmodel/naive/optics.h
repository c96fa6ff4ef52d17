/* optics.h - Snell's law and highlights by definition
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NAIVE_OPTICS_H
#define SPH_NAIVE_OPTICS_H

#include <stdint.h>

#include "machine/profile.h"

/* The direction behind a surface with normal n, any length, of a ray that comes along d with index
 * `from` on its side and `to` on the other. 0 if all is reflected. */
int sph_naive_refract(const struct sph_profile *p, const int64_t d[3], const int64_t n[3],
                      uint32_t from, uint32_t to, int64_t out[3]);

/* max(0, cosine of mirrored light and way back)^(power/16), u1.15, of unit vectors s1.16: normal,
 * to the light, along the ray. */
int64_t sph_naive_shine(const int64_t n[3], const int64_t l[3], const int64_t d[3], uint32_t power);

#endif
