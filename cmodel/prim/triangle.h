/* triangle.h - the normal that a triangle's primitive record has
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PRIM_TRIANGLE_H
#define SPH_PRIM_TRIANGLE_H

#include <stdint.h>

/* The normal of a triangle of grid points (sW, W <= 24): (v1-v0) x (v2-v0), shifted so that the
 * largest component fills 24 bits, sign included, and rounded half away from zero; what is not 0
 * stays at least 1, so that the signs are exact. 0 if the corners are on one line: no normal, no
 * area. */
int sph_triangle_normal(const int32_t (*v)[3], int32_t normal[3]);

#endif
