/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/box.h"

struct sph_box_frame sph_box_frame_read(const uint32_t *node, const struct sph_profile *p) {
    struct sph_box_frame f;
    for (int i = 0; i < 3; i++) {
        f.org[i] = sph_field_signed(node, SPH_FRAME_ORG_X_LSB + i * SPH_FRAME_ORG_X_BITS,
                                    SPH_FRAME_ORG_X_BITS) *
                   (1 << sph_frame_org_shift(p));
        f.step[i] = (uint8_t)((int)sph_field(node, SPH_FRAME_STEP_X_LSB + i * SPH_FRAME_STEP_X_BITS,
                                             SPH_FRAME_STEP_X_BITS) +
                              sph_frame_step_shift(p));
    }
    return f;
}

struct sph_box_planes sph_box_planes_read(const uint32_t *node, int child) {
    struct sph_box_planes planes;
    int at = child * SPH_BOX_STRIDE;
    for (int i = 0; i < 3; i++) {
        planes.lo[i] = (uint8_t)sph_field(node, at + SPH_BOX_LO_X_LSB + i * SPH_BOX_LO_X_BITS,
                                          SPH_BOX_LO_X_BITS);
        planes.hi[i] = (uint8_t)sph_field(node, at + SPH_BOX_HI_X_LSB + i * SPH_BOX_HI_X_BITS,
                                          SPH_BOX_HI_X_BITS);
    }
    return planes;
}

void sph_box_read(const uint32_t *node, int child, const struct sph_profile *p,
                  struct sph_box *box) {
    struct sph_box_frame f = sph_box_frame_read(node, p);
    struct sph_box_planes planes = sph_box_planes_read(node, child);
    int spare = 32 - (p->w + 2);
    for (int i = 0; i < 3; i++) {
        uint32_t org = (uint32_t)f.org[i], lo = planes.lo[i], hi = planes.hi[i] + 1u;
        box->lo[i] = (int32_t)((org + (lo << f.step[i])) << spare) >> spare;
        box->hi[i] = (int32_t)((org + (hi << f.step[i])) << spare) >> spare;
    }
}
