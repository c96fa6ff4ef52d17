/* background.h - background separation: which pixels are never traced
 * SPDX-License-Identifier: Apache-2.0
 *
 * Borodavka et al. V. Register BG_MODE chooses the way, machine.def draws the words,
 * docs/design/overview.md and docs/results/effects.md explain them.
 */
#ifndef SPH_BACKGROUND_H
#define SPH_BACKGROUND_H

#include "machine/machine.h"

/* 1 if the spans or cones that BG_MODE asks for do not lie in memory: every pixel is traced then,
 * and the frame has the sticky error BAD_NODE. */
int sph_background_missing(const struct sph_machine *m);

/* 1 if the background separation says that pixel x, y (0 .. 16383) sees no sphere. */
int sph_is_background(const struct sph_machine *m, int x, int y);

/* ---- which pixels are traced, and their rays (RTL:) ---- */

/* Direction of the primary ray through the centre of pixel x, y; sWD. Exact, but for a grid that is
 * turned: to nearest, of steps that are rounded far below that. */
static inline void sph_primary_dir(const struct sph_machine *m, int x, int y, int64_t dir[3]) {
    const int32_t *r = m->regs;
    if (sph_machine_effect(m, SPH_EFFECT_TURNED)) { /* the top WD of 32 bits */
        for (int i = 0; i < 3; i++)
            dir[i] = (int32_t)((uint32_t)r[SPH_REG_DIR_X0 + i] +
                               (uint32_t)x * (uint32_t)r[SPH_REG_ACROSS_X + i] +
                               (uint32_t)y * (uint32_t)r[SPH_REG_DOWN_X + i]) >>
                     (32 - m->profile.wd);
        return;
    }
    dir[0] = r[SPH_REG_DIR_X0] + (int64_t)x * r[SPH_REG_PITCH];
    dir[1] = r[SPH_REG_DIR_Y0] - (int64_t)y * r[SPH_REG_PITCH];
    dir[2] = r[SPH_REG_DIR_Z];
}

#endif
