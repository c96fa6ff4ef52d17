/* box.c - see box.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/box.h"

void sph_box_read(const uint32_t *node, int child, const struct sph_profile *p,
                  struct sph_box *box) {
    int at = child * SPH_BOX_STRIDE, spare = 32 - (p->w + 2);
    for (int i = 0; i < 3; i++) {
        uint32_t org = (uint32_t)sph_field_signed(
            node, SPH_FRAME_ORG_X_LSB + i * SPH_FRAME_ORG_X_BITS, SPH_FRAME_ORG_X_BITS);
        uint32_t step = sph_field(node, SPH_FRAME_STEP_X_LSB + i * SPH_FRAME_STEP_X_BITS,
                                  SPH_FRAME_STEP_X_BITS) +
                        (uint32_t)sph_frame_step_shift(p);
        uint32_t lo =
            sph_field(node, at + SPH_BOX_LO_X_LSB + i * SPH_BOX_LO_X_BITS, SPH_BOX_LO_X_BITS);
        uint32_t hi =
            sph_field(node, at + SPH_BOX_HI_X_LSB + i * SPH_BOX_HI_X_BITS, SPH_BOX_HI_X_BITS);
        org <<= sph_frame_org_shift(p);
        box->lo[i] = (int32_t)((org + (lo << step)) << spare) >> spare;
        box->hi[i] = (int32_t)((org + ((hi + 1) << step)) << spare) >> spare;
    }
}
