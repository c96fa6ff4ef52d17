/* smooth.h - interpolated normals of triangles                        RTL: rtl/shade/rt_smooth.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Barycentric interpolation is linear in the hit point, so a record has what is linear: the normal
 * at a point of the grid, and how it turns from there on (docs/design/shading.md).
 */
#ifndef SPH_SMOOTH_H
#define SPH_SMOOTH_H

#include "machine/machine.h"

enum {
    SPH_SMOOTH_FRACTION = 15, /* of the interpolated normal */
    SPH_SMOOTH_BITS = 20,     /* of a component of it: s4.15 */
    SPH_SMOOTH_M_STEP = SPH_SMOOTH_M_XX_BITS
};

/* n + m (guarded - b * 2^NG) * 2^-e, s4.15, limited; the difference is limited to s(W+NG). */
void sph_smooth_normal(const struct sph_profile *p, const uint32_t *record,
                       const int64_t guarded[3], int64_t normal[3]);

/* The record of a primitive's normals, NULL if it has none; of one that lies behind the end of
 * memory too, and *outside is 1. */
const uint32_t *sph_smooth_record(const struct sph_machine *m, const uint32_t *prim, int *outside);

#endif
