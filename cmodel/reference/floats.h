/* floats.h - ray and primitive in floating point, as textbooks write it
 * SPDX-License-Identifier: Apache-2.0
 *
 * Of the machine's own integers, converted: what is wrong is the arithmetic. Compiled without
 * contraction: every operation rounds.
 *
 *   textbook  sphere: disc = b^2 - a*c, c = |oc|^2 - rad^2, t = (b -+ sqrt(disc)) / a; triangle:
 *             Moeller and Trumbore 1997; plane: n.(p - org) / n.dir
 *   paper     sphere: disc = k*a + b^2, k = rad^2 - |oc|^2 (Borodavka et al. VI.A); triangle: the
 *             volumes of docs/design/primitives.md
 *   Gems      Haines et al., Ray Tracing Gems ch. 7: disc = rad^2 - |f + (b/a)*dir|^2, f = -oc;
 *             q = b + sign(b)*sqrt(a*disc), roots c/q and q/a
 */
#ifndef SPH_REFERENCE_FLOATS_H
#define SPH_REFERENCE_FLOATS_H

#include "prim/facet.h"
#include "prim/sphere.h"

/* From 1 on: 0 is left to exact integers. */
enum { SPH_F32_TEXTBOOK = 1, SPH_F32_PAPER, SPH_F32_GEMS, SPH_F64_TEXTBOOK, SPH_FORMULAS };

/* Where a line meets a sphere. */
struct sph_float_roots {
    int real; /* else there are none */
    double near, far;
};

/* What counts on a ray. */
struct sph_floats {
    int hit, far; /* far: the second root; of a facet, its normal looks along the ray */
    double t;
};

/* Both roots, in order. Formulas of float32 round what they are given. */
struct sph_float_roots sph_float_roots(int formula, const double org[3], const double dir[3],
                                       const double ctr[3], double rad);

/* The first root between least and most. */
struct sph_floats sph_float_between(struct sph_float_roots roots, double least, double most);

/* A ray of a machine and a sphere: t > 0, below 1 if the ray ends at a light. Of the sphere that it
 * starts in the far root counts, and without ray->inside of any other the near one alone. */
struct sph_floats sph_float_sphere(int formula, const struct sph_ray *ray,
                                   const struct sph_leaf *sphere);

/* The same of a facet, of no formula of Gems. It knows nothing of where a ray starts, nor of the
 * end of planes. */
struct sph_floats sph_float_facet(int formula, const struct sph_ray *ray,
                                  const struct sph_facet_leaf *facet);

#endif
