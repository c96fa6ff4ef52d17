/* drift.c - see drift.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/drift.h"

#include "reference/facet.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void sph_ref_drift_start(struct sph_ref_ray *ray) {
    ray->lift = ray->off = 0;
    ray->turn = 2 * SPH_REF_ULP; /* axes of the camera, distance of the screen, place on it */
}

double sph_ref_drift_hit(const struct sph_scene *scene, const struct sph_ref_ray *ray,
                         const struct sph_ref_hit *hit, const double at[3], const double side[3],
                         struct sph_ref_ray *next) {
    double length = sqrt(dot(ray->dir, ray->dir)), place = SPH_REF_ULP * 2 * sph_ref_size(at);
    double cosine = fmax(fabs(dot(ray->dir, side)) / length, 1e-8), along = hit->slack * length;
    next->lift = along * cosine + place;
    next->off = (ray->off + hit->t * length * ray->turn) / cosine + along + place;
    if (hit->id >= scene->n_spheres)
        return sph_ref_facet_turn(&scene->facets[hit->id - scene->n_spheres], next->off);
    return next->off / scene->spheres[hit->id].rad + 4 * SPH_REF_ULP;
}

double sph_ref_drift_light(const double at[3], const double lamp[3], const double dir[3]) {
    return 2 * SPH_REF_ULP * (sph_ref_size(at) + sph_ref_size(lamp)) / sph_ref_size(dir);
}

double sph_ref_drift_mirror(double turn, double normal) {
    return turn + 2 * normal + 2 * SPH_REF_ULP;
}

double sph_ref_drift_refract(double turn, double normal, double cosine, double ratio) {
    double rest = 1 - ratio * ratio * (1 - cosine * cosine), both = turn + normal;
    double unsure = 2 * ratio * ratio * fabs(cosine) * both + 8 * SPH_REF_ULP;
    if (fabs(rest) <= unsure) return INFINITY;
    if (rest < 0) return 0;
    double bend = ratio + ratio * ratio * fabs(cosine) / sqrt(rest); /* of the normal's share */
    return ratio * turn + bend * both + (ratio + 1) * normal + 2 * SPH_REF_ULP;
}
