/* specular.h - highlights: Phong's cosine and its power                RTL: rtl/shade/rt_specular.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Formats and bounds: docs/design/shading.md.
 */
#ifndef SPH_SPECULAR_H
#define SPH_SPECULAR_H

#include <stdint.h>

#include "math/rsqrt.h"

/* R.V = L.D - 2 (N.L) (N.D), limited to 0..65536, u1.16: cosine between the mirror direction of the
 * light and the way back along the ray. Unit vectors of the normal, to the light, of the ray. */
uint32_t sph_specular_cosine(const struct sph_unit *normal, const struct sph_unit *to_light,
                             const struct sph_unit *dir);

/* -log2(c), u5.16, of c = 1..65536 (u1.16): by straight lines through the ends of 256 intervals, of
 * which sph_log2_table has the upper eight bits. */
uint32_t sph_specular_log2(uint32_t c);

/* c^power, u1.15 0..32768: c u1.16 up to 1, power u8.4. 2^-(power * -log2(c)). */
uint32_t sph_power(uint32_t c, uint32_t power);

#endif
