/* meet.h - where a ray of the double reference meets a primitive, and what lies in one place
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_MEET_H
#define SPH_REFERENCE_MEET_H

#include "reference/ray.h"
#include "scene/scene.h"

struct sph_ref_cast sph_ref_cast(const struct sph_ref_ray *ray);

/* Where the ray meets the primitive ahead of it: t > 0. 0: nowhere, for certain; *meet is not of
 * use. What the ray starts on is not met, nor what lies in one place with that; it is in doubt if
 * another surface passes there. */
int sph_ref_meet_ahead(const struct sph_scene *scene, uint32_t id, const struct sph_ref_cast *cast,
                       struct sph_ref_meet *meet);

/* Whether two primitives lie in one place: two spheres are the same, or two facets in one plane, as
 * far as their coordinates can tell. */
int sph_ref_coincide(const struct sph_scene *scene, uint32_t a, uint32_t b);

#endif
