/* spline.h - Kochanek-Bartels splines through keys at times of their own
 * SPDX-License-Identifier: Apache-2.0
 *
 * D. Kochanek, R. Bartels: Interpolating splines with local tension, continuity, and bias control,
 * SIGGRAPH 1984; tangents scaled for keys that are not equally far apart. The first and the last
 * key shape the curve and are not reached: before the second key it stays there, after the last
 * but one too. Times should not fall; where they do, the first piece that ends later counts.
 */
#ifndef SPH_SPLINE_H
#define SPH_SPLINE_H

#include "scene/affine.h"

#define SPH_SPLINE_MIN 4 /* the fewest keys */

struct sph_key {
    double time;
    struct sph_vec at; /* a point, three factors, or the axis of a turn */
    double degrees;    /* of a turn */
    double tension, continuity, bias;
};

/* The point of n >= SPH_SPLINE_MIN keys at a time. */
struct sph_vec sph_spline_point(const struct sph_key *key, uint32_t n, double time);

/* The same of turns, on the sphere of quaternions (squad); of the two quaternions of a turn a key
 * has the one that is nearer to the key before. -1 if memory is short. */
int sph_spline_turn(const struct sph_key *key, uint32_t n, double time, struct sph_turn *turn);

#endif
