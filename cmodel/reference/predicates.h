/* predicates.h - whether a ray meets a sphere, as four texts have it, each counting its arithmetic
 * SPDX-License-Identifier: Apache-2.0
 *
 * Real numbers: V the ray's origin, d its direction of any length, C and R the sphere's centre and
 * radius. R is stored, and so is R^2, where a text stores it. No text is paid for a root that only
 * finds the point: what is counted is the answer to "does it meet the sphere ahead of V?".
 *
 *   paper      Borodavka et al. VI.A, word by word: VC.d < 0 and R^2 < |VC|^2 is a miss; then
 *              (R^2 - |VC|^2) |d|^2 + (VC.d)^2 > 0, with |d|^2 made for each sphere
 *   machine    the same sum as the machine has it (prim/sphere.h): |d|^2 once a ray, no way out
 * early geometric  Glassner 1989, where the paper starts: d is normalised once a ray quadratic  the
 * discriminant of |V + t d - C|^2 = R^2, b^2 - 4ac, and the sign of its roots
 */
#ifndef SPH_PREDICATES_H
#define SPH_PREDICATES_H

#include "math/flops.h"

enum {
    SPH_PREDICATE_PAPER,
    SPH_PREDICATE_MACHINE,
    SPH_PREDICATE_GEOMETRIC,
    SPH_PREDICATE_QUADRATIC,
    SPH_PREDICATES
};

/* A ray as a predicate wants it. */
struct sph_predicate_ray {
    double org[3], dir[3]; /* geometric: of length 1 */
    double a;              /* |d|^2: machine and quadratic */
};

/* What is done once a ray. */
struct sph_predicate_ray sph_predicate_ray(int predicate, const double org[3], const double dir[3],
                                           struct sph_flops *work);

/* 1 if the ray meets the sphere ahead of its origin, which may lie inside. */
int sph_predicate(int predicate, const struct sph_predicate_ray *ray, const double ctr[3],
                  double rad, struct sph_flops *work);

#endif
