/* facet.h - triangles and planes in double precision
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_FACET_H
#define SPH_REFERENCE_FACET_H

#include "reference/ray.h"
#include "scene/scene.h"
#include "scene/texture_base.h"

/* ---- on which side of an edge a ray passes, exactly ---- */

/* The sign of dir . ((p - org) x (q - org)), of these very doubles: -1, 0 or 1. Exchanging p and q
 * turns it over. */
int sph_ref_exact_side(const double org[3], const double dir[3], const double p[3],
                       const double q[3]);

/* Whether a facet has no end: no box holds it. */
int sph_ref_facet_unbounded(const struct sph_facet *facet);

/* The normal of a facet, of length 1 (a triangle of no area: not a number). */
void sph_ref_facet_normal(const struct sph_facet *facet, double normal[3]);

/* The normal at a point of a triangle that has normals, between those of the corners, of length 1
 * and on the side of the facet's own. 0 if there is none. */
int sph_ref_facet_smooth(const struct sph_facet *facet, const double at[3], double normal[3]);

/* Where the line of the ray meets the facet, from either side, edges included; t may be below 0.
 * 0: nowhere, for certain; *meet is not of use. */
int sph_ref_facet(const struct sph_facet *facet, const struct sph_ref_cast *cast,
                  struct sph_ref_meet *meet);

/* By how many radians the normal of a facet may be off, where the point is by so much. */
double sph_ref_facet_turn(const struct sph_facet *facet, double off);

/* Whether two facets lie in one plane: the corners of one, or what a plane has, in that of the
 * other, as far as their coordinates can tell. */
int sph_ref_facet_level(const struct sph_facet *a, const struct sph_facet *b);

/* How the image of a facet lies around the point v[0] + from: coordinates (t down), their gradients
 * in space, and what P_b is made of. */
void sph_ref_facet_image(const struct sph_facet *facet, const double from[3], double st[2],
                         double slope[2][3], struct sph_texture_shape *shape);

#endif
