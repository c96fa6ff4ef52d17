/* grid_point.c - points of the scene on a grid that was found; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "builder/grid/grid.h"
#include "scene/vector.h"

int sph_grid_fits(const struct sph_grid *grid, const struct sph_ball *ball) {
    int64_t lo = -(1ll << (grid->w - 1)) + SPH_GRID_MARGIN,
            hi = (1ll << (grid->w - 1)) - 1 - SPH_GRID_MARGIN;
    for (int i = 0; i < 3; i++)
        if ((int64_t)ball->c[i] - ball->r < lo || (int64_t)ball->c[i] + ball->r > hi) return 0;
    return 1;
}

void sph_grid_real(const struct sph_grid *grid, struct sph_vec p, double out[3]) {
    sph_vec_turn(grid->rotation, sph_vec_sub(p, grid->seen_from.from), out);
    for (int i = 0; i < 3; i++)
        out[i] = out[i] / grid->step + grid->eye[i];
}

void sph_grid_point(const struct sph_grid *grid, struct sph_vec p, int32_t out[3]) {
    double at[3];
    sph_vec_turn(grid->rotation, sph_vec_sub(p, grid->seen_from.from), at);
    for (int i = 0; i < 3; i++)
        out[i] = (int32_t)lround(at[i] / grid->step) + grid->eye[i];
}

struct sph_ball sph_grid_ball(const struct sph_grid *grid, const struct sph_sphere *sphere) {
    struct sph_ball ball;
    sph_grid_point(grid, sphere->ctr, ball.c);
    ball.r = (int32_t)lround(sphere->rad / grid->step);
    return ball;
}

double sph_grid_off(const struct sph_grid *grid, struct sph_vec p) {
    double at[3], off = 0;
    sph_vec_turn(grid->rotation, sph_vec_sub(p, grid->seen_from.from), at);
    for (int i = 0; i < 3; i++) {
        double by = at[i] - round(at[i] / grid->step) * grid->step;
        off += by * by;
    }
    return sqrt(off);
}
