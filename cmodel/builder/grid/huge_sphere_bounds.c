/* huge_sphere_bounds.c - see huge_sphere_bounds.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/huge_sphere_bounds.h"

#include <math.h>

#include "builder/grid/grid.h"

void sph_box_add(struct sph_box *box, const double at[3], double rad) {
    for (int i = 0; i < 3; i++) {
        box->lo[i] = fmin(box->lo[i], at[i] - rad);
        box->hi[i] = fmax(box->hi[i], at[i] + rad);
    }
}

double sph_box_side(const struct sph_box *box) {
    double side = 0;
    for (int i = 0; i < 3; i++)
        side = fmax(side, box->hi[i] - box->lo[i]);
    return side;
}

uint32_t sph_huge_sphere_find(const struct sph_scene *scene) {
    uint32_t largest = 0;
    for (uint32_t i = 1; i < scene->n_spheres; i++)
        if (scene->spheres[i].rad > scene->spheres[largest].rad) largest = i;
    if (!scene->n_spheres) return 0;
    const struct sph_material *m = &scene->materials[scene->spheres[largest].material];
    return m->sum.on && m->trans > 0 ? scene->n_spheres : largest;
}

/* |p - c|^2 - r^2 at the corner of a box where it is largest. */
static double tangent(const double at[3], double rad, const struct sph_box *box) {
    double square = -rad * rad;
    for (int i = 0; i < 3; i++) {
        double most = fmax(fabs(box->lo[i] - at[i]), fabs(box->hi[i] - at[i]));
        square += most * most;
    }
    return square;
}

int sph_huge_sphere_cut(const double at[3], double rad, const struct sph_box *rest, int w,
                        struct sph_box *box) {
    double from_eye = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    double square = tangent(at, rad, rest), all = sph_box_side(box);
    double off = 2 * SPH_GRID_MARGIN * ldexp(2 * all, -w);
    if (!(from_eye - rad > off) || !isfinite(square)) return 0;
    double far = sqrt(square + 4 * off * (rad + sqrt(square)));
    struct sph_box cut = *rest;
    for (int i = 0; i < 3; i++) {
        cut.lo[i] = fmin(cut.lo[i], fmax(rest->lo[i] - far, at[i] - rad));
        cut.hi[i] = fmax(cut.hi[i], fmin(rest->hi[i] + far, at[i] + rad));
    }
    sph_box_add(&cut, at, 0);
    if (sph_box_side(&cut) >= all) return 0;
    *box = cut;
    return 1;
}
