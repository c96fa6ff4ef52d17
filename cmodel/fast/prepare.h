/* prepare.h - set-up of many rays
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_PREPARE_H
#define SPH_FAST_PREPARE_H

#include "fast/fast.h"
#include "fast/setup.h"

enum { SPH_TOGETHER = 8 }; /* rays that are made ready before one of them goes through the tree */

/* sph_fast_prepare() of n rays. */
void sph_fast_prepare_all(const struct sph_fast *fast, struct sph_ray *rays, int n);

/* The same, four at once with AVX2. NULL where the compiler knows none. */
extern void (*const sph_fast_prepare_avx2)(const struct sph_profile *p, struct sph_ray *rays,
                                           int n);

#endif
