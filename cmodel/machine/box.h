/* box.h - the boxes around the children of a node (TREE_BOX4), as machine.def draws them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_MACHINE_BOX_H
#define SPH_MACHINE_BOX_H

#include "machine/machine.h"

/* Where the steps of a node's planes are counted from, grid units; log2 of a step. */
struct sph_box_frame {
    int32_t org[3];
    uint8_t step[3];
};

/* Planes of a child in steps of its node's frame: it begins at lo and ends at hi + 1. */
struct sph_box_planes {
    uint8_t lo[3], hi[3];
};

/* Grid units: a plane is lo <= coordinate or coordinate <= hi, s(W+2). */
struct sph_box {
    int32_t lo[3], hi[3];
};

enum { SPH_BOX_CODES = 1 << SPH_BOX_LO_X_BITS }; /* steps of a frame along an axis */

/* Bits of the grid that a frame's origin leaves out, and those added to its step. */
static inline int sph_frame_org_shift(const struct sph_profile *p) {
    return p->w > SPH_FRAME_ORG_X_BITS ? p->w - SPH_FRAME_ORG_X_BITS : 0;
}
static inline int sph_frame_step_shift(const struct sph_profile *p) {
    int most = (1 << SPH_FRAME_STEP_X_BITS) - 1 + SPH_BOX_LO_X_BITS;
    return p->w > most ? p->w - most : 0;
}

struct sph_box_frame sph_box_frame_read(const uint32_t *node, const struct sph_profile *p);
struct sph_box_planes sph_box_planes_read(const uint32_t *node, int child);

/* The box of child 0..3 of a node; coordinates that leave W+2 bits lose what is above. */
void sph_box_read(const uint32_t *node, int child, const struct sph_profile *p,
                  struct sph_box *box);

#endif
