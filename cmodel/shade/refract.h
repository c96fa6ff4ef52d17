/* refract.h - where a ray goes that enters a surface or leaves it  RTL: rtl/shade/rt_refract.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Snell's law without division (docs/design/shading.md): with p the index of the side that the
 * ray comes from and q that of the other, A = d.d, N = n.n, B = d.n,
 *
 *     X = q^2 A N - p^2 (A N - B^2)         T = p N d - (p B + sqrt(X)) n
 *
 * X < 0 is total internal reflection, decided exactly.
 */
#ifndef SPH_REFRACT_H
#define SPH_REFRACT_H

#include "math/fx.h"
#include "shade/surface.h"

/* Refracts ray->dir at the surface; ray and surface as set up, WD at most SPH_REFRACT_WD. from, to:
 * index of refraction on either side, thousandths, 250..4000. 1 with the direction in out, s(WD);
 * 0 if all is reflected.
 *
 * Against the exact T of the same d, n and index the cut root is off by
 * T' - T = (sqrt(X) - root) n, less than 2^s |n| long with s = WD-W+12, and |T| = q |d| N. So the
 * angle is less than 2^s / (q |d||n|) <= 2^(s+2-2WD) / 250 = 2^(14-W-WD) / 250. PR bits of the root
 * lose less than 2^(1-PR) of it, and sqrt(X) <= q |d||n|: less than 2^(1-PR) more. Rounding to WD
 * bits moves each component by less than 1/2, of a vector of at least 2^(WD-2), or, if the largest
 * is limited, that one by less than 1, of at least 2^(WD-1) - 1: sqrt(3)/2 * 2^(2-WD). */
int sph_refract(const struct sph_profile *p, const struct sph_ray *ray, const struct sph_surface *s,
                uint32_t from, uint32_t to, int64_t out[3]);

/* X in full: its sign decides. s(4WD+25). */
sph_i128 sph_refract_disc(const struct sph_ray *ray, const struct sph_surface *s, uint32_t from,
                          uint32_t to);

#endif
