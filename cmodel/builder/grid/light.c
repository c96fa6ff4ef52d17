/* light.c - see light.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/light.h"

#include <math.h>
#include <stdlib.h>

#include "builder/effects/effects.h"
#include "math/fx.h"

enum { LONGEST = (1 << SPH_LIGHT_SHIFT_BITS) - 1 };

/* Whether v = L - round(P / 2^shift) fits W + 1 bits for every P of the grid. */
static int word(const double at[3], int w, int shift, int32_t out[3]) {
    int64_t most = (1ll << w) - 2 - sph_round(1ll << (w - 1), shift);
    for (int i = 0; i < 3; i++) {
        double x = ldexp(at[i], -shift);
        if (!(fabs(x) < (double)most)) return 0;
        out[i] = (int32_t)lround(x);
    }
    return 1;
}

int sph_grid_light(const struct sph_grid *grid, struct sph_vec pos, int32_t out[3]) {
    double at[3], most = 0;
    sph_grid_real(grid, pos, at);
    for (int i = 0; i < 3; i++)
        most = fmax(most, fabs(at[i]));
    if (most < ldexp(1, grid->w)) { /* no word overflows */
        struct sph_ball ball = {.r = 0};
        sph_grid_point(grid, pos, ball.c);
        for (int i = 0; i < 3; i++)
            out[i] = ball.c[i];
        if (sph_grid_fits(grid, &ball)) return 0;
    }
    for (int shift = 1; shift <= LONGEST; shift++)
        if (word(at, grid->w, shift, out)) return shift;
    for (int i = 0; i < 3; i++) /* as if it were at the same side, but nearer: P is nothing there */
        out[i] = (int32_t)lround(ldexp(at[i] / most, grid->w - 1));
    return LONGEST;
}

int sph_light_sound(const struct sph_grid *grid, struct sph_vec pos, const struct sph_extent *e) {
    int32_t at[3];
    int shift = sph_grid_light(grid, pos, at), k = 0;
    double square = 0, round = ldexp(1, grid->w - 1 - shift) + 1;
    if (!shift) return 1;
    for (int i = 0; i < 3; i++) {
        double size = fabs((double)at[i]) + round;
        square += size * size;
        if (abs(at[i]) > abs(at[k])) k = i;
    }
    int64_t away = (int64_t)(at[k] > 0 ? e->lo[k] : e->hi[k]);
    int64_t end = away + at[k] - sph_round(away, shift);
    return (at[k] > 0 ? (double)end > e->hi[k] : (double)end < e->lo[k]) &&
           square + 2 * sqrt(square) * e->rad <= ldexp(1, 2 * grid->w + 2);
}

int sph_light_black(const struct sph_light *light) {
    int any = 0;
    for (int i = 0; i < 3; i++)
        any |= sph_u1_15(light->rgb[i]);
    return !any;
}

double sph_light_off(const struct sph_grid *grid, struct sph_vec pos) {
    int32_t at[3];
    int shift = sph_grid_light(grid, pos, at);
    /* half a unit of L and of round(P / 2^shift) along each axis */
    return shift ? sqrt(3) * ldexp(grid->step, shift) : sph_grid_off(grid, pos);
}
