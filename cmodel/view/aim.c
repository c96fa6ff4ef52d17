/* aim.c - see aim.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/aim.h"

#include <math.h>

#include "builder/build.h"
#include "builder/grid/grid.h"
#include "scene/vector.h"

struct view_aim view_aim_own(const struct sph_machine *m) {
    struct view_aim aim = {0};
    aim.view.width = m->regs[SPH_REG_FRAME_W];
    aim.view.height = m->regs[SPH_REG_FRAME_H];
    return aim;
}

int view_aim_at(const struct sph_machine *m, const struct sph_camera *camera,
                struct view_aim *aim) {
    double from[3], most = ldexp(1, m->profile.w - 1) - SPH_GRID_MARGIN;
    *aim = view_aim_own(m);
    if (!sph_ref_view_of(camera, aim->view.width, aim->view.height, &aim->view)) return -1;
    sph_vec_turn(m->rotation, camera->from, from);
    for (int i = 0; i < 3; i++) {
        double at = round(ldexp(from[i] - m->origin[i], -m->grid_log2));
        if (!(fabs(at) < most)) return -1;
        aim->eye[i] = (int32_t)at;
        for (int k = 0; k < 3; k++) {
            const double *axis = aim->view.axes[k];
            aim->rows[i][k] = m->rotation[3 * i] * axis[0] + m->rotation[3 * i + 1] * axis[1] +
                              m->rotation[3 * i + 2] * axis[2];
        }
    }
    aim->turned = 1;
    return 0;
}

void view_aim_start(const struct sph_machine *m, const struct view_aim *aim,
                    struct sph_machine *copy) {
    *copy = *m;
    if (!aim->turned) return;
    for (int i = 0; i < 3; i++)
        copy->regs[SPH_REG_EYE_X + i] = aim->eye[i];
    copy->regs[SPH_REG_PITCH] = 0;
    copy->regs[SPH_REG_BG_MODE] = SPH_BG_NONE;
    copy->regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_INSIDE;
    copy->regs[SPH_REG_EFFECTS] &= ~(1 << SPH_EFFECT_TURNED);
}

void view_aim_pixel(const struct view_aim *aim, int x, int y, struct sph_machine *copy) {
    static const int regs[] = {SPH_REG_DIR_X0, SPH_REG_DIR_Y0, SPH_REG_DIR_Z};
    if (!aim->turned) return;
    const struct sph_window *w = &aim->view.window;
    double d[3] = {w->left + x, w->top - y, -w->screen};
    double dir[3], most = 0;
    for (int i = 0; i < 3; i++) {
        dir[i] = aim->rows[i][0] * d[0] + aim->rows[i][1] * d[1] + aim->rows[i][2] * d[2];
        most = fmax(most, fabs(dir[i]));
    }
    double scale = (ldexp(1, copy->profile.wd - 1) - 1) / most; /* the longest that fits */
    for (int i = 0; i < 3; i++)
        copy->regs[regs[i]] = (int32_t)lround(dir[i] * scale);
}
