/* whitted.h - shares, refraction and highlights of the double reference
 * SPDX-License-Identifier: Apache-2.0
 *
 * Whitted 1979; Aroxa 2014, Listing 3.1. Real numbers, vectors of length 1.
 */
#ifndef SPH_REFERENCE_WHITTED_H
#define SPH_REFERENCE_WHITTED_H

#include "scene/scene.h"

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
double sph_ref_shine(const double normal[3], const double to_light[3], const double dir[3],
                     double shine);

#endif
