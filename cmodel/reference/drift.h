/* drift.h - how far a ray may be from that of exact arithmetic, from one surface to the next
 * SPDX-License-Identifier: Apache-2.0
 *
 * Sets lift, off and turn of rays: of first order, as the bounds of ray.h.
 */
#ifndef SPH_REFERENCE_DRIFT_H
#define SPH_REFERENCE_DRIFT_H

#include "reference/ray.h"
#include "scene/scene.h"

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

#endif
