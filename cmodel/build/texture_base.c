/* texture_base.c - see texture_base.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build/texture_base.h"

#include <math.h>

enum { MOST = 32767, ONE = 256 };

/* As printed: lengths in scene units, of which the result depends. */
static double literal(const struct sph_texture_area *area, const struct sph_texture_view *view) {
    double t_xn = area->share * area->texels;             /* step 1 */
    double x_pr = area->texels / view->pixels;            /* step 2 */
    double t_xs = t_xn * x_pr;                            /* step 3 */
    double t_size = area->size * view->step * view->step; /* step 4 */
    return 0.5 * log2(t_xs / t_size) - log2(view->step);  /* step 5; to grid units */
}

/* A pixel P away is (P / distance)^2 large, a texel size / (share * texels): equal at P = P_b. */
static double mended(const struct sph_texture_area *area, const struct sph_texture_view *view) {
    return 0.5 * log2(area->size / (area->share * area->texels)) + log2(view->distance);
}

double sph_texture_base_log2(const struct sph_texture_area *area,
                             const struct sph_texture_view *view) {
    if (!(area->share > 0)) return INFINITY;
    return view->literal ? literal(area, view) : mended(area, view);
}

int sph_texture_base(const struct sph_texture_area *area, const struct sph_texture_view *view) {
    double base = sph_texture_base_log2(area, view);
    return (int)lround(fmin(fmax(base * ONE, -MOST - 1), MOST));
}
