/* walk.h - which pixels are traced, and their rays                       RTL: rtl/pixel/rt_walk.v
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_WALK_H
#define SPH_WALK_H

#include "machine/machine.h"
#include "pixel/background.h"

/* Exact direction of the primary ray through the centre of pixel x, y; sWD. */
static inline void sph_primary_dir(const struct sph_machine *m, int x, int y, int64_t dir[3]) {
    const int32_t *r = m->regs;
    dir[0] = r[SPH_REG_DIR_X0] + (int64_t)x * r[SPH_REG_PITCH];
    dir[1] = r[SPH_REG_DIR_Y0] - (int64_t)y * r[SPH_REG_PITCH];
    dir[2] = r[SPH_REG_DIR_Z];
}

#endif
