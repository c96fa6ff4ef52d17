/* follow.h - what a ray of the double reference sees, and what the rays after it see
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_FOLLOW_H
#define SPH_REFERENCE_FOLLOW_H

#include "reference/ray.h"
#include "reference/reference.h"
#include "reference/tree.h"
#include "reference/world.h"
#include "scene/scene.h"

/* ---- how far a ray may be from that of exact arithmetic, from one surface to the next ---- */
/* Sets lift, off and turn of rays: of first order, as the bounds of ray.h. */

/* Of a ray of the eye. */
void sph_ref_drift_start(struct sph_ref_ray *ray);

/* Where the ray meets the hit at a point, on a surface with the unit normal side: lift and off of
 * what leaves from there, into *next. Returns by how much the normal there may be off, radians. */
double sph_ref_drift_hit(const struct sph_scene *scene, const struct sph_ref_ray *ray,
                         const struct sph_ref_hit *hit, const double at[3], const double side[3],
                         struct sph_ref_ray *next);

/* From that point, to a light at lamp. */
double sph_ref_drift_light(const double at[3], const double lamp[3], const double dir[3]);

/* The turn of the mirrored ray; of the refracted one, cosine: of dir and the normal, ratio: as
 * sph_ref_refract() has it. INFINITY: whether all is reflected is not certain. */
double sph_ref_drift_mirror(double turn, double normal);
double sph_ref_drift_refract(double turn, double normal, double cosine, double ratio);

/* ---- shares, refraction and highlights of the double reference ---- */
/* Whitted 1979; Aroxa 2014, Listing 3.1. Real numbers, vectors of length 1. */

/* Shares of a material, and of what leaves the surface. */
struct sph_ref_shares {
    double ka, kd, ks; /* ks: of the highlight */
    double own, kr, kt;
};

/* follow: 1 if rays may leave; reflect, refract: which. */
struct sph_ref_shares sph_ref_shares_of(const struct sph_material *material, int follow,
                                        int reflect, int refract);

/* All of kt goes the way of the mirror ray; whole: that gets all the light there is. */
void sph_ref_reflect_all(struct sph_ref_shares *shares, const struct sph_material *material,
                         int whole);

/* Snell's law by vectors: dir meets a surface with the normal on its side; ratio: index of that
 * side over that of the other. 0 if all is reflected. */
int sph_ref_refract(const double dir[3], const double normal[3], double ratio, double out[3]);

/* max(0, mirrored light . way back)^shine. */
double sph_ref_specular(const double normal[3], const double to_light[3], const double dir[3],
                        double shine);

struct sph_ref_job {
    const struct sph_scene *scene;
    const struct sph_reference_options *o;
    const struct sph_ref_tree *tree;
    struct sph_ref_view view;
    struct sph_ref_textures textures;
    const struct sph_ends *ends; /* planes beyond are met there, as a machine does; NULL: nowhere */
};

/* A ray on its way. */
struct sph_ref_branch {
    struct sph_ref_ray ray;
    struct sph_ref_path path;
    double weight;
    int depth, mirrored; /* it is a mirror ray */
    int via;             /* SPH_VIA_* */
};

enum { SPH_REF_STEPS = 16 }; /* of a pixel that are kept; the first ones */

/* A ray and what it met. */
struct sph_ref_step {
    struct sph_ref_ray ray;
    struct sph_ref_hit hit;
    int depth;
    double at[3], normal[3];               /* unless nothing is met, as all below */
    uint32_t faced, blocked;               /* as in sph_reference_pixel */
    struct sph_ref_hit by[SPH_MAX_LIGHTS]; /* what blocks light l, t as a part of the way to it */
    double swing[3]; /* of the pixel's colour, if the normal turned by a radian: at most */
};

/* The rays of a pixel, in the order in which they were followed. */
struct sph_ref_log {
    int n;
    struct sph_ref_step step[SPH_REF_STEPS];
};

struct sph_ref_seen {
    struct sph_reference_pixel pixel;
    struct sph_ref_log *log; /* may be NULL */
    struct sph_level_work *work;
    double sum[SPH_FRAMES][3]; /* as the frames of the machine: docs/design/shading.md */
};

/* Adds all that the ray sees to *seen. */
void sph_ref_follow(const struct sph_ref_job *j, struct sph_ref_branch b,
                    struct sph_ref_seen *seen);

/* What the primary ray of a pixel sees, into *seen, whose log and work are given. */
void sph_ref_sample_of(const struct sph_ref_job *j, int x, int y, struct sph_ref_seen *seen);

#endif
