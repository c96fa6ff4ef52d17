/* ray_error.h - how far rays may be from where they should be, under one profile
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RAY_ERROR_H
#define SPH_RAY_ERROR_H

#include "builder/grid/grid.h"
#include "reference/follow.h"

/* A profile and what it makes of a scene. */
struct sph_ray_error {
    const struct sph_scene *scene;
    const struct sph_ref_tree *tree;
    const struct sph_profile *profile;
    struct sph_grid grid;
    double fov_error; /* of the rays, and of where the eye is put: relative */
};

/* Of one ray of a pixel, in units of the scene and radians: at most. */
struct sph_ray_errors {
    double across; /* of what the ray meets, across it */
    double at;     /* of the point from which rays go on */
    double turn;   /* of these rays, but those to lights */
    double normal; /* of the normal, or the light, against that of the moved surface */
};

/* How far primary rays are turned by the roundings of their directions, at most: radians. */
double sph_ray_error_dir(const struct sph_ray_error *w);

/* Of every ray of a log. */
void sph_ray_error_log(const struct sph_ray_error *w, const struct sph_ref_log *log,
                       struct sph_ray_errors out[SPH_REF_STEPS]);

/* Where the grid ends rays; and whether it ends one of a log before the plane that it meets. */
struct sph_ends sph_ray_error_ends(const struct sph_ray_error *w);
int sph_ray_error_ended(const struct sph_ray_error *w, const struct sph_ref_log *log);

/* How far a surface is moved, at most: by what the grid does to just this one; by what it may do to
 * any of its kind. */
double sph_ray_error_surface(const struct sph_ray_error *w, uint32_t id);
double sph_ray_error_worst(const struct sph_ray_error *w, uint32_t id);

/* How far the ray of a step went. */
double sph_ray_error_distance(const struct sph_ref_step *s);

/* Distance between two rays of neighbouring pixels so far from their origins. */
double sph_ray_error_width(const struct sph_ref_ray *a, const struct sph_ref_ray *b,
                           double distance);

/* The part of pixels on the wrong side of the edge between two rays that meet different things at
 * this step; and of a shadow's edge of light l between two that meet the same. */
double sph_ray_error_edge(const struct sph_ray_error *w, const struct sph_ref_step *a,
                          const struct sph_ref_step *b, const struct sph_ray_errors *of_a,
                          const struct sph_ray_errors *of_b);
double sph_ray_error_shadow(const struct sph_ray_error *w, const struct sph_ref_step *a,
                            const struct sph_ref_step *b, const struct sph_ray_errors *of, int l);

#endif
