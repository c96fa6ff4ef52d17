/* world.c - where the grid of a machine ends in the scene; see cut.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "reference/cut.h"

int sph_on_world(const struct sph_machine *m, const double p[3]) {
    double end = ldexp(1, sph_machine_profile(m)->w - 1), step = ldexp(1, m->grid_log2);
    for (int i = 0; i < 3; i++) {
        const double *axis = &m->rotation[3 * i];
        double at = (axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2] - m->origin[i]) / step;
        if (!(at >= -end && at <= end - 1)) return 0;
    }
    return 1;
}
