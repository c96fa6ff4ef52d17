/* camera.c - see camera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/camera.h"

#include <math.h>
#include <stddef.h>

/* A step of the raster as an axis; its length. */
static double axis(const int32_t step[3], double sign, double out[3]) {
    double length =
        sqrt((double)step[0] * step[0] + (double)step[1] * step[1] + (double)step[2] * step[2]);
    for (int i = 0; i < 3; i++)
        out[i] = sign * step[i] / length;
    return length;
}

struct sph_machine_camera sph_machine_camera(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    struct sph_machine_camera c = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   -(double)r[SPH_REG_DIR_Z] / r[SPH_REG_PITCH],
                                   {-(double)r[SPH_REG_DIR_X0] / r[SPH_REG_PITCH],
                                    (double)r[SPH_REG_DIR_Y0] / r[SPH_REG_PITCH]}};
    if (!sph_machine_effect(m, SPH_EFFECT_TURNED)) return c;
    double pitch = axis(r + SPH_REG_ACROSS_X, 1, c.axes[0]), along = 0;
    double half = ldexp(1, 31 - m->profile.wd); /* of a unit, by which directions are rounded */
    axis(r + SPH_REG_DOWN_X, -1, c.axes[1]);
    c.view[0] = c.view[1] = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        c.axes[2][i] = c.axes[0][j] * c.axes[1][k] - c.axes[0][k] * c.axes[1][j];
        along += c.axes[2][i] * ((double)r[SPH_REG_DIR_X0 + i] - half);
        for (int a = 0; a < 2; a++) /* pixels are square */
            c.view[a] +=
                (a ? 1 : -1) * c.axes[a][i] * ((double)r[SPH_REG_DIR_X0 + i] - half) / pitch;
    }
    c.screen = -along / pitch;
    return c;
}

double sph_camera_ahead(const struct sph_machine_camera *camera, const int64_t dir[3]) {
    const double *back = camera->axes[2];
    return -(back[0] * (double)dir[0] + back[1] * (double)dir[1] + back[2] * (double)dir[2]);
}

/* RTL: rtl/core/rt_registers.v */
int32_t sph_camera_sum(const struct sph_machine *m) {
    const int wd = m->profile.wd, dir = sph_machine_effect(m, SPH_EFFECT_TURNED) ? 32 : wd;
    const struct {
        int first, n, bits;
    } parts[] = {{SPH_REG_EYE_X, 3, m->profile.w},
                 {SPH_REG_DIR_X0, 3, dir},
                 {SPH_REG_PITCH, 1, wd},
                 {SPH_REG_ACROSS_X, 6, 32}};
    uint32_t sum = 0;
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        for (int i = 0, unused = 32 - parts[p].bits; i < parts[p].n; i++) {
            uint32_t word = (uint32_t)m->regs[parts[p].first + i] << unused >> unused;
            sum = (sum << SPH_CAMERA_TURN | sum >> (32 - SPH_CAMERA_TURN)) ^ word;
        }
    return (int32_t)sum;
}

int sph_camera_strayed(const struct sph_machine *m) {
    return sph_machine_effect(m, SPH_EFFECT_CAMERA) &&
           m->regs[SPH_REG_ONE_CAMERA] != sph_camera_sum(m);
}
