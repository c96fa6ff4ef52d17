/* choose.c - see choose.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/choose.h"

double sph_choose_path(double length, double base, struct sph_flops *f) {
    return sph_f_sub(f, sph_f_log2(f, length), base);
}

static void sphere(const struct sph_choice *c, double length[2], struct sph_flops *f) {
    const double *n = c->from, pi = acos(-1.0);
    double flat = sph_f_root(f, sph_f_add(f, sph_f_mul(f, n[0], n[0]), sph_f_mul(f, n[2], n[2])));
    length[0] = sph_f_div(f, sph_f_mul(f, 2 * pi, flat), c->shape.st[0][0]);
    length[1] = sph_f_div(f, sph_f_mul(f, pi, c->shape.rad), c->shape.st[0][1]);
}

/* |dP/ds| and |dP/dt| are length[k] over what is returned. */
static double triangle(const struct sph_choice *c, double length[2], struct sph_flops *f) {
    double d[2][2], edge[2][3], along[2][3];
    sph_texture_edges(&c->shape, edge, d, f);
    for (int i = 0; i < 3; i++) {
        along[0][i] =
            sph_f_sub(f, sph_f_mul(f, d[1][1], edge[0][i]), sph_f_mul(f, d[0][1], edge[1][i]));
        along[1][i] =
            sph_f_sub(f, sph_f_mul(f, d[0][0], edge[1][i]), sph_f_mul(f, d[1][0], edge[0][i]));
    }
    for (int k = 0; k < 2; k++)
        length[k] = sph_f_root(f, sph_f_dot(f, along[k], along[k]));
    return fabs(sph_f_sub(f, sph_f_mul(f, d[0][0], d[1][1]), sph_f_mul(f, d[1][0], d[0][1])));
}

double sph_choose_bmrt(const struct sph_choice *c, const struct sph_texture_view *view,
                       struct sph_flops *f) {
    double length[2] = {c->shape.st[0][0], c->shape.st[0][1]}; /* plane */
    double most = 0;
    double wide = sph_f_mul(f, c->length, 1 / view->distance); /* the screen's is of the frame */
    if (c->shape.kind == SPH_SHAPE_TRIANGLE)
        wide = sph_f_mul(f, wide, triangle(c, length, f));
    else if (c->shape.kind == SPH_SHAPE_SPHERE)
        sphere(c, length, f);
    for (int k = 0; k < 2; k++)
        most = fmax(most, sph_f_div(f, sph_f_mul(f, wide, c->side[k]), length[k]));
    return sph_f_log2(f, most);
}

void sph_choose_all(const struct sph_choice *choice, const struct sph_texture_view *view,
                    struct sph_level_work *work, double *level) {
    struct sph_level_work scratch = {.hits = {0}};
    struct sph_flops before = {0}; /* of the frame, or of the scene */
    struct sph_level_work *w = work ? work : &scratch;
    int kind = choice->shape.kind;
    double texels = choice->side[0] * choice->side[1];
    w->hits[kind]++;
    for (int way = 0; way < SPH_WAYS; way++) {
        struct sph_flops *f = &w->flops[way][kind];
        struct sph_choice c = *choice;
        c.shape.given = way == SPH_WAY_BMRT || way == SPH_WAY_ANEW;
        if (way == SPH_WAY_BMRT || way == SPH_WAY_BMRT_ALONE) {
            level[way] = sph_choose_bmrt(&c, view, f);
            continue;
        }
        struct sph_flops *of_base = way == SPH_WAY_KEPT ? &before : f;
        struct sph_texture_area area = sph_texture_area_of(&c.shape, texels, of_base);
        level[way] = sph_choose_path(c.length, sph_texture_base_log2(&area, view, of_base), f);
    }
}

void sph_level_work_add(struct sph_level_work *to, const struct sph_level_work *more) {
    for (int kind = 0; kind < SPH_SHAPES; kind++) {
        to->hits[kind] += more->hits[kind];
        for (int way = 0; way < SPH_WAYS; way++)
            sph_flops_add(&to->flops[way][kind], &more->flops[way][kind]);
    }
}
