/* texture_base.c - see texture_base.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/texture_base.h"

#include <math.h>
#include <string.h>

enum { MOST = 32767, ONE = 256 };

void sph_texture_edges(const struct sph_texture_shape *s, double edge[2][3], double d[2][2],
                       struct sph_flops *f) {
    for (int k = 0; k < 2; k++) {
        sph_f_minus(f, 2, s->st[k + 1], s->st[0], d[k]);
        if (s->given)
            memcpy(edge[k], s->edge[k], sizeof edge[k]);
        else
            sph_f_minus(f, 3, s->corner[k + 1], s->corner[0], edge[k]);
    }
}

/* Steps 1 and 4 of the paper. */
static void triangle(const struct sph_texture_shape *s, struct sph_texture_area *area,
                     struct sph_flops *f) {
    double d[2][2], edge[2][3], n[3];
    sph_texture_edges(s, edge, d, f);
    double twice = sph_f_sub(f, sph_f_mul(f, d[0][0], d[1][1]), sph_f_mul(f, d[1][0], d[0][1]));
    area->share = sph_f_mul(f, 0.5, fabs(twice));
    if (s->given)
        memcpy(n, s->normal, sizeof n);
    else
        sph_f_cross(f, edge[0], edge[1], n);
    area->size = sph_f_mul(f, 0.5, sph_f_root(f, sph_f_dot(f, n, n)));
}

struct sph_texture_area sph_texture_area_of(const struct sph_texture_shape *s, double texels,
                                            struct sph_flops *f) {
    struct sph_texture_area area = {0, 1, texels};
    if (s->kind == SPH_SHAPE_TRIANGLE) {
        triangle(s, &area, f);
    } else if (s->kind == SPH_SHAPE_PLANE) {
        area.size = sph_f_mul(f, s->st[0][0], s->st[0][1]);
    } else {
        area.size = sph_f_mul(f, sph_f_mul(f, 4 * acos(-1.0), s->rad), s->rad);
        area.share = sph_f_mul(f, s->st[0][0], s->st[0][1]);
    }
    return area;
}

/* As printed: lengths in scene units, of which the result depends. */
static double literal(const struct sph_texture_area *area, const struct sph_texture_view *view,
                      struct sph_flops *f) {
    double t_xn = sph_f_mul(f, area->share, area->texels);             /* step 1 */
    double x_pr = area->texels / view->pixels;                         /* step 2, of the image */
    double t_xs = sph_f_mul(f, t_xn, x_pr);                            /* step 3 */
    double t_size = sph_f_mul(f, area->size, view->step * view->step); /* step 4 */
    double half = sph_f_mul(f, 0.5, sph_f_log2(f, sph_f_div(f, t_xs, t_size))); /* step 5 */
    return sph_f_sub(f, half, log2(view->step));                                /* to grid units */
}

/* A pixel P away is (P / distance)^2 large, a texel size / (share * texels): equal at P = P_b. */
static double mended(const struct sph_texture_area *area, const struct sph_texture_view *view,
                     struct sph_flops *f) {
    double texels = sph_f_mul(f, area->share, area->texels);
    double half = sph_f_mul(f, 0.5, sph_f_log2(f, sph_f_div(f, area->size, texels)));
    return sph_f_add(f, half, log2(view->distance));
}

double sph_texture_base_log2(const struct sph_texture_area *area,
                             const struct sph_texture_view *view, struct sph_flops *flops) {
    if (!(area->share > 0)) return INFINITY;
    return view->literal ? literal(area, view, flops) : mended(area, view, flops);
}

int sph_texture_base(const struct sph_texture_area *area, const struct sph_texture_view *view,
                     struct sph_flops *flops) {
    double base = sph_texture_base_log2(area, view, flops);
    return (int)lround(fmin(fmax(base * ONE, -MOST - 1), MOST));
}
